// Text to stdout and stderr, and a line of progress. Names and messages may come from any file:
// control characters are printed as \x1b. Throws Error if stdout cannot be written.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace gw::apps {

/// As escape_controls, but keeps newlines and tabs.
std::string without_controls(std::string_view text);
/// Shown on one line: a text of more than two screens loses its middle. (A library's message may
/// repeat a whole file.) Newlines at the end are left out.
std::string as_one_line(std::string_view text);

void print(std::string_view text);
/// While one lives, `print` prints nothing: only the command's files are wanted.
class SilenceStdout {
public:
    SilenceStdout();
    ~SilenceStdout();
    SilenceStdout(const SilenceStdout&) = delete;
    SilenceStdout& operator=(const SilenceStdout&) = delete;
};
/// Throws Error if printed text could not be written.
void flush_output();

/// Occupies standard streams that were closed when the process started: no file may get their
/// numbers.
void hold_standard_streams();

void print_error(std::string_view text);
/// Prints "gw: warning: " and the text, as one line.
void print_warning(std::string_view text);
/// Clears the line on stderr and puts the cursor at its beginning.
void clear_error_line();
bool error_is_terminal();

/// Prints "gw: drawing, 3 s" on a terminal when work takes longer than a second. Does not know how
/// much is left: a machine executes a list as a whole.
class Progress {
public:
    /// Silent if `quiet` or if stderr is no terminal.
    Progress(std::string what, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The work that is under way from now on: "frame 3 of 36".
    void at(std::string what);

private:
    void show();

    std::mutex mutex_;
    std::condition_variable ended_;
    bool end_ = false;
    std::string what_;
    std::thread thread_;
};

}  // namespace gw::apps
