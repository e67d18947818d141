#include "gl/x11/quiet_errors.h"

#include <unistd.h>

// Xlib's interface for extensions. It defines macros, so it comes last.
#include <X11/Xlibint.h>

namespace gw::gl::x11 {

namespace {

/// Has the handler look at every reply and error from now on.
template <class Handler>
void add_handler(Display* display, Handler& handler) {
    handler.hook.handler = &Handler::take;
    handler.hook.data = reinterpret_cast<XPointer>(&handler);
    LockDisplay(display);
    handler.hook.next = display->async_handlers;
    display->async_handlers = &handler.hook;
    UnlockDisplay(display);
}

}  // namespace

struct QuietErrors::Handler {
    _XAsyncHandler hook{};
    unsigned long first = 0;  ///< serial number of the first request
    bool failed = false;

    static Bool take(Display* display, xReply* reply, char*, int, XPointer data) {
        Handler& handler = *reinterpret_cast<Handler*>(data);
        if (reply->generic.type != X_Error) return False;
        if (display->last_request_read < handler.first) return False;
        handler.failed = true;
        return True;
    }
};

QuietErrors::QuietErrors(Display* display)
    : display_(display), locked_(display), handler_(std::make_unique<Handler>()) {
    handler_->first = XNextRequest(display);
    add_handler(display, *handler_);
}

bool QuietErrors::failed() {
    XSync(display_, False);
    return handler_->failed;
}

QuietErrors::~QuietErrors() {
    if (XLastKnownRequestProcessed(display_) + 1 != XNextRequest(display_)) XSync(display_, False);
    LockDisplay(display_);
    DeqAsyncHandler(display_, &handler_->hook);
    UnlockDisplay(display_);
}

struct QuietRequests::Handler {
    _XAsyncHandler hook{};
    unsigned long first = 1, last = 0;  ///< serial numbers
    pid_t process = 0;                  ///< that sent the requests

    static Bool take(Display* display, xReply* reply, char*, int, XPointer data) {
        const Handler& handler = *reinterpret_cast<Handler*>(data);
        const unsigned long serial = display->last_request_read;
        return reply->generic.type == X_Error && serial >= handler.first && serial <= handler.last;
    }
};

QuietRequests::QuietRequests(Display* display)
    : display_(display), handler_(std::make_unique<Handler>()) {
    add_handler(display, *handler_);
}

void QuietRequests::begin() {
    handler_->first = XNextRequest(display_);
    handler_->last = ~0ul;
}

void QuietRequests::end() {
    handler_->last = XNextRequest(display_) - 1;
    handler_->process = getpid();
    XFlush(display_);
}

void QuietRequests::wait() {
    if (!handler_ || XLastKnownRequestProcessed(display_) >= handler_->last) return;
    if (handler_->process == getpid()) XSync(display_, False);
}

void QuietRequests::lose_display() {
    if (!handler_) return;
    LockDisplay(display_);
    DeqAsyncHandler(display_, &handler_->hook);
    UnlockDisplay(display_);
    handler_ = nullptr;
}

QuietRequests::~QuietRequests() {
    wait();
    lose_display();
}

}  // namespace gw::gl::x11
