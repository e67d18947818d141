#include "scene/text/text_file.h"

#include "gw/error.h"
#include "scene/text/encoding.h"
#include "scene/text/statements.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

namespace gw::scene {

namespace fs = std::filesystem;

namespace {

/// The system takes a name to end there.
bool has_nul(const fs::path& path) { return path.native().find('\0') != std::string::npos; }

// The entry of `folder` whose name differs at most by case. The first in byte order, since folders
// have none.
fs::path entry_without_case(const fs::path& folder, const std::string& name) {
    std::error_code error;
    fs::path found;
    for (fs::directory_iterator i(folder.empty() ? "." : folder, error), end; !error && i != end;
         i.increment(error)) {
        const fs::path entry = i->path().filename();
        if (lower(entry.string()) == lower(name) && (found.empty() || entry < found)) found = entry;
    }
    return found.empty() ? fs::path() : folder / found;
}

fs::path path_without_case(const fs::path& folder, const fs::path& name) {
    fs::path found = folder;
    for (const fs::path& part : name) {
        const bool as_written =
            part == "." || part == ".." || part.is_absolute() || file_exists(found / part);
        found = as_written ? found / part : entry_without_case(found, part.string());
        if (found.empty()) return found;
    }
    return found;
}

void check_size(const fs::path& path, std::size_t size) {
    if (size > most_text)
        throw Error(path.string(), 0,
                    "has more than " + std::to_string(most_text >> 20) + " MB; expected less");
}

// `expected` is the size from the file system: the file may grow meanwhile, and files of the system
// claim 0.
std::string contents(std::FILE* in, const fs::path& path, std::size_t expected) {
    check_size(path, expected);
    std::string text(expected + 1, '\0');
    std::size_t size = 0;
    for (std::size_t got = 1; got > 0; size += got) {
        check_size(path, size);
        if (size == text.size()) text.resize(2 * size);
        got = std::fread(text.data() + size, 1, text.size() - size, in);
    }
    text.resize(size);
    return text;
}

}  // namespace

bool file_exists(const fs::path& path) {
    std::error_code ignored;
    return !has_nul(path) && fs::exists(path, ignored);
}

// A device has no end, and a pipe may have no writer: a scene must not be able to name them.
std::string file_fault(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (has_nul(path) || status.type() == fs::file_type::not_found) return std::string(not_there);
    if (fs::is_directory(status)) return "is a directory";
    if (fs::exists(status) && !fs::is_regular_file(status)) return "is a device or a pipe";
    if (::access(path.c_str(), R_OK) == 0) return {};
    return std::string("cannot be opened: ") + std::strerror(errno);
}

std::string read_bytes(const fs::path& path) {
    if (const std::string fault = file_fault(path); fault.starts_with("is "))
        throw Error(path.string(), 0, fault + "; expected a file");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
    if (!in)
        throw Error(path.string(), 0,
                    std::string("cannot be opened: ") + std::strerror(errno) +
                        "; expected a readable file");
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    std::string text = contents(in.get(), path, error ? 0xffff : std::size_t(size));
    if (std::ferror(in.get()))
        throw Error(path.string(), 0, "cannot be read to its end; expected a readable file");
    return text;
}

std::string read_text(const fs::path& path) {
    std::string text = read_bytes(path);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw Error(path.string(), 1, "is UTF-16; expected UTF-8 text");
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (text.find('\n') == text.npos) std::ranges::replace(text, '\r', '\n');
    return text;
}

fs::path named_path(const fs::path& folder, std::string_view name) {
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    std::string slashed(name);
    std::ranges::replace(slashed, '\\', '/');
    return (folder / slashed).lexically_normal();
}

std::optional<fs::path> existing_file(const fs::path& folder, std::string_view name) {
    const fs::path as_written = named_path(folder, name), relative = named_path({}, name);
    if (file_exists(as_written)) return as_written;
    std::vector<fs::path> spellings{relative};
    if (const auto bytes = shift_jis_name(relative.string())) spellings.emplace_back(*bytes);
    for (const fs::path& spelling : spellings) {
        const fs::path found = path_without_case(folder, spelling);
        if (!found.empty() && file_exists(found)) return found.lexically_normal();
    }
    return std::nullopt;
}

fs::path find_file(const fs::path& folder, std::string_view name) {
    if (const auto found = existing_file(folder, name)) return *found;
    const fs::path as_written = named_path(folder, name);
    return existing_file(folder, as_written.filename().string()).value_or(as_written);
}

}  // namespace gw::scene
