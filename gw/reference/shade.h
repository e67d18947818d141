// Shading of one pixel of a primitive: colour, texture, fog, depth. docs/manual/machine.md,
// "Stages". Does not decide coverage or test fragments.
#pragma once

#include "gw/reference/interpolants.h"
#include "gw/reference/primitives.h"

namespace gw::reference {

struct Shader {
    const DrawContext& context;
    Interpolants values;
    std::uint32_t primitive = 0;
    bool front = true;
    std::int64_t depth_offset = 0;

    /// Makes the fragment of a covered pixel and passes it to process_fragment. `coverage`: of a
    /// smooth primitive.
    void pixel(int x, int y, std::uint32_t coverage = 0) const;
    /// The same if the pixel's centre is outside the primitive.
    void outside_pixel(int x, int y, std::uint32_t coverage) const;
    /// The same for a pixel of which these samples are covered, each with a depth of its own. Colour
    /// and texels are those of the centre or, if it is not `covered`, of the first sample.
    void samples(int x, int y, SampleMask mask, bool covered) const;

private:
    std::uint32_t depth_of(const PlaneEquation& plane, int x, int y) const;
};

}  // namespace gw::reference
