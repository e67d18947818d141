// The two renderers of eq. 5's scenes beside each other: passes with an item buffer, and ordinary
// ray tracing. What differs, pixel by pixel, and why. Does not write files.
#pragma once

#include "gw/machine.h"
#include "itembuffer/render.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gw::itembuffer {

/// Why a pixel differs; the first that holds.
///   Polygon    the two show different polygons: the machine snaps vertices and fills by its rule, rays meet
///              the true polygons
///   Shadow     within a pixel of it some light's shadow begins: stencil and shadow rays decide for
///   themselves Rounding   by at most one unit for each pass: passes round one by one Fog        without fog
///   it would be rounding: its factor is found at vertices and interpolated Lighting   what is left: light is
///   found at vertices and interpolated; rays light points
enum class Reason : std::uint8_t { Same, Polygon, Shadow, Rounding, Fog, Lighting };
inline constexpr std::array<Reason, 6> reasons{Reason::Same,     Reason::Polygon, Reason::Shadow,
                                               Reason::Rounding, Reason::Fog,     Reason::Lighting};
/// "another polygon", "shadow border", ...
std::string_view name_of(Reason reason);

struct Differences {
    std::vector<Rgba> by_passes, by_rays;  ///< the pictures, bottom row first
    std::vector<Reason> reason;            ///< by pixel
    std::vector<int> units;                ///< by pixel: the largest difference of a channel
    int passes = 0;                        ///< that add colours: what rounding may come to
    /// Pixels whose four neighbours show the same polygon, and those of them where rays meet
    /// another.
    std::size_t away_from_edges = 0, another_polygon_there = 0;
};

/// One picture of each: without lens, motion, soft lights and glare. Of the options `depth`,
/// `shadow_maps`, `threads`.
Differences differences(Machine& machine, const scene::Scene& scene, const scene::View& view,
                        const Options& options);

/// The pixels of one reason.
struct ReasonCount {
    std::size_t pixels = 0;
    int largest = 0;  ///< in units of the frame buffer
    double mean = 0;  ///< of their largest channels
};
ReasonCount count_of(const Differences& d, Reason reason);

}  // namespace gw::itembuffer
