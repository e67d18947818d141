// The text that is printed when a signal ends long work: which results exist, and how to go on.
// Does not remove temporary files: image/output/temporaries.h does, next.
#pragma once

#include <string>

namespace gw::apps {

/// While one lives, SIGINT, SIGTERM and SIGHUP write the last text to stderr. Then they end the
/// process as usual.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// At most 500 bytes are written.
    void say(const std::string& text);
};

}  // namespace gw::apps
