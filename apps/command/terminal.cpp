#include "apps/command/terminal.h"

#include "gw/error.h"
#include "gw/escape_controls.h"

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace gw::apps {
namespace {

int muted = 0;

[[noreturn]] void fail() {
    throw Error("standard output: cannot be written: " + std::string(std::strerror(errno)));
}

void write_out(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) >> 6) == 2; }

}  // namespace

std::string without_controls(std::string_view text) { return escape_controls(text, "\n\t"); }

std::string as_one_line(std::string_view text) {
    constexpr std::size_t most_before = 1200, most_after = 600;
    while (text.ends_with('\n')) text.remove_suffix(1);
    if (text.size() > most_before + most_after) {
        std::size_t end = most_before, begin = text.size() - most_after;
        while (end > 0 && continues_character(text[end])) --end;
        while (begin < text.size() && continues_character(text[begin])) ++begin;
        return escape_controls(text.substr(0, end)) + " [...] " +
               escape_controls(text.substr(begin));
    }
    return escape_controls(text);
}

SilenceStdout::SilenceStdout() { ++muted; }
SilenceStdout::~SilenceStdout() { --muted; }

void print(std::string_view text) {
    if (muted > 0) return;
    const auto is_plain = [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t'; };
    if (std::all_of(text.begin(), text.end(), is_plain)) return write_out(text);  // needs no memory
    write_out(without_controls(text));
}

void flush_output() {
    if (std::fflush(stdout) != 0) fail();
}

// Opened the wrong way round, so that using them still fails.
void hold_standard_streams() {
    for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
    }
}

void print_error(std::string_view text) {
    const std::string harmless = without_controls(text);
    std::fwrite(harmless.data(), 1, harmless.size(), stderr);
}

void print_warning(std::string_view text) {
    print_error("gw: warning: " + as_one_line(text) + "\n");
}

void clear_error_line() { std::fputs("\r\033[K", stderr); }

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

Progress::Progress(std::string what, bool quiet) : what_(std::move(what)) {
    if (quiet || !error_is_terminal()) return;
    try {
        thread_ = std::thread([this] { show(); });
    } catch (const std::system_error&) {
        // The system refuses another thread: the work goes on without progress.
    }
}

Progress::~Progress() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void Progress::at(std::string what) {
    const std::lock_guard lock(mutex_);
    what_ = std::move(what);
}

void Progress::show() {
    std::unique_lock lock(mutex_);
    for (int seconds = 1;; ++seconds) {
        if (ended_.wait_for(lock, std::chrono::seconds(1), [this] { return end_; })) {
            if (seconds > 1) clear_error_line();
            return;
        }
        clear_error_line();
        print_error(as_one_line("gw: " + what_ + ", " + std::to_string(seconds) + " s"));
    }
}

}  // namespace gw::apps
