// The alpha test where few or no channels are written: alpha decides depths, stencil values and
// counters that no colour shows.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case alpha_mask_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.alpha = any_alpha(r);
        s.state.alpha.test = true;
        s.state.color_mask =
            r.chance(60) ? ColorMask{false, false, false, false} : any_color_mask(r);
        s.state.depth = any_depth(r);
        s.state.stencil = r.chance(50) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.color_source = r.any(ColorSource::PolygonId);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.fog = r.chance(20) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        if (r.chance(30)) s.state.texture = any_texture_state(r);
        const MeshWish wish{.normals = true, .texcoords = true, .most = 6};
        draw(s, any_mesh(r, s.frame, wish), 40);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
