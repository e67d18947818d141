// The fragment stages after shading: alpha, stencil and depth tests, blending, masks.
// docs/manual/fragments.md. Does not make or shade fragments.
#pragma once

#include "gw/counters.h"
#include "gw/planes.h"
#include "gw/reference/observer.h"
#include "gw/stages/resolve.h"

namespace gw::reference {

/// The planes and counters that a fragment may change, and its observer.
struct FragmentTarget {
    Planes* planes = nullptr;
    Counters* counters = nullptr;
    Observer* observer = nullptr;
    FragmentBytes bytes;
};

/// `fragment` lies inside the pixel box.
void process_fragment(const Resolved& state, const FragmentTarget& target,
                      const Fragment& fragment);

/// Writes a colour through the colour mask.
void write_color(const ColorMask& mask, const Rgba& color, Rgba& stored);

/// Calls write(plane) with each colour plane of the draw buffer.
template <typename Write>
void for_draw_buffer(const State& state, Planes& planes, const Write& write) {
    const DrawBuffer buffer = state.draw_buffer;
    if (buffer == DrawBuffer::Front || buffer == DrawBuffer::FrontAndBack) write(planes.color);
    if (buffer == DrawBuffer::Back || buffer == DrawBuffer::FrontAndBack) write(planes.back);
}

}  // namespace gw::reference
