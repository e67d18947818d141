#include "image/output/temporaries.h"

#include "gw/error.h"

#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

namespace gw::image {
namespace {

// Plain pointers, because a signal handler may touch nothing more.
std::array<std::atomic<char*>, 256> names{};
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
    for (auto remove : {::unlink, ::rmdir}) {  // each leaves what the other is for
        for (const std::atomic<char*>& name : names) {
            if (const char* path = name.load()) remove(path);
        }
    }
    for (const std::atomic<char*>& tree : trees) {
        if (const char* path = tree.load()) remove_tree(path);
    }
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
        if (file == nullptr || name != file) continue;
        slot.store(nullptr);
        std::free(file);
        return;
    }
}

}  // namespace

void register_temporary(const std::filesystem::path& name) { add_to(names, name); }
void register_temporary_tree(const std::filesystem::path& name) { add_to(trees, name); }

void forget_temporary(const std::filesystem::path& name) {
    take_from(names, name);
    take_from(trees, name);
}

void remove_temporaries_on_signals() {
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal);
    ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace gw::image
