// Where the planes of two recordings first differ, pass by pass, and which draw and fragment made
// it so.
// Does not draw pictures.
#pragma once

#include "inspect/compare/compare_machines.h"
#include "inspect/replay/pixel_history.h"

namespace gw::inspect {

struct ResultDifference {
    Finding finding;
    Plane plane = Plane::Color;
    Planes a, b;  ///< after the pass
};

/// Two recordings of the same window, pass by pass in their order, each on a machine of its own
/// profile.
/// Nothing: the same planes after every pass.
std::optional<ResultDifference> first_result_difference(const Recording& a, const Recording& b,
                                                        const MachineMaker& make);

/// The planes after the finding's pass, and the worst pixel of the first plane that differs.
ResultDifference located(Finding finding, Planes a, Planes b);

/// The first event in a pixel's two histories that is not the same, as two lines; "" where they
/// agree.
std::string first_event_difference(const Recording& a, const Recording& b, int x, int y);

/// "12 40: 10 10 10 255, 11 10 10 255", worst first, at most `most` lines. Picture coordinates.
std::string wrong_pixel_lines(const ResultDifference& difference, std::size_t most);

}  // namespace gw::inspect
