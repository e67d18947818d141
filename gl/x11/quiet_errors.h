// X errors of our own requests, which the program's error handler must not see.
#pragma once

#include "gl/x11/x11.h"

#include <memory>

namespace gw::gl::x11 {

/// XLockDisplay .. XUnlockDisplay.
class LockedDisplay {
public:
    explicit LockedDisplay(Display* display) : display_(display) { XLockDisplay(display); }
    ~LockedDisplay() { XUnlockDisplay(display_); }
    LockedDisplay(const LockedDisplay&) = delete;
    LockedDisplay& operator=(const LockedDisplay&) = delete;

private:
    Display* const display_;
};

/// While it lives, the calling thread has the display for itself, and errors of its requests are
/// counted here, not reported.
class QuietErrors {
public:
    explicit QuietErrors(Display* display);
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

    /// Waits for the server. Whether a request since the construction failed.
    bool failed();

private:
    struct Handler;
    Display* const display_;
    const LockedDisplay locked_;
    std::unique_ptr<Handler> handler_;
};

}  // namespace gw::gl::x11
