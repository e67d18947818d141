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

/// Requests that are not waited for: their errors are not reported, whenever they come.
class QuietRequests {
public:
    explicit QuietRequests(Display* display);
    ~QuietRequests();
    QuietRequests(const QuietRequests&) = delete;
    QuietRequests& operator=(const QuietRequests&) = delete;
    /// Before the display is closed. Nothing is sent after it.
    void lose_display();

    /// Sends the requests of `make`, which takes the place of the earlier ones: the caller has
    /// waited for them, and has the display for itself.
    template <class Make>
    void send(Make make) {
        begin();
        make();
        end();
    }
    /// Waits until the server has carried them out, unless it is known to have. In a child process
    /// (fork), the parent's requests are not waited for: the replies are the parent's.
    void wait();

private:
    struct Handler;
    void begin();
    void end();
    Display* const display_;
    std::unique_ptr<Handler> handler_;  ///< null: the display is lost
};

}  // namespace gw::gl::x11
