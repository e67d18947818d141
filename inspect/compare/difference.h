// The first difference of two recordings: in their commands, and in the planes that they leave.
// Does not draw pictures.
#pragma once

#include "inspect/compare/compare_machines.h"
#include "inspect/compare/finding.h"
#include "inspect/recording/recording.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/shown/color_map.h"

#include <optional>
#include <string>

namespace gw::inspect {

/// Profile, window, then command by command: its kind, the state's field, the mesh's array and
/// element, the map, the lights, ... Meshes, maps and lights are compared by content; how commands
/// are cut into lists does not count. Values are `a`'s (expected) and `b`'s.
std::optional<Finding> first_command_difference(const Recording& a, const Recording& b);

struct ResultDifference {
    Finding finding;
    Plane plane = Plane::Color;
    Planes a, b;  ///< after the pass
    /// Of the recordings or manifests, which must outlive it: the colours are indices. Null: they are not.
    const ColorMap *map_a = nullptr, *map_b = nullptr;
};

/// Two recordings of the same window, pass by pass in their order, each on a machine of its own
/// profile.
/// Nothing: the same planes after every pass.
std::optional<ResultDifference> first_result_difference(const Recording& a, const Recording& b,
                                                        const MachineMaker& make);

/// The planes after the finding's pass, and the worst pixel of the first plane that differs.
ResultDifference located(ResultDifference of);

/// The first pass after which a screen shows indices through different maps, and the first entry.
std::optional<Finding> first_map_difference(const Recording& a, const Recording& b);

/// The first event in a pixel's two histories that is not the same, as two lines; "" if they
/// agree.
std::string first_event_difference(const Recording& a, const Recording& b, int x, int y);

/// "12 40: 10 10 10 255, 11 10 10 255" or indices with their entries, worst first, at most `most` lines. Picture coordinates.
std::string wrong_pixel_lines(const ResultDifference& difference, std::size_t most);

}  // namespace gw::inspect
