#include "apps/programs/program.h"

#include "gw/error.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

namespace gw::apps {
namespace {

constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP};
std::atomic<pid_t> running_program{0};

/// The terminal sends Ctrl-C to the program too; what a process sends is meant for both.
extern "C" void pass_on(int signal, siginfo_t* info, void*) {
    if (info->si_code <= 0) ::kill(running_program.load(), signal);
}

/// While one lives, signals that would end this process are blocked, or passed on.
class PassedSignals {
public:
    PassedSignals() {
        sigset_t blocked;
        sigemptyset(&blocked);
        sigaddset(&blocked, SIGCHLD);
        for (const int signal : ending_signals) sigaddset(&blocked, signal);
        ::sigprocmask(SIG_BLOCK, &blocked, &mask_before);
        for (std::size_t i = 0; i < ending_signals.size(); ++i) {
            ::sigaction(ending_signals[i], nullptr, &before_[i]);
            if (before_[i].sa_handler == SIG_IGN) continue;
            struct sigaction action {};
            action.sa_sigaction = pass_on;
            action.sa_flags = SA_SIGINFO;
            ::sigaction(ending_signals[i], &action, nullptr);
        }
    }
    ~PassedSignals() {
        for (std::size_t i = 0; i < ending_signals.size(); ++i)
            ::sigaction(ending_signals[i], &before_[i], nullptr);
        ::sigprocmask(SIG_SETMASK, &mask_before, nullptr);
    }
    PassedSignals(const PassedSignals&) = delete;
    PassedSignals& operator=(const PassedSignals&) = delete;

    /// Once the program runs: SIGCHLD stays blocked, so that waiting can time out.
    static void deliver() {
        sigset_t delivered;
        sigemptyset(&delivered);
        for (const int signal : ending_signals) sigaddset(&delivered, signal);
        ::sigprocmask(SIG_UNBLOCK, &delivered, nullptr);
    }

    sigset_t mask_before{};

private:
    std::array<struct sigaction, ending_signals.size()> before_{};
};

std::vector<std::string> environment_with(
    const std::vector<std::pair<std::string, std::string>>& variables) {
    std::vector<std::string> all;
    for (char** at = environ; *at != nullptr; ++at) {
        const std::string line = *at;
        bool replaced = false;
        for (const auto& [name, value] : variables) replaced |= line.starts_with(name + "=");
        if (!replaced) all.push_back(line);
    }
    for (const auto& [name, value] : variables) all.push_back(name + "=" + value);
    return all;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
    all.push_back(nullptr);
    return all;
}

/// The program begins with the signals that this process had at its start.
pid_t start(const std::vector<std::string>& words, const std::vector<std::string>& environment,
            const sigset_t& mask) {
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t defaults;  // which gw ignores: image/output/temporaries.h
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGXFSZ);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setsigmask(&attributes, &mask);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, words[0].c_str(), nullptr, &attributes,
                                     pointers(words).data(), pointers(environment).data());
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0)
        throw Error(words[0] + ": cannot be run: " + std::strerror(error) + "; expected a program");
    return child;
}

int wait_for_end(pid_t child, const std::function<void()>& each_second) {
    sigset_t ended;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    for (;;) {
        int status = 0;
        if (::waitpid(child, &status, WNOHANG) == child)
            return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        const timespec second{1, 0};
        if (::sigtimedwait(&ended, nullptr, &second) < 0 && errno == EAGAIN) each_second();
    }
}

}  // namespace

int run_program(const std::vector<std::string>& words,
                const std::vector<std::pair<std::string, std::string>>& variables,
                const std::function<void()>& each_second) {
    PassedSignals signals;
    const pid_t child = start(words, environment_with(variables), signals.mask_before);
    running_program = child;
    PassedSignals::deliver();
    return wait_for_end(child, each_second);
}

namespace fs = std::filesystem;

fs::path folder_beside(std::initializer_list<const char*> folders, const char* file) {
    const fs::path root = fs::canonical("/proc/self/exe").parent_path().parent_path();
    for (const char* folder : folders)
        if (fs::exists(root / folder / file)) return root / folder;
    throw Error((root / *folders.begin() / file).string() +
                ": cannot be read: no such file; expected gw's libraries beside the command");
}

}  // namespace gw::apps
