#include "apps/grading/submission.h"

#include "apps/command/terminal.h"
#include "gw/error.h"
#include "inspect/recording/content.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;

struct Language {
    const char* extension;
    const char* program;  ///< that the computer must have
    const char* script;
};
constexpr Language languages[] = {
    {".py", "python3", "exec python3 \"$1\" \"$2\""},
    {".js", "node", "exec node \"$1\" \"$2\""},
    {".mjs", "node", "exec node \"$1\" \"$2\""},
    {".c", "cc", "cc -O2 -o program \"$1\" -lm && exec ./program \"$2\""},
    {".cpp", "c++", "c++ -std=c++20 -O2 -o program \"$1\" && exec ./program \"$2\""},
    {".cc", "c++", "c++ -std=c++20 -O2 -o program \"$1\" && exec ./program \"$2\""},
    {".rs", "rustc", "rustc -O -o program \"$1\" && exec ./program \"$2\""},
    {".go", "go", "GOCACHE=$PWD/cache exec go run \"$1\" \"$2\""},
    {".java", "java", "exec java \"$1\" \"$2\""},
    {".jl", "julia", "exec julia \"$1\" \"$2\""},
    {".R", "Rscript", "exec Rscript \"$1\" \"$2\""},
    {".rb", "ruby", "exec ruby \"$1\" \"$2\""},
    {".pl", "perl", "exec perl \"$1\" \"$2\""},
    {".lua", "lua", "exec lua \"$1\" \"$2\""},
    {".php", "php", "exec php \"$1\" \"$2\""},
    {".sh", "sh", "exec sh \"$1\" \"$2\""},
    {".jsonl", "cat", "exec cat \"$1\""},  // the answer itself
};
constexpr const char* run_script = "chmod u+x run && exec ./run \"$2\"";

const Language* language_of(const fs::path& file) {
    for (const Language& language : languages)
        if (file.extension() == language.extension) return &language;
    return nullptr;
}

std::string extensions() {
    std::string text;
    for (const Language& language : languages) text += std::string(" ") + language.extension;
    return text;
}

/// Without following a link. False if it is larger than `most`, or cannot be read.
bool copy_file(const fs::path& from, const fs::path& to, std::size_t& most) {
    const int file = ::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return false;
    std::ofstream out(to, std::ios::binary);
    std::array<char, 65536> bytes;
    ssize_t got = 0;
    bool fits = true;
    while (fits && (got = ::read(file, bytes.data(), bytes.size())) > 0) {
        fits = std::size_t(got) <= most;
        most -= fits ? std::size_t(got) : 0;
        out.write(bytes.data(), got);
    }
    ::close(file);
    return fits && got == 0 && bool(out);
}

constexpr int most_files = 10000;

/// The fault; "" if all were copied.
std::string copy_folder(const fs::path& from, const fs::path& to, std::size_t most) {
    std::error_code error;
    const std::size_t all = most;
    int files = 0;
    for (fs::recursive_directory_iterator at(from, error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().filename().string().front() == '.') {  // .git, .DS_Store
            at.disable_recursion_pending();
            continue;
        }
        const fs::path target = to / at->path().lexically_relative(from);
        const fs::file_status status = at->symlink_status(error);
        if (error || ++files > most_files)
            return fmt::format("more than {} files; expected a program", most_files);
        if (fs::is_directory(status)) {
            fs::create_directory(target, error);
            fs::permissions(target, fs::perms(0755), error);
        } else if (fs::is_regular_file(status)) {
            if (!copy_file(at->path(), target, most))
                return fmt::format("its files are larger than {} bytes, or cannot be read", all);
            const bool runs = (status.permissions() & fs::perms(0111)) != fs::perms::none;
            fs::permissions(target, fs::perms(runs ? 0755 : 0644), error);
        }
    }
    return error ? "its files cannot be read: " + error.message() : "";
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().front() != '.') entries.push_back(entry.path());
    std::ranges::sort(entries);
    return entries;
}

/// The program of a folder: "run", the only program file, or the only one that is called main.
WayToRun way_to_run(const fs::path& folder) {
    std::vector<fs::path> programs, named_main, answers;
    for (const fs::path& path : entries_of(folder)) {
        if (!fs::is_regular_file(path)) continue;
        if (path.filename() == "run") return {run_script, "run", "", ""};
        if (language_of(path) == nullptr) continue;
        (path.extension() == ".jsonl" ? answers : programs).push_back(path);
        const std::string stem = path.stem();
        if (stem == "main" || stem == "Main") named_main.push_back(path);
    }
    for (const auto& found : {named_main, programs, answers})
        if (found.size() == 1) {
            const Language& language = *language_of(found[0]);
            return {language.script, "./" + found[0].filename().string(), language.program, ""};
        }
    return {"", "", "",
            fmt::format("{}; expected a file run, one called main, or one of{}",
                        programs.empty() ? "has no program"
                                         : fmt::format("has {} programs", programs.size()),
                        extensions())};
}

/// An archive often has one folder at its top.
void lift_only_folder(const fs::path& folder) {
    const std::vector<fs::path> entries = entries_of(folder);
    if (entries.size() != 1 || !fs::is_directory(entries[0])) return;
    const fs::path aside = folder.string() + ".lifted";
    fs::rename(entries[0], aside);
    fs::remove_all(folder);
    fs::rename(aside, folder);
}

}  // namespace

std::vector<Submission> submissions_in(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw Error(folder.string() +
                    ": is no folder; expected one with a folder or a program for each student");
    std::map<std::string, fs::path> found;
    for (const fs::path& path : entries_of(folder)) {
        const bool is_folder = fs::is_directory(fs::symlink_status(path));
        if (!is_folder && language_of(path) == nullptr && !fs::is_symlink(path)) {
            print_warning(path.string() + ": is no submission; expected a folder, or one of" +
                          extensions());
            continue;
        }
        const std::string name = is_folder ? path.filename() : path.stem();
        const auto [other, is_new] = found.emplace(name, path);
        if (!is_new)
            throw Error(
                fmt::format("{}: has the name of {}; expected one submission of each student",
                            path.string(), other->second.string()));
    }
    if (found.empty())
        throw Error(folder.string() +
                    ": has no submission; expected a folder or a program for each student");
    std::vector<Submission> all;
    for (const auto& [name, path] : found) all.push_back({name, path});
    return all;
}

WayToRun copied(const Submission& submission, const fs::path& to, std::size_t most,
                const std::string& command) {
    const fs::file_status status = fs::symlink_status(submission.path);
    std::string fault;
    if (fs::is_directory(status))
        fault = copy_folder(submission.path, to, most);
    else if (!fs::is_regular_file(status))
        fault = "is a link or a device; expected a folder or a program";
    else if (!copy_file(submission.path, to / submission.path.filename(), most))
        fault = fmt::format("is larger than {} bytes, or cannot be read", most);
    if (!fault.empty()) return {"", "", "", fault};
    lift_only_folder(to);
    if (command.empty()) return way_to_run(to);
    // $1 of the teacher's command is the file of the polygons.
    return {"shift; " + command, "", "", ""};
}

std::string content_of(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::uint8_t> bytes;
    for (const fs::path& file : files) {
        const std::string name = file.lexically_relative(folder).string();
        bytes.insert(bytes.end(), name.begin(), name.end());
        bytes.push_back(0);
        std::ifstream in(file, std::ios::binary);
        std::vector<std::uint8_t> content{std::istreambuf_iterator<char>(in), {}};
        const std::string size = std::to_string(content.size());
        bytes.insert(bytes.end(), size.begin(), size.end());
        bytes.push_back(0);
        bytes.insert(bytes.end(), content.begin(), content.end());
    }
    return to_string(inspect::digest_of_bytes(bytes));
}

}  // namespace gw::apps
