#include "apps/grading/isolation.h"

#include "apps/command/limited_run.h"
#include "gw/error.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int first_user = 61000;

void append(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}

std::string user_of(int slot) { return std::to_string(first_user + slot); }

/// Ends with this process. As root it becomes another user: limits do not bind root.
Words as_somebody(int slot) {
    Words words{"setpriv", "--pdeathsig", "KILL", "--no-new-privs"};
    if (::geteuid() == 0)
        append(words, {"--reuid", user_of(slot), "--regid", user_of(slot), "--clear-groups",
                       "--bounding-set=-all"});
    return words;
}

Words limits_of(const Allowance& allowance) {
    return {"prlimit",
            "--core=0",
            "--nofile=256",
            fmt::format("--cpu={}:{}", allowance.seconds, allowance.seconds + 2),
            "--data=" + std::to_string(allowance.memory),
            "--fsize=" + std::to_string(allowance.disk),
            "--nproc=" + std::to_string(allowance.processes)};
}

std::string path_of(const Allowance& allowance) {
    std::string path;
    for (const fs::path& folder : allowance.tools) path += (folder / "bin").string() + ":";
    return path + "/usr/local/bin:/usr/bin:/bin";
}

/// Copies the files from $3 to $4, since programs write beside themselves.
Words script_of(const Confined& confined, const std::string& polygons, const std::string& from,
                const std::string& to) {
    return {"sh",
            "-c",
            "mkdir -p \"$4\" && cp -R \"$3\"/. \"$4\" && cd \"$4\" || exit 126\n" + confined.script,
            "sh",
            confined.file,
            polygons,
            from,
            to};
}

/// The system's programs and libraries, and no other file.
Words system_files() {
    Words words{"--ro-bind", "/usr", "/usr"};
    for (const char* name : {"/bin", "/sbin", "/lib", "/lib32", "/lib64"}) {
        std::error_code ignored;
        if (fs::is_symlink(name, ignored))
            append(words, {"--symlink", fs::read_symlink(name, ignored).string(), name});
        else
            append(words, {"--ro-bind-try", name, name});
    }
    for (const char* name : {"/etc/alternatives", "/etc/ld.so.cache", "/etc/java-11-openjdk",
                             "/etc/java-17-openjdk", "/etc/java-21-openjdk"})
        append(words, {"--ro-bind-try", name, name});
    return words;
}

/// An installed gw knows the answers: its command, its Python package and its scenes are not there.
Words without_gw() {
    const fs::path prefix = fs::canonical("/proc/self/exe").parent_path().parent_path();
    Words words;
    for (const fs::path& installed : {fs::path("/usr"), fs::path("/usr/local"), prefix}) {
        if (!installed.string().starts_with("/usr")) continue;
        for (const char* folder : {"share/gw", "share/doc/gw", "lib/python3/dist-packages/gw"})
            if (fs::is_directory(installed / folder))
                append(words, {"--size", "4096", "--tmpfs", (installed / folder).string()});
        if (fs::exists(installed / "bin/gw"))
            append(words, {"--ro-bind", "/dev/null", (installed / "bin/gw").string()});
    }
    return words;
}

Words namespaces_of(const Allowance& allowance) {
    Words words{"bwrap",         "--unshare-user",    "--unshare-all", "--disable-userns",
                "--new-session", "--die-with-parent", "--clearenv",    "--setenv",
                "PATH",          path_of(allowance),  "--setenv",      "HOME",
                "/tmp",          "--setenv",          "LANG",          "C.UTF-8"};
    append(words, system_files());
    append(words, without_gw());
    const std::string size = std::to_string(allowance.disk);
    append(words, {"--proc", "/proc", "--dev", "/dev", "--size", size, "--tmpfs", "/tmp", "--size",
                   size, "--tmpfs", "/dev/shm"});
    for (const fs::path& folder : allowance.tools)
        append(words, {"--ro-bind", folder.string(), folder.string()});
    return words;
}

/// The last line that a program printed on stderr.
std::string last_line(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return scene::printable(text.substr(text.rfind('\n') + 1), 200);
}

[[noreturn]] void refuse(const std::string& what) {
    throw Error(what +
                "; expected namespaces for users, or --isolation limits in a container that holds "
                "one submission only (docs/exercises.md)");
}

}  // namespace

std::vector<std::string> confined_words(const Allowance& allowance, const Confined& confined) {
    Words words = as_somebody(confined.slot);
    if (allowance.isolation == Isolation::Limits) {
        append(words, limits_of(allowance));
        append(words, {"env", "-i", "PATH=" + path_of(allowance), "LANG=C.UTF-8",
                       "HOME=" + confined.work.string(), "TMPDIR=" + confined.work.string()});
        append(words, script_of(confined, confined.polygons.string(), confined.submission.string(),
                                (confined.work / "work").string()));
        return words;
    }
    append(words, namespaces_of(allowance));
    append(words, {"--ro-bind", confined.submission.string(), "/submission", "--ro-bind",
                   confined.polygons.string(), "/polygons.json", "--remount-ro", "/dev",
                   "--remount-ro", "/"});
    append(words, limits_of(allowance));
    append(words, script_of(confined, "/polygons.json", "/submission", "/tmp/work"));
    return words;
}

bool has_program(const Allowance& allowance, const std::string& name) {
    std::istringstream path(path_of(allowance));
    for (std::string folder; std::getline(path, folder, ':');)
        if (::access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
    return false;
}

void end_leftovers(const Allowance& allowance, int slot) {
    if (allowance.isolation == Isolation::Namespaces || ::geteuid() != 0) return;
    run_limited({"setpriv", "--reuid", user_of(slot), "--regid", user_of(slot), "--clear-groups",
                 "sh", "-c", "kill -9 -1"},
                {.seconds = 10, .memory = 0});
}

void check_isolation(const Allowance& allowance) {
    for (const fs::path& folder : allowance.tools)
        if (!fs::is_directory(folder))
            throw Error(folder.string() + ": is no folder; expected one with bin/ in it");
    if (allowance.isolation == Isolation::Limits) {
        if (::geteuid() != 0)
            throw Error("--isolation limits needs root: a student's program runs as another user");
        return;
    }
    const RunLimits limits{.seconds = 30, .memory = 0};
    if (run_limited({"sh", "-c", "command -v bwrap"}, limits).code != 0)
        throw Error(
            "bwrap: no such program; expected bubblewrap: sudo apt install bubblewrap, or "
            "scripts/setup");
    Words words = as_somebody(0);
    append(words, namespaces_of(allowance));
    append(words, {"true"});
    const LimitedRun run = run_limited(words, limits);
    if (run.end != RunEnd::Exited || run.code != 0)
        refuse("bwrap cannot isolate a program here: " + last_line(run.err));
}

}  // namespace gw::apps
