#include "apps/command/terminal.h"

#include "gw/error.h"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace gw::apps {
namespace {

int muted = 0;

[[noreturn]] void fail() {
    throw Error("standard output: cannot be written: " + std::string(std::strerror(errno)));
}

}  // namespace

Muted::Muted() { ++muted; }
Muted::~Muted() { --muted; }

void print(std::string_view text) {
    if (muted > 0) return;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
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

void print_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace gw::apps
