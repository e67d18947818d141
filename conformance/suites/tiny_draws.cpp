// Hundreds of draws of a few triangles, each with its own matrix and material, in passes that draw
// the same objects again, with changes of state between them.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

#include <utility>

namespace gw::fuzz {
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

}  // namespace gw::fuzz
