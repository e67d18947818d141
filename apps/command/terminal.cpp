#include "apps/command/terminal.h"

#include "gw/error.h"

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

/// The length of the UTF-8 character at the beginning; 0: there is none, or it is a control (C1).
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80   ? 1
                               : byte(0) < 0xc2 ? 0
                               : byte(0) < 0xe0 ? 2
                               : byte(0) < 0xf0 ? 3
                               : byte(0) < 0xf5 ? 4
                                                : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (byte(i) >> 6 != 2) return 0;
    const bool is_control =
        byte(0) < 0x20 || byte(0) == 0x7f || (byte(0) == 0xc2 && byte(1) < 0xa0);
    const bool is_line = text[0] == '\n' || text[0] == '\t';
    return is_control && !is_line ? 0 : length;
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) >> 6) == 2; }

}  // namespace

std::string without_controls(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length > 0) {
            result += text.substr(0, length);
        } else {
            const auto byte = static_cast<unsigned char>(text[0]);
            result += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
        }
        text.remove_prefix(length > 0 ? length : 1);
    }
    return result;
}

std::string as_one_line(std::string_view text) {
    constexpr std::size_t most_before = 1200, most_after = 600;
    while (text.ends_with('\n')) text.remove_suffix(1);
    std::string line;
    if (text.size() > most_before + most_after) {
        std::size_t end = most_before, begin = text.size() - most_after;
        while (end > 0 && continues_character(text[end])) --end;
        while (begin < text.size() && continues_character(text[begin])) ++begin;
        line = without_controls(text.substr(0, end)) + " [...] " +
               without_controls(text.substr(begin));
    } else {
        line = without_controls(text);
    }
    std::ranges::replace(line, '\n', ' ');
    return line;
}

SilenceStdout::SilenceStdout() { ++muted; }
SilenceStdout::~SilenceStdout() { --muted; }

void print(std::string_view text) {
    if (muted > 0) return;
    const std::string shown = without_controls(text);
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) fail();
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
    const std::string shown = without_controls(text);
    std::fwrite(shown.data(), 1, shown.size(), stderr);
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
