// Runs a program that may never end, and prints without end. Keeps what it printed. Does not isolate
// it: isolation.h does.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gw::apps {

struct RunLimits {
    double seconds = 10;                         ///< from its start
    std::size_t output = std::size_t{16} << 20;  ///< bytes on its stdout
    std::size_t memory = std::size_t{1} << 30;   ///< bytes in use by it and its children; 0: any
};

enum class RunEnd { Exited, Signalled, TooLong, TooMuchOutput, TooMuchMemory };

struct LimitedRun {
    RunEnd end = RunEnd::Exited;
    int code = 0;          ///< its exit code, or the signal's number
    std::string out, err;  ///< of stderr the first 4000 bytes
    double seconds = 0;    ///< that it took
};

/// Runs `words[0]`, looked up as a shell does, with nothing on stdin, and waits for its end. A program
/// beyond a limit is killed. May be called by several threads at once; if the calling thread ends, the
/// program should (setpriv --pdeathsig). Throws Error if it cannot be started.
LimitedRun run_limited(const std::vector<std::string>& words, const RunLimits& limits);

}  // namespace gw::apps
