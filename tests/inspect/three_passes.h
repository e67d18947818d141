// A small recording whose planes are known by hand.
#pragma once

#include "inspect/recording/recording.h"

namespace gw::inspect {

/// 8 x 6 pixels. "clear": everything. "first": a grey square at (2, 1). "second": the accumulation
/// buffer is loaded, and the stencil of a square at (3, 2) is written.
inline Recording three_passes() {
    Recording r;
    r.width = 8;
    r.height = 6;
    r.sets = {{"first", "(Ka=0, Kd=object)"}};
    CommandList list;
    list.add(BeginPass{.name = "clear"});
    list.add(Clear{.planes = all_planes});
    list.add(BeginPass{.name = "first"});
    list.add(WritePixels{.rect = {2, 1, 2, 2},
                         .colors = std::vector<Rgba>(4, Rgba{100, 100, 100, 255})});
    r.lists.push_back(list);
    CommandList second;
    second.add(BeginPass{.name = "second"});
    second.add(Accumulate{AccumOp::Load, 1});
    second.add(WritePixels{.rect = {3, 2, 2, 2}, .plane = Plane::Stencil, .values = {1, 2, 3, 4}});
    r.lists.push_back(second);
    return r;
}

/// The colour of one pixel of every colour rectangle, one too much green: window pixel (3, 2),
/// picture pixel (3, 3).
inline void too_green(Command& command) {
    auto* pixels = std::get_if<WritePixels>(&command);
    if (pixels && pixels->plane == Plane::Color) pixels->colors.back()[1] += 1;
}

}  // namespace gw::inspect
