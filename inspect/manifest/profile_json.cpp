#include "inspect/manifest/profile_json.h"

namespace gw::inspect {

nlohmann::ordered_json json_of(const Profile& p) {
    return {
        {"name", p.name},
        {"color_bits", p.color_bits},
        {"depth_bits", p.depth_bits},
        {"stencil_bits", p.stencil_bits},
        {"accum_bits", p.accum_bits},
        {"subpixel_bits", p.subpixel_bits},
        {"lit_bits", p.lit_bits},
        {"max_lights", p.max_lights},
        {"fragment_fog", p.fragment_fog},
        {"perspective_color", p.perspective_color},
        {"extensions",
         {{"polygon_offset", p.extensions.polygon_offset},
          {"shadow_texture", p.extensions.shadow_texture},
          {"stencil_wrap", p.extensions.stencil_wrap},
          {"two_sided_stencil", p.extensions.two_sided_stencil}}},
    };
}

}  // namespace gw::inspect
