// The counters of a machine, in the order of its stages. docs/manual/counters.md.
// Does not turn counts into time: price lists do (inspect/report).
#pragma once

#include "gw/planes.h"

#include <cstdint>
#include <optional>
#include <span>
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
    std::uint64_t rejected = 0;  ///< nothing is left after clipping
    /// cut by clipping, but not rejected; counted again in one of the following
    std::uint64_t clipped = 0;
    std::uint64_t degenerate = 0;  ///< the sum of its pieces' areas is 0 after the snap
    std::uint64_t culled = 0;
    std::uint64_t drawn = 0;
    std::uint64_t fragments = 0;  ///< made inside primitive, viewport, scissor and window
    std::uint64_t alpha_killed = 0;
    std::uint64_t stencil_killed = 0;
    std::uint64_t depth_killed = 0;
    std::uint64_t written = 0;  ///< passed every test; masks may still protect every plane
    std::uint64_t texels = 0;   ///< fragments made times the look-ups of the minification filter
    /// touched by clears, pixel writes of depth or stencil, accumulation, copies, reads
    std::uint64_t pixels = 0;
    std::uint64_t accum_overflows = 0;  ///< channels that wrapped
    std::uint64_t bytes = 0;            ///< of frame buffer traffic by the manual's model

    Counters& operator+=(const Counters& other);
    bool operator==(const Counters&) const = default;
};

/// The result of a query: fragments written from its begin to its end.
struct QueryResult {
    std::uint32_t key = 0;
    std::uint64_t samples = 0;
    bool operator==(const QueryResult&) const = default;
};

/// The counts of one pass, which extends from a BeginPass to the next. Commands before the first
/// BeginPass are counted in a pass named "".
struct PassReport {
    std::string name;
    Counters counters;
    PlaneMask digested = 0;
    std::array<Digest, every_plane.size()> digests{};  ///< by Plane, of the planes in `digested`
    std::vector<QueryResult> queries{};                ///< that ended in it, in order
    bool operator==(const PassReport&) const = default;
};

/// The last result of the query of this key that ended in these passes.
std::optional<std::uint64_t> query_result(std::span<const PassReport> passes, std::uint32_t key);

}  // namespace gw
