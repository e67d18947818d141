// A difference that was found: where, both values, and which stage of the machine made it. What
// verify, diff and the comparison of machines answer.
#pragma once

#include "gw/counters.h"
#include "inspect/compare/plane_values.h"

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
    std::string expected, actual;    ///< "" where not known
    std::string stage;               ///< "" where none can be named
    std::vector<std::string> notes;  ///< a line each
};

/// "pass 4 'diffuse lamp', plane color, pixel 12 40: expected 10 10 10 255, got 11 10 10 255;
/// stage: ...", then the notes, a line each. Pixels in picture coordinates, top left first.
std::string text(const Finding& finding, int height);

/// The first stage, in the machine's order, whose count differs; "" where none does.
std::string stage_of(const Counters& expected, const Counters& actual);
/// The stages that only write this plane: what is left where all counts agree.
std::string stage_of(Plane plane);

/// The first difference between two reports of a pass: name, counters, digests; `pass` is its
/// place.
std::optional<Finding> first_difference(const PassReport& expected, const PassReport& actual,
                                        std::size_t pass);

}  // namespace gw::inspect
