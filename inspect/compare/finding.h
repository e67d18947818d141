// A difference that was found: its place, both values, and the stage of the machine that made it.
// The answer of verify, diff and the comparison of machines.
#pragma once

#include "gw/counters.h"
#include "inspect/replay/plane_values.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

struct Finding {
    /// "plane color", "counter depth_killed", "state depth.func", ...
    std::string what;
    std::optional<std::size_t> pass;  ///< its place among the passes, from 0
    std::string pass_name;
    std::optional<ivec2> pixel;      ///< window coordinates
    std::string expected, actual;    ///< "" if unknown
    std::string stage;               ///< "" if unknown
    std::vector<std::string> notes;  ///< a line each
};

/// "pass 4 'diffuse lamp', plane color, pixel 12 40: expected 10 10 10 255, got 11 10 10 255;
/// stage: ...", then the notes, a line each. Pixels in picture coordinates, top left first.
std::string text(const Finding& finding, int height);

/// The first stage, in the machine's order, whose count differs; "" if none does.
std::string stage_of(const Counters& expected, const Counters& actual);
/// The stages that only write this plane: those that remain if all counts agree.
std::string stage_of(Plane plane);

/// The first difference between two reports of a pass: name, counters, digests; `pass` is its
/// place.
std::optional<Finding> first_difference(const PassReport& expected, const PassReport& actual,
                                        std::size_t pass);

}  // namespace gw::inspect
