// Drawing a mesh: vertices, assembly, clipping, culling, coverage, shading, fragments.
// docs/manual.md, "Stages". Each stage has its own file; this one is their order.
#pragma once

#include "gw/command_list.h"
#include "gw/reference/fragment.h"
#include "gw/stages/texels.h"

#include <cstdint>
#include <vector>

namespace gw::reference {

/// What a draw works with.
struct DrawContext {
    const Draw* draw = nullptr;
    const Profile* profile = nullptr;
    Resolved state;
    FragmentTarget target;
    const Texels* texels = nullptr;        ///< null: texturing is off
    std::vector<std::uint32_t> fog_table;  ///< fragment fog
};

void draw_mesh(const DrawContext& context);

}  // namespace gw::reference
