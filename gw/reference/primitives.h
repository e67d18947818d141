// The stages of a draw in order: vertices, assembly, clipping, culling, coverage, shading.
// docs/manual/machine.md, "Stages". Each stage except culling has its own file. Does not draw
// pixels of the host.
#pragma once

#include "gw/command_list.h"
#include "gw/reference/fragment.h"
#include "gw/stages/texels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw::reference {

/// The inputs of a draw and the planes that it changes.
struct DrawContext {
    const Draw* draw = nullptr;
    const Profile* profile = nullptr;
    Resolved state;
    FragmentTarget target;
    BoundTexels texels{};
    std::vector<std::uint32_t> fog_table;  ///< fragment fog
};

void draw_mesh(const DrawContext& context);

}  // namespace gw::reference
