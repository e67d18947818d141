#include "apps/terminal.h"

#include "gw/error.h"

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace gw::apps {

namespace {

[[noreturn]] void fail() {
    throw Error("standard output: cannot be written: " + std::string(std::strerror(errno)));
}

}  // namespace

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void flush_output() {
    if (std::fflush(stdout) != 0) fail();
}

void print_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace gw::apps
