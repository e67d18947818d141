// Listens to what drawables execute and show: for recordings, statistics and pictures.
#pragma once

#include "gl/drawable/call_trace.h"
#include "gw/command_list.h"
#include "gw/counters.h"

#include <cstdint>
#include <memory>

namespace gw::gl {

class Drawable;

/// Why a drawable's commands are executed. All but the first are barriers: the frame is not whole.
enum class Cause : std::uint8_t {
    Shown,    ///< the frame is shown
    Flush,    ///< Flush or Finish, and nothing is shown
    Read,     ///< pixels are read
    Copy,     ///< pixels are copied
    Switch,   ///< the thread gets another context
    Texture,  ///< a small part of a large texture that it draws is replaced
    Query,    ///< the result of a query is read
    Full,     ///< the frame has too many vertices, commands, or bytes of images
};
inline constexpr int cause_count = 8;

struct Execution {
    const CommandList& list;
    const std::vector<CallRun>& calls;  ///< of its commands; empty if calls_are_kept is false
    Cause cause;
    Counters counters;  ///< of this list
};

/// Called by drawables of any thread, each of which is locked meanwhile. Must not throw.
class FrameLog {
public:
    virtual ~FrameLog() = default;
    /// A machine begins; its planes are 0.
    virtual void open(Drawable& drawable) = 0;
    /// The first command of Drawable::frame() is about to be added.
    virtual void begin_frame(Drawable& drawable) = 0;
    virtual void executed(Drawable& drawable, const Execution& execution) = 0;
    /// Drawable::frame() was executed and shown.
    virtual void end_frame(Drawable& drawable) = 0;
    /// The machine ends.
    virtual void close(Drawable& drawable) = 0;
};

/// Null: nobody listens.
FrameLog* frame_log();
/// Before the first drawable.
void set_frame_log(std::unique_ptr<FrameLog> log);

}  // namespace gw::gl
