// How a process ends early: by a signal during long work, or for lack of memory in a function that must
// not throw.
#pragma once

#include <string>

namespace gw::apps {

/// The text that is printed when a signal ends long work: which results exist, and how to go on.
/// While one lives, SIGINT, SIGTERM and SIGHUP write the last text to stderr. Then they end the
/// process as usual. Does not remove temporary files: image/output/temporaries.h does, next.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// At most 500 bytes are written.
    void say(const std::string& text);
};

/// From now on a lack of memory in a function that must not throw is one line "gw: out of memory" and
/// exit code 1, and leaves no temporary files. Any other call of std::terminate aborts as by default,
/// but leaves none either.
void end_clearly_on_terminate();

}  // namespace gw::apps
