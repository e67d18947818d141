// Textures: coordinates of the mesh, generated ones, shadow maps.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <cmath>

namespace gw::conformance {

// Texture look-up in perspective: coordinates of the mesh.
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

// Generated coordinates: sphere and refraction maps, projected textures. Slots as textures.

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

// Shadow maps: a depth pass copied to a slot, then draws that compare r with the slot.

namespace {

/// Gives s, t, r in 0 .. 1 over the frame's picture and depths, from a slightly moved eye; q is the
/// eye distance in a deep frame.
dmat4 shadow_matrix(Random& r, const Frame& f) {
    const dmat4& p = f.projection;
    dmat4 m(0);
    for (int c = 0; c < 4; ++c) {
        for (int i = 0; i < 3; ++i) m[c][i] = 0.5 * (p[c][i] + p[c][3]);
        m[c][3] = p[c][3];
    }
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 3; ++i) m[c][i] *= 1 + (r.chance(50) ? 0 : r.real(-0.25, 0.25));
    if (r.chance(30)) m[3][2] += r.real(-0.02, 0.02);
    return m;
}

Profile shadow_profile(Random& r) {
    Profile p = r.chance(40) ? reality() : r.chance(50) ? ideal() : user_profile(r);
    p.extensions.shadow_texture = true;
    return p;
}

}  // namespace

Case shadow_case(Random& r) {
    Script s = script(r, shadow_profile(r));
    s.state.depth.test = true;
    draw(s, any_triangles(r, s.frame, {.most = 6}));
    copy_texture(s, Plane::Depth);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.gen = r.chance(90) ? TexGen::EyeLinear : r.any(TexGen::EyeLinear);
        s.state.texture.eye_linear = shadow_matrix(r, s.frame);
        s.state.texture.shadow_compare = r.chance(85);
        s.state.depth.func = r.pick({DepthFunc::Less, DepthFunc::LEqual, DepthFunc::Always});
        const MeshWish wish{.normals = true, .texcoords = true, .most = 6};
        const double z = any_z(r, s.frame);
        draw(s, r.chance(30) ? cover_mesh(r, s.frame, wish, z) : any_mesh(r, s.frame, wish), 100);
        if (r.chance(30)) copy_texture(s, Plane::Depth);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
