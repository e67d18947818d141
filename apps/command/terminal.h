// Text to stdout and stderr. Names and messages may come from anybody's files: control characters
// are shown, not obeyed. A full disk behind stdout is an error like any other.
#pragma once

#include <string>
#include <string_view>

namespace gw::apps {

/// Control characters but newline and tab, and bytes that are not UTF-8, as \\x1b.
std::string without_controls(std::string_view text);
/// One line that fits on a screen or two: newlines are blanks, and a long text (a library may
/// repeat a whole file) loses its middle.
std::string as_one_line(std::string_view text);

void print(std::string_view text);
/// While one lives, `print` prints nothing: a command runs for the files that it writes.
class SilenceStdout {
public:
    SilenceStdout();
    ~SilenceStdout();
    SilenceStdout(const SilenceStdout&) = delete;
    SilenceStdout& operator=(const SilenceStdout&) = delete;
};
/// Throws Error when something printed did not arrive.
void flush_output();

/// Where the process was started with closed standard streams: a file of ours must not become one
/// of them.
void hold_standard_streams();

void print_error(std::string_view text);
/// The cursor at the beginning of an empty line, for a line that replaces the last one.
void clear_error_line();
bool error_is_terminal();

}  // namespace gw::apps
