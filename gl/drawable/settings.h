// The user's environment variables: GW_PROFILE, GW_THREADS, GW_MACHINE, GW_FRAMES,
// GW_GL_VERSION, GW_SWAP. docs/opengl.md
#pragma once

#include "gl/api/offer.h"
#include "gw/machine.h"
#include "gw/profile.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>

namespace gw::gl {

/// What a window's back buffer holds after a swap: the picture that is shown, as after a copy, or the
/// one that was shown before.
enum class SwapMethod : std::uint8_t { Copy, Exchange };

struct Settings {
    Profile profile = opengl();          ///< GW_PROFILE: gw/profile_text.h
    int threads = 0;                     ///< GW_THREADS; 0: all
    bool reference = false;              ///< GW_MACHINE: fast or reference
    SwapMethod swap = SwapMethod::Copy;  ///< GW_SWAP: copy or exchange
    int version = last_version;          ///< GW_GL_VERSION: the doors hide what is newer
};

/// Read once. A variable whose value is wrong is ignored, and one line on stderr says so.
const Settings& settings();

/// The frames of each window that are recorded, counted and shown.
struct FrameRange {
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max();
    bool holds(std::uint64_t frame) const { return first <= frame && frame <= last; }
};

/// GW_FRAMES: "10-12" or "12"; all if it is not set. A wrong value is reported and ignored.
FrameRange read_frame_range();

/// "gw: GW_THREADS is 'many'; expected 0 to 256; it is ignored", on stderr.
void report_ignored(std::string_view variable, std::string_view value, std::string_view expected);

/// N of the version 1.N that is whole on the settings' profile.
int offered_minor();

/// "gw: OpenGL 3.3 is asked for; 1.5 is offered; no context is made", on stderr.
void report_refused_context(int major, int minor);

/// A machine of the settings' kind.
std::unique_ptr<Machine> make_machine(const Profile& profile, int width, int height);

}  // namespace gw::gl
