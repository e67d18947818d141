#include "image/output/temporaries.h"

#include "gw/error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace gw::image {
namespace {

// Plain pointers, because a signal handler may touch nothing more.
std::array<std::atomic<char*>, 1024> names{};
std::array<std::atomic<char*>, 8> trees{};

// By rm, because reading a folder is more than a signal handler may do; _Fork, because fork runs
// handlers of its own.
void remove_tree(const char* path) {
    const pid_t child = ::_Fork();
    if (child == 0) {
        ::execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
        ::_exit(127);
    }
    if (child > 0) ::waitpid(child, nullptr, 0);
}

extern "C" void remove_and_die(int signal) {
    remove_temporaries();
    // The handler was installed for one call: this one is delivered to the default action on
    // return.
    ::raise(signal);
}

void handle(int signal) {
    struct sigaction old {};
    ::sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) return;
    struct sigaction action {};
    action.sa_handler = remove_and_die;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
}

void add_to(std::span<std::atomic<char*>> slots, const std::filesystem::path& name) {
    char* copy = ::strdup(name.c_str());
    for (std::atomic<char*>& slot : slots) {
        char* free_slot = nullptr;
        if (slot.compare_exchange_strong(free_slot, copy)) return;
    }
    std::free(copy);
    throw Error(name.string(), 0,
                "too many files are being written; expected at most " +
                    std::to_string(slots.size()) + " at a time");
}

void take_from(std::span<std::atomic<char*>> slots, const std::filesystem::path& name) {
    for (std::atomic<char*>& slot : slots) {
        char* file = slot.load();
        if (file == nullptr || name.native() != file) continue;  // needs no memory
        slot.store(nullptr);
        std::free(file);
        return;
    }
}

/// The process that made ".gw-PID-N.tmp" or ".gw-PID-folder-N.tmp"; 0: not such a name.
pid_t process_of(const std::string& name) {
    int pid = 0, number = 0, end = 0;
    for (const char* form : {".gw-%9d-%9d.tmp%n", ".gw-%9d-folder-%9d.tmp%n"}) {
        end = 0;
        if (std::sscanf(name.c_str(), form, &pid, &number, &end) == 2 && end == int(name.size()))
            return pid;
    }
    return 0;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

/// Ours to remove, and locked by nobody: a process of another container has a number of its own.
bool is_stale(const std::filesystem::path& name) {
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return false;
    struct stat status {};
    const bool stale = ::fstat(descriptor, &status) == 0 && status.st_uid == ::geteuid() &&
                       ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    ::close(descriptor);
    return stale;
}

/// Whether this is the first call for the folder.
bool is_first_visit(const std::filesystem::path& folder) {
    static std::mutex mutex;
    static std::set<std::filesystem::path> visited;
    const std::scoped_lock lock(mutex);
    return visited.insert(folder).second;
}

}  // namespace

void remove_stale_temporaries(const std::filesystem::path& folder) {
    std::error_code error;
    if (!is_first_visit(std::filesystem::absolute(folder, error))) return;
    std::vector<std::filesystem::path> stale;
    try {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            const pid_t process = process_of(entry.path().filename().string());
            if (process > 0 && is_gone(process) && is_stale(entry.path()))
                stale.push_back(entry.path());
        }
    } catch (const std::filesystem::filesystem_error&) {
        // Who may not list a folder may still write into it.
    }
    for (const std::filesystem::path& name : stale) std::filesystem::remove_all(name, error);
}

void register_temporary(const std::filesystem::path& name) { add_to(names, name); }
void register_temporary_tree(const std::filesystem::path& name) { add_to(trees, name); }

void forget_temporary(const std::filesystem::path& name) {
    take_from(names, name);
    take_from(trees, name);
}

void remove_temporaries() {
    for (auto remove : {::unlink, ::rmdir}) {  // one for files, one for folders
        for (const std::atomic<char*>& name : names) {
            if (const char* path = name.load()) remove(path);
        }
    }
    for (const std::atomic<char*>& tree : trees) {
        if (const char* path = tree.load()) remove_tree(path);
    }
}

void remove_temporaries_on_signals() {
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal);
    ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace gw::image
