#include "apps/command/early_end.h"

#include "image/output/temporaries.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace gw::apps {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

// Plain memory, because a signal handler may touch nothing more. The two texts alternate, so that
// one is complete at any time.
std::array<std::array<char, 501>, 2> texts{};
std::atomic<std::size_t> current{0};
std::array<struct sigaction, signals.size()> before{};

extern "C" void say_and_pass_on(int signal) {
    const char* text = texts[current.load()].data();
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (signals[i] == signal) ::sigaction(signal, &before[i], nullptr);
    ::raise(signal);  // delivered on return
}

/// An exception that leaves a library's noexcept function, inlined into ours, is not the current
/// one. Only its existence is known. Missing memory is the one cause that tests find.
bool is_out_of_memory() {
    const std::exception_ptr exception = std::current_exception();
    if (!exception) return std::uncaught_exceptions() > 0;
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

[[noreturn]] void end() {
    image::remove_temporaries();
    if (!is_out_of_memory()) std::abort();
    constexpr std::string_view text = "gw: out of memory\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    std::_Exit(1);
}

}  // namespace

Interruption::Interruption() {
    say("");
    for (std::size_t i = 0; i < signals.size(); ++i) {
        ::sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = say_and_pass_on;
        ::sigaction(signals[i], &action, nullptr);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before[i], nullptr);
}

void Interruption::say(const std::string& text) {
    const std::size_t next = 1 - current.load();
    std::strncpy(texts[next].data(), text.c_str(), texts[next].size() - 1);
    current.store(next);
}

void end_clearly_on_terminate() { std::set_terminate(end); }

}  // namespace gw::apps
