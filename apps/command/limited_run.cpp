#include "apps/command/limited_run.h"

#include "gw/error.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_errors = 4000;

/// Both ends are closed in other programs that are started meanwhile.
struct Pipe {
    Pipe() {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            throw Error(std::string("a pipe cannot be made: ") + std::strerror(errno));
        ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
        ::fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);  // only faster
    }
    ~Pipe() {
        ::close(ends[0]);
        close_end();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close_end() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
    /// Appends what is there to `text`, up to `most` bytes of it, and drops the rest. Returns the
    /// number of bytes read.
    std::size_t read_into(std::string& text, std::size_t most) const {
        std::array<char, 65536> bytes;
        std::size_t all = 0;
        // a program that prints all the time must not keep us from looking at the clock
        while (all < (std::size_t{1} << 22)) {
            const ssize_t got = ::read(ends[0], bytes.data(), bytes.size());
            if (got <= 0) break;
            all += std::size_t(got);
            text.append(bytes.data(),
                        std::min(std::size_t(got), most - std::min(most, text.size())));
        }
        return all;
    }
    std::array<int, 2> ends{};
};

/// A process group of its own, with the signals' usual actions, and no file of ours.
pid_t start(const std::vector<std::string>& words, const Pipe& out, const Pipe& err) {
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, out.ends[1], 1);
    ::posix_spawn_file_actions_adddup2(&files, err.ends[1], 2);
    ::posix_spawn_file_actions_addclosefrom_np(&files, 3);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none, defaults;
    sigemptyset(&none);
    sigfillset(&defaults);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int error =
        ::posix_spawnp(&child, pointers[0], &files, &attributes, pointers.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    if (error != 0)
        throw Error(words[0] + ": cannot be run: " + std::strerror(error) + "; expected a program");
    return child;
}

/// The numbers of a file's lines that begin with these names, in kilobytes; nothing if it cannot be
/// read.
std::optional<std::size_t> kilobytes_in(const fs::path& file,
                                        const std::array<std::string_view, 2>& names) {
    std::ifstream in(file);
    std::optional<std::size_t> sum;
    for (std::string line; std::getline(in, line);)
        for (const std::string_view name : names)
            if (line.starts_with(name))
                sum = sum.value_or(0) + std::strtoull(line.c_str() + name.size(), nullptr, 10);
    return sum;
}

/// Bytes in memory of a process and all its children; what they share counts once.
std::size_t memory_of(pid_t process) {
    const fs::path folder = fs::path("/proc") / std::to_string(process);
    auto own = kilobytes_in(folder / "smaps_rollup", {"Pss_Anon:", "Pss_Shmem:"});
    if (!own) own = kilobytes_in(folder / "status", {"RssAnon:", "RssShmem:"});
    std::size_t bytes = own.value_or(0) * 1024;
    std::error_code gone;
    for (fs::directory_iterator thread(folder / "task", gone), end; !gone && thread != end;
         thread.increment(gone)) {
        std::ifstream children(thread->path() / "children");
        for (pid_t child = 0; children >> child;) bytes += memory_of(child);
    }
    return bytes;
}

/// A limit that the program has passed. Measures its memory every 50 ms, since that takes time.
class Watch {
public:
    Watch(const RunLimits& limits, pid_t child) : limits_(limits), child_(child) {}

    std::optional<RunEnd> passed(double seconds, std::size_t printed) {
        if (seconds > limits_.seconds) return RunEnd::TooLong;
        if (printed > limits_.output) return RunEnd::TooMuchOutput;
        if (limits_.memory == 0 || seconds < next_) return {};
        next_ = seconds + 0.05;
        if (memory_of(child_) > limits_.memory) return RunEnd::TooMuchMemory;
        return {};
    }

private:
    const RunLimits& limits_;
    pid_t child_;
    double next_ = 0;
};

}  // namespace

LimitedRun run_limited(const std::vector<std::string>& words, const RunLimits& limits) {
    Pipe out, err;
    const auto begin = Clock::now();
    const pid_t child = start(words, out, err);
    out.close_end();
    err.close_end();
    LimitedRun run;
    std::size_t printed = 0;
    std::optional<RunEnd> killed;
    Watch watch(limits, child);
    for (bool ended = false; !ended;) {
        std::array<pollfd, 2> wanted{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
        ::poll(wanted.data(), wanted.size(), 20);
        // Both ends closed: poll no longer waits.
        if (((wanted[0].revents | wanted[1].revents) & POLLIN) == 0) ::usleep(2000);
        int status = 0;
        ended = ::waitpid(child, &status, WNOHANG) == child;
        if (ended) {
            run.end = WIFSIGNALED(status) ? RunEnd::Signalled : RunEnd::Exited;
            run.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
        }
        printed += out.read_into(run.out, limits.output);
        err.read_into(run.err, most_errors);
        run.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (!killed && !ended) {
            killed = watch.passed(run.seconds, printed);
            if (killed) ::kill(-child, SIGKILL);
        }
    }
    ::kill(-child, SIGKILL);  // what it left in its group
    if (!killed && printed > limits.output) killed = RunEnd::TooMuchOutput;
    if (killed) run.end = *killed;
    return run;
}

}  // namespace gw::apps
