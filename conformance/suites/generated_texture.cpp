// Generated coordinates: sphere and refraction maps, projected textures. Slots as textures.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

#include <cmath>

namespace gw::fuzz {
namespace {

dmat4 any_eye_linear(Random& r, const Frame& f) {
    dmat4 m(0);
    const double depth = eye_depth(f);
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 4; ++i)
            m[c][i] = r.chance(40) ? 0 : r.real(-2, 2) / (c < 3 ? depth : 1);
    if (r.chance(60))  // q = 1 or the eye distance
        for (int c = 0; c < 4; ++c) m[c][3] = 0;
    if (m[0][3] == 0 && m[1][3] == 0) r.chance(50) ? m[3][3] = 1 : m[2][3] = -1;
    if (r.chance(8)) m *= std::ldexp(1.0, r.between(-300, 300));
    return m;
}

}  // namespace

Case generated_texture_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.gen = r.chance(10) ? TexGen::None : r.any(TexGen::EyeLinear);
        s.state.texture.eta = r.chance(50) ? r.real(0.4, 2.5) : r.pick({1.0, 0.0, -1.0, 1e200});
        s.state.texture.eye_linear = any_eye_linear(r, s.frame);
        s.state.depth.test = r.chance(40);
        s.state.clip_planes = {};
        if (r.chance(15)) any_clip_planes(r, s.frame, s.state);
        draw(s, any_mesh(r, s.frame, {.normals = true, .texcoords = true, .most = 6}), 100);
        if (r.chance(40)) copy_texture(s, r.pick({Plane::Color, Plane::Color, Plane::Depth}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
