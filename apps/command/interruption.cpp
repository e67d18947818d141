#include "apps/command/interruption.h"

#include <unistd.h>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

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

}  // namespace gw::apps
