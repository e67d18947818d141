// The fragment stages after shading: alpha, stencil and depth tests, blending, masks.
// docs/manual/fragments.md. Does not make or shade fragments.
#pragma once

#include "gw/counters.h"
#include "gw/planes.h"
#include "gw/reference/observer.h"
#include "gw/stages/raster/samples.h"
#include "gw/stages/resolve.h"

#include <array>
#include <span>

namespace gw::reference {

/// The planes and counters that a fragment may change, and its observer.
struct FragmentTarget {
    std::span<Planes> samples;  ///< the planes of each sample; one without samples
    Counters* counters = nullptr;
    Observer* observer = nullptr;
    FragmentBytes bytes;
    Planes& planes() const { return samples[0]; }
};

/// The samples that a fragment covers, and its depth at each of them.
struct Covered {
    SampleMask mask = 0;
    std::array<std::uint32_t, max_samples> depth{};
};

/// `fragment` lies inside the pixel box. It covers all samples, with one depth.
void process_fragment(const Resolved& state, const FragmentTarget& target,
                      const Fragment& fragment);
void process_fragment(const Resolved& state, const FragmentTarget& target, const Fragment& fragment,
                      const Covered& covered);

/// Writes these bits of a colour.
void write_color(const Rgba& bits, const Rgba& color, Rgba& stored);

/// Calls write(plane) with each colour plane of the draw buffer.
template <typename Write>
void for_draw_buffer(const State& state, Planes& planes, const Write& write) {
    const DrawBuffer buffer = state.draw_buffer;
    if (buffer == DrawBuffer::Front || buffer == DrawBuffer::FrontAndBack) write(planes.color);
    if (buffer == DrawBuffer::Back || buffer == DrawBuffer::FrontAndBack) write(planes.back);
}

}  // namespace gw::reference
