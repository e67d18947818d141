// A list under construction, with the data that the generators of a suite share. Does not choose
// commands: suites do.
#pragma once

#include "conformance/generate/case.h"
#include "conformance/generate/frame.h"

namespace gw::conformance {

struct Script {
    Random& random;
    Case out;
    State state;  ///< of the next draw; `draw` and the pixel commands set it first
    Frame frame;
    std::vector<std::uint32_t> color_slots, depth_slots;  ///< filled by CopyTexture
};

/// Built-in or of a user; always valid.
Profile any_profile(Random& random);
/// Every field has a random value of its range.
Profile user_profile(Random& random);
/// Profile opengl with its extensions up to `last`: recordings must not change when it grows.
Profile opengl_up_to(bool Extensions::*last);
/// The same, or bits of every width.
Profile any_opengl_profile(Random& random, bool Extensions::*last = &Extensions::draw_pixels);

/// A window, a frame to place vertices in, and clears of every plane: depth to 1, colour and
/// stencil to random values.
Script script(Random& random, const Profile& profile);
/// The same on any profile.
Script script(Random& random);

/// The same without clears, on a window whose pixels are the units of object space; z of -1 .. 1
/// becomes the depth.
Script pixel_script(Random& random, const Profile& profile, int width, int height);

/// Adds SetState if the state differs from the last one that was set.
void set_state(Script& script);
/// Adds set_state and the command.
void add(Script& script, Command command);

/// Sometimes adds a new pass, digests or a read-back, as hosts do between draws.
void between_draws(Script& script);

}  // namespace gw::conformance
