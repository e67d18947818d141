// Shading one pixel of a primitive: colour, texture, fog, depth; then the fragment's way.
// docs/manual.md, "Stages". Does not decide coverage.
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

    /// o = rne(factor m / 2^16) + rne(units), m the steeper of the depth plane's two gradients.
    void set_depth_offset(const PolygonOffsetState& offset);

    /// Makes the fragment of a covered pixel and sends it on its way.
    void pixel(int x, int y) const;
};

}  // namespace gw::reference
