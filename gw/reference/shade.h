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

    /// Makes the fragment of a covered pixel and passes it to process_fragment.
    void pixel(int x, int y) const;
};

}  // namespace gw::reference
