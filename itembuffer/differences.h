// Compares the two renderers of eq. 5, passes with an item buffer and ordinary ray tracing: which
// pixels differ, and why. Does not write files.
#pragma once

#include "gw/machine.h"
#include "itembuffer/render.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gw::itembuffer {

/// Why a pixel differs: the first reason that holds.
///   Polygon    The pictures show different polygons. The machine snaps vertices and fills by its
///              rule; rays meet the true polygons.
///   Shadow     The border of a light's shadow is within a pixel. Stencil and shadow rays round
///              differently.
///   Rounding   By at most one unit for each pass: passes are rounded one by one.
///   Fog        Without fog it would be Rounding: the machine interpolates the fog factor between
///              vertices.
///   Lighting   All others: the machine lights vertices and interpolates; rays light points.
enum class Reason : std::uint8_t { Same, Polygon, Shadow, Rounding, Fog, Lighting };
inline constexpr std::array<Reason, 6> reasons{Reason::Same,     Reason::Polygon, Reason::Shadow,
                                               Reason::Rounding, Reason::Fog,     Reason::Lighting};
/// "another polygon", "shadow border", ...
std::string_view name_of(Reason reason);

struct Differences {
    std::vector<Rgba> by_passes, by_rays;  ///< the pictures, bottom row first
    std::vector<Reason> reason;            ///< by pixel
    std::vector<int> units;                ///< by pixel: the largest difference of a channel
    int passes = 0;                        ///< passes that add colours: the limit of Rounding
    /// Pixels whose four neighbours show the same polygon, and those of them where rays meet
    /// another.
    std::size_t away_from_edges = 0, another_polygon_there = 0;
};

/// The scene without lens, motion, soft lights and glare, as it is compared.
scene::Scene compared_scene(scene::Scene scene);

/// One picture of each, of compared_scene(). Reads the options `depth`,
/// `shadow_maps` and `threads`.
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
