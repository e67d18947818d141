// Texture look-up in perspective: coordinates of the mesh.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case texture_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 4);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.depth.test = r.chance(40);
        s.state.alpha = r.chance(15) ? any_alpha(r) : AlphaState{};
        s.state.blend = r.chance(30) ? any_blend(r) : BlendState{};
        const MeshWish wish{.texcoords = true, .most = 6};
        const double z = any_z(r, s.frame);
        draw(s, r.chance(20) ? cover_mesh(r, s.frame, wish, z) : any_mesh(r, s.frame, wish), 100);
        if (r.chance(10)) copy_texture(s, r.pick({Plane::Color, Plane::Depth}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
