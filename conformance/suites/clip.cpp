// Clipping: planes through the picture, vertices behind the eye, w of any size.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

#include <cmath>

namespace gw::fuzz {
namespace {

/// A matrix that need not be a projection.
dmat4 any_projection(Random& r) {
    dmat4 p(0);
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 4; ++i) p[c][i] = r.chance(40) ? r.between(-2, 2) : r.real(-2, 2);
    if (r.chance(20)) p *= std::ldexp(1.0, r.between(-900, 900));
    return p;
}

/// Rotates and scales eye space, seldom so far that squares overflow.
dmat4 any_affine(Random& r) {
    dmat4 m(1);
    const double size = r.chance(10) ? std::ldexp(1.0, r.between(-600, 900)) : 1;
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 3; ++i)
            m[c][i] = size * (r.chance(30) ? r.between(-2, 2) : r.real(-2, 2));
    return m;
}

}  // namespace

Case clip_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.clip_planes = {};
        if (r.chance(50)) any_clip_planes(r, s.frame, s.state);
        s.state.cull = any_cull(r);
        s.state.depth = {.test = r.chance(60)};
        s.state.polygon_mode = r.chance(85) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.projection = s.frame.projection;
        Frame frame = s.frame;
        if (r.chance(25)) {
            s.state.projection = any_projection(r);
            s.frame.eye_from_object = any_affine(r);
        }
        if (r.chance(20)) s.state.fog = any_fog(r, eye_depth(frame));
        if (r.chance(20))
            s.state.color_source = r.pick({ColorSource::Vertex, ColorSource::Lighting});
        s.state.texture.gen = r.any(TexGen::EyeLinear);
        draw(s, any_mesh(r, frame, {.normals = true, .texcoords = true}), 20);
        s.frame = frame;
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
