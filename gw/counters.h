// What a machine counts, in the order of its stages. docs/manual.md, "Counters".
// Does not turn counts into time: apps/ and price lists do.
#pragma once

#include "gw/planes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gw {

/// A primitive is a point, a line or a triangle after decomposition, before clipping.
/// primitives = rejected + degenerate + culled + drawn;
/// fragments = alpha_killed + stencil_killed + depth_killed + written.
struct Counters {
    std::uint64_t draws = 0;
    std::uint64_t vertices = 0;  ///< of the meshes drawn
    std::uint64_t primitives = 0;
    std::uint64_t rejected = 0;  ///< nothing left after clipping
    /// cut, but something left (counted again in one of the following)
    std::uint64_t clipped = 0;
    std::uint64_t degenerate = 0;  ///< zero area after the snap (all of its pieces together)
    std::uint64_t culled = 0;
    std::uint64_t drawn = 0;
    std::uint64_t fragments = 0;  ///< made: inside primitive, viewport, scissor and window
    std::uint64_t alpha_killed = 0;
    std::uint64_t stencil_killed = 0;
    std::uint64_t depth_killed = 0;
    std::uint64_t written = 0;  ///< passed every test (masks may still keep every plane)
    std::uint64_t texels = 0;   ///< fragments made times the look-ups of the minification filter
    /// touched by clear, depth/stencil pixel writes, accumulate, copy, read
    std::uint64_t pixels = 0;
    std::uint64_t accum_overflows = 0;  ///< channels that wrapped
    std::uint64_t bytes = 0;            ///< of frame buffer traffic by the manual's model

    Counters& operator+=(const Counters& other);
    bool operator==(const Counters&) const = default;
};

/// One pass: from a BeginPass to the next. Commands before the first BeginPass are counted in a
/// pass named "".
struct PassReport {
    std::string name;
    Counters counters;
    PlaneMask digested = 0;
    std::array<Digest, 4> digests{};  ///< by Plane, where `digested` says so
    bool operator==(const PassReport&) const = default;
};

}  // namespace gw
