#include "gl/x11/own_connection.h"

#include "gw/base/blocked_signals.h"

#include <poll.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

// The protocol's structs. It defines macros, so it comes last.
#include <X11/Xmd.h>
#include <X11/extensions/shmproto.h>

namespace gw::gl::x11 {

namespace {

constexpr std::chrono::milliseconds patience{100};

/// The number of MIT-SHM's requests.
std::optional<std::uint8_t> shared_memory_opcode(xcb_connection_t* connection) {
    constexpr std::string_view name = "MIT-SHM";
    xcb_query_extension_reply_t* const reply = xcb_query_extension_reply(
        connection, xcb_query_extension(connection, std::uint16_t(name.size()), name.data()),
        nullptr);
    if (reply == nullptr) return std::nullopt;
    const bool is_present = reply->present != 0;
    const std::uint8_t opcode = reply->major_opcode;
    std::free(reply);
    return is_present ? std::optional(opcode) : std::nullopt;
}

void send(xcb_connection_t* connection, xShmPutImageReq& request) {
    // libxcb writes the lengths before the request's first part.
    std::array<iovec, 3> parts{};
    parts[2] = {&request, sz_xShmPutImageReq};
    const xcb_protocol_request_t kind{
        .count = 1, .ext = nullptr, .opcode = request.reqType, .isvoid = 1};
    xcb_send_request(connection, 0, &parts[2], &kind);
}

}  // namespace

/// The connection, when it is made.
struct OwnConnection::Link {
    xcb_connection_t* connection = nullptr;
    std::uint8_t opcode = 0;
    std::atomic<bool> is_made = false;

    ~Link() {
        if (connection != nullptr) xcb_disconnect(connection);
    }
    void make(const std::string& display) {
        connection = xcb_connect(display.c_str(), nullptr);
        if (const auto found = shared_memory_opcode(connection)) {
            opcode = *found;
            is_made = true;
        }
    }
};

OwnConnection::OwnConnection(Display* programs) : link_(std::make_shared<Link>()) {
    try {
        const BlockedSignals blocked;
        std::thread([link = link_, name = std::string(DisplayString(programs))] {
            link->make(name);
        }).detach();
    } catch (const std::system_error&) {  // never ready: the system gives no thread
    }
}

OwnConnection::~OwnConnection() = default;

bool OwnConnection::is_ready() {
    return link_->is_made && has_answered() && xcb_connection_has_error(link_->connection) == 0;
}

bool OwnConnection::put(const SharedImage& image) {
    xShmPutImageReq request{};
    request.reqType = link_->opcode;
    request.shmReqType = X_ShmPutImage;
    request.drawable = CARD32(image.target);
    request.gc = CARD32(image.gc);
    request.totalWidth = request.srcWidth = CARD16(image.width);
    request.totalHeight = request.srcHeight = CARD16(image.height);
    request.dstY = INT16(image.top);
    request.depth = CARD8(image.depth);
    request.format = ZPixmap;
    request.shmseg = CARD32(image.segment);
    send(link_->connection, request);
    question_ = xcb_get_input_focus(link_->connection).sequence;
    xcb_flush(link_->connection);
    return wait();
}

bool OwnConnection::has_answered() {
    // Errors as well: the window may be gone.
    while (void* const event = xcb_poll_for_event(link_->connection)) std::free(event);
    if (!question_) return true;
    void* reply = nullptr;
    xcb_generic_error_t* error = nullptr;
    if (xcb_poll_for_reply(link_->connection, *question_, &reply, &error) == 0) return false;
    std::free(reply);
    std::free(error);
    question_ = std::nullopt;
    return true;
}

bool OwnConnection::wait() {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + patience;
    pollfd socket{xcb_get_file_descriptor(link_->connection), POLLIN, 0};
    while (!has_answered()) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        poll(&socket, 1, int(left));
    }
    return xcb_connection_has_error(link_->connection) == 0;
}

}  // namespace gw::gl::x11
