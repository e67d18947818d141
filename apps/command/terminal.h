// Text to stdout and stderr. A full disk behind stdout is an error like any other.
#pragma once

#include <string_view>

namespace gw::apps {

void print(std::string_view text);
/// While one lives, print prints nothing: a command runs for the files that it makes.
class Muted {
public:
    Muted();
    ~Muted();
    Muted(const Muted&) = delete;
    Muted& operator=(const Muted&) = delete;
};
/// Throws Error when something printed did not arrive.
void flush_output();

/// Where the process was started with closed standard streams: a file of ours must not become one
/// of them.
void hold_standard_streams();

void print_error(std::string_view text);
bool error_is_terminal();

}  // namespace gw::apps
