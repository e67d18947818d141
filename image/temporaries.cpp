#include "image/temporaries.h"

#include "gw/error.h"

#include <unistd.h>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace gw::image {

namespace {

// Plain pointers, because a signal handler may touch nothing more.
std::array<std::atomic<char*>, 256> names{};

extern "C" void remove_and_die(int signal) {
    for (auto remove : {::unlink, ::rmdir}) {  // each leaves what the other is for
        for (const std::atomic<char*>& name : names) {
            if (const char* path = name.load()) remove(path);
        }
    }
    // The handler was installed for one call: this one is delivered to the default action on return.
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

}  // namespace

void register_temporary(const std::filesystem::path& name) {
    char* copy = ::strdup(name.c_str());
    for (std::atomic<char*>& slot : names) {
        char* free_slot = nullptr;
        if (slot.compare_exchange_strong(free_slot, copy)) return;
    }
    std::free(copy);
    throw Error(name.string(), 0, "too many files are being written; expected at most 256 at a time");
}

void forget_temporary(const std::filesystem::path& name) {
    for (std::atomic<char*>& slot : names) {
        char* file = slot.load();
        if (file == nullptr || name != file) continue;
        slot.store(nullptr);
        std::free(file);
        return;
    }
}

void remove_temporaries_on_signals() {
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal);
    ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace gw::image
