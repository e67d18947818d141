// A connection of our own to a program's X server, so that another thread can show frames while the
// program uses its connection. A program may grab the server, which then answers nobody else: no
// function waits for that.
#pragma once

#include "gl/x11/x11.h"

#include <memory>
#include <optional>

namespace gw::gl::x11 {

/// An image in a segment of shared memory that any connection has attached.
struct SharedImage {
    XID target = 0, gc = 0, segment = 0;  ///< names are the server's: any connection may use them
    int width = 0, height = 0, depth = 0;
    int top = 0;  ///< of the image in the target
};

/// Any thread may use it, one at a time.
class OwnConnection {
public:
    /// Connects in the background.
    explicit OwnConnection(Display* programs);
    ~OwnConnection();
    OwnConnection(const OwnConnection&) = delete;
    OwnConnection& operator=(const OwnConnection&) = delete;

    /// Whether it is connected, and the server has done all that was asked.
    bool is_ready();
    /// Precondition: is_ready(). Returns whether the image is shown. If not, because the server does
    /// not answer for a while, it is shown later, with what is then in the segment.
    bool put(const SharedImage& image);

private:
    struct Link;
    bool has_answered();
    bool wait();

    std::shared_ptr<Link> link_;        ///< also of the thread that connects
    std::optional<unsigned> question_;  ///< the number of the request whose reply has not come
};

}  // namespace gw::gl::x11
