// All state and all commands at once.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

void any_state(Script& s) {
    Random& r = s.random;
    const int width = s.out.width, height = s.out.height;
    const Profile& p = s.out.profile;
    State& state = s.state;
    if (r.chance(20)) state.viewport = any_viewport(r, width, height);
    if (r.chance(20)) state.depth_range = any_depth_range(r);
    if (r.chance(15)) any_clip_planes(r, s.frame, state);
    if (r.chance(20)) state.cull = any_cull(r);
    if (r.chance(20))
        state.polygon_mode = r.chance(70) ? PolygonMode::Fill : r.any(PolygonMode::Line);
    if (r.chance(20)) state.polygon_offset = any_polygon_offset(r, p);
    if (r.chance(20)) state.jitter = any_jitter(r, p);
    if (r.chance(15)) state.point_size = r.between(1, 5);
    if (r.chance(15)) state.line_width = r.between(1, 5);
    if (r.chance(30)) state.shade_model = r.any(ShadeModel::Smooth);
    if (r.chance(30)) state.color_source = r.any(ColorSource::PolygonId);
    if (r.chance(30)) state.lighting = any_lighting(r);
    if (r.chance(25)) state.fog = any_fog(r, eye_depth(s.frame));
    if (r.chance(40)) state.texture = any_texture_state(r);
    if (r.chance(30)) state.texture.gen = r.any(TexGen::EyeLinear);
    state.texture.shadow_compare = p.extensions.shadow_texture && r.chance(20);
    if (r.chance(15)) state.scissor = any_scissor(r, width, height);
    if (r.chance(20)) state.alpha = any_alpha(r);
    if (r.chance(30)) state.stencil = any_stencil(r, p);
    if (r.chance(40)) state.depth = any_depth(r);
    if (r.chance(30)) state.blend = any_blend(r);
    if (r.chance(20)) state.color_mask = any_color_mask(r);
}

void any_command(Script& s, std::vector<MeshRef>& meshes) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 5) return add(s, any_clear(r));
    if (kind < 9) return add(s, any_spans(r, s.out));
    if (kind < 14) return add(s, any_pixels(r, s.out));
    if (kind < 18) return add(s, any_copy(r, s.out));
    if (kind < 22) return copy_texture(s, r.pick({Plane::Color, Plane::Depth}));
    if (kind < 42) return add(s, any_accumulate(r, s.out.profile));
    if (meshes.empty() || r.chance(50))
        meshes.push_back(any_mesh(r, s.frame, {.normals = true, .texcoords = true, .most = 6}));
    draw(s, r.pick(meshes), 50);
}

}  // namespace

static Case everything_with(Random& r, const Profile& profile) {
    Script s = script(r, profile);
    s.state.depth.test = r.chance(60);
    std::vector<MeshRef> meshes;
    const int steps = r.between(2, 12);
    for (int i = 0; i < steps; ++i) {
        any_state(s);
        any_command(s, meshes);
        between_draws(s);
    }
    return s.out;
}

Case everything_case(Random& r) { return everything_with(r, any_profile(r)); }

Case profile_case(Random& r) { return everything_with(r, user_profile(r)); }

}  // namespace gw::conformance
