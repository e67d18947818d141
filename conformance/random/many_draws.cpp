// Lists of many draws.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <utility>

namespace gw::conformance {

// Hundreds of draws of a few triangles, each with its own matrix and material. Passes draw the same
// objects again, with changes of state between them.

namespace {

struct Object {
    MeshRef mesh;
    dmat4 eye_from_object;
};

std::vector<Object> any_objects(Script& s) {
    Random& r = s.random;
    std::vector<MeshRef> meshes;
    const int shapes = r.between(1, 12);
    for (int i = 0; i < shapes; ++i)
        meshes.push_back(any_mesh(
            r, s.frame, {.normals = r.chance(70), .texcoords = true, .most = r.between(1, 3)}));
    std::vector<Object> objects;
    const int count = r.between(30, 150);
    for (int i = 0; i < count; ++i) {
        Object o{r.pick(meshes), s.frame.eye_from_object};
        for (int axis = 0; axis < 2; ++axis)
            o.eye_from_object[3][axis] += s.frame.far_z * r.between(-8, 8) / 64.0;
        objects.push_back(o);
    }
    return objects;
}

void change_state(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    switch (r.below(12)) {
        case 0: state.shade_model = r.any(ShadeModel::Smooth); return;
        case 1: state.color_source = r.any(ColorSource::PolygonId); return;
        case 2: state.cull = any_cull(r); return;
        case 3: state.stencil = any_stencil(r, s.out.profile); return;
        case 4: state.stencil = {}; return;
        case 5: state.blend = r.chance(50) ? any_blend(r) : BlendState{}; return;
        case 6: state.alpha = r.chance(50) ? any_alpha(r) : AlphaState{}; return;
        case 7: state.color_mask = r.chance(50) ? any_color_mask(r) : ColorMask{}; return;
        case 8: state.jitter = any_jitter(r, s.out.profile); return;
        case 9: state.jitter = {}; return;
        case 10: state.texture = any_texture_state(r); return;
        case 11: state.fog = r.chance(30) ? any_fog(r, eye_depth(s.frame)) : FogState{}; return;
    }
}

void begin_pass(Script& s, int pass) {
    Random& r = s.random;
    s.out.list.add(BeginPass{"pass", r.chance(30) ? all_planes : PlaneMask{0}});
    s.state.depth =
        pass == 0
            ? DepthState{true, DepthFunc::Less, true}
            : DepthState{true, r.chance(70) ? DepthFunc::Equal : DepthFunc::LEqual, r.chance(20)};
    const bool adds = pass > 0 && r.chance(70);
    s.state.blend = {adds, BlendFactor::One, adds ? BlendFactor::One : BlendFactor::Zero};
    s.state.color_source = r.any(ColorSource::Lighting);
}

void draw_objects(Script& s, const std::vector<Object>& objects, int changes_percent) {
    Random& r = s.random;
    const int mapped_percent = r.pick({0, 0, 20, 100});
    for (const Object& object : objects) {
        if (r.chance(changes_percent)) change_state(s);
        s.frame.eye_from_object = object.eye_from_object;
        if (r.chance(97)) draw(s, object.mesh, mapped_percent);
        if (r.chance(1)) add(s, any_clear(r));
        if (r.chance(1)) add(s, any_pixels(r, s.out));
        if (r.chance(2)) between_draws(s);
    }
}

}  // namespace

Case tiny_draws_case(Random& r) {
    Script s = script(r);
    std::vector<Object> objects = any_objects(s);
    const int passes = r.between(1, 3), changes_percent = r.pick({0, 5, 50});
    for (int pass = 0; pass < passes; ++pass) {
        begin_pass(s, pass);
        if (r.chance(20)) std::swap(objects.front(), objects.back());
        draw_objects(s, objects, changes_percent);
    }
    return s.out;
}

// Many textures in turn: new ones, recent ones again, slots refilled between draws.

namespace {

TextureRef small_texture(Random& r) {
    const int width = 1 << r.below(4), height = 1 << r.below(4);
    std::vector<std::uint16_t> rgba;
    for (int i = 0; i < 4 * width * height; ++i)
        rgba.push_back(static_cast<std::uint16_t>(r.bits(16)));
    return make_texture("small", width, height, rgba);
}

TextureBinding next_binding(Script& s, std::vector<TextureRef>& recent) {
    Random& r = s.random;
    if (!s.color_slots.empty() && r.chance(25)) return {nullptr, r.pick(s.color_slots)};
    if (!recent.empty() && r.chance(40)) return {r.pick(recent), {}};
    recent.push_back(small_texture(r));
    return {recent.back(), {}};
}

}  // namespace

Case texture_churn_case(Random& r) {
    Script s = script(r);
    s.state.depth.test = r.chance(50);
    s.state.depth.func = r.pick({DepthFunc::LEqual, DepthFunc::Always, DepthFunc::Equal});
    s.state.blend = r.chance(40) ? any_blend(r) : BlendState{};
    std::vector<MeshRef> meshes;
    for (int i = 0; i < 4; ++i)
        meshes.push_back(any_triangles(r, s.frame, {.texcoords = true, .most = 4}));
    std::vector<TextureRef> recent;
    const int draws = r.between(20, 90);
    for (int i = 0; i < draws; ++i) {
        if (r.chance(30)) s.state.texture = any_texture_state(r);
        if (r.chance(10)) copy_texture(s, Plane::Color);
        Draw d{.mesh = r.pick(meshes), .eye_from_object = s.frame.eye_from_object};
        d.map = next_binding(s, recent);
        const int repeats = r.pick({1, 1, 2, 3});
        for (int k = 0; k < repeats; ++k) add(s, d);
        if (recent.size() > 20) recent.erase(recent.begin(), recent.begin() + 10);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
