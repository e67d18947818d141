// Frames of several passes.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <utility>

namespace gw::conformance {

// Many faces of one depth: a prepass, then the same faces by other primitives under Equal.

namespace {

void any_second_pass(Script& s) {
    Random& r = s.random;
    s.state.depth = {true, r.chance(75) ? DepthFunc::Equal : DepthFunc::LEqual, r.chance(20)};
    s.state.blend = {.enable = r.chance(85), .src = BlendFactor::One, .dst = BlendFactor::One};
    s.state.alpha = r.chance(10) ? any_alpha(r) : AlphaState{};
    s.state.stencil = r.chance(25) ? any_stencil(r, s.out.profile) : StencilState{};
    s.state.shade_model = r.any(ShadeModel::Smooth);
    if (r.chance(10)) s.state.jitter = any_jitter(r, s.out.profile);
    if (r.chance(10)) s.state.scissor = any_scissor(r, s.out.width, s.out.height);
    if (r.chance(10)) s.state.cull = any_cull(r);
    if (r.chance(5)) s.state.polygon_mode = r.any(PolygonMode::Fill);
    if (r.chance(5)) s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
}

}  // namespace

Case coincident_case(Random& r) {
    Script s = script(r);
    std::vector<MeshRef> meshes;
    const int count = r.between(1, 3);
    s.state.depth.test = true;
    s.state.color_mask = {r.chance(50), r.chance(50), true, true};
    for (int i = 0; i < count; ++i) {
        meshes.push_back(any_mesh(r, s.frame, {.most = 6}));
        if (i > 0 && r.chance(40)) meshes.back() = same_faces(r, *meshes[0]);
        draw(s, meshes.back());
    }
    s.state.color_mask = {};
    const int passes = r.between(1, 5);
    for (int i = 0; i < passes; ++i) {
        any_second_pass(s);
        for (const MeshRef& mesh : meshes)
            if (r.chance(80)) draw(s, r.chance(70) ? mesh : same_faces(r, *mesh));
        if (r.chance(10)) add(s, any_clear(r));
        between_draws(s);
    }
    return s.out;
}

// The paper's frames: depth, shadow volumes in the stencil, additive passes, fog, samples.

namespace {

constexpr BlendState additive{true, BlendFactor::One, BlendFactor::One};

struct Model {
    std::vector<MeshRef> meshes;
    MeshRef volume;
};

void begin(Script& s, const char* name) {
    s.out.list.add(BeginPass{name, s.random.chance(50) ? all_planes : PlaneMask{0}});
}

void draw_all(Script& s, const Model& model, int mapped_percent) {
    for (const MeshRef& mesh : model.meshes) draw(s, mesh, mapped_percent);
}

void depth_pass(Script& s, const Model& model) {
    begin(s, "depth");
    s.state.depth = {true, DepthFunc::Less, true};
    s.state.color_mask = {false, false, false, false};
    add(s, Clear{mask_of(Plane::Depth) | mask_of(Plane::Stencil)});
    draw_all(s, model, 0);
}

/// Shadow volumes without two-sided stencil: Incr for front faces, Decr for back faces.
void shadow_pass(Script& s, const Model& model) {
    begin(s, "shadow");
    s.state.depth = {true, DepthFunc::Less, false};
    for (const StencilOp op : {StencilOp::Incr, StencilOp::Decr}) {
        s.state.cull = {true, op == StencilOp::Incr ? Face::Back : Face::Front};
        s.state.stencil = {.test = true, .zpass = op};
        if (s.random.chance(30)) std::swap(s.state.stencil.zpass, s.state.stencil.zfail);
        draw(s, model.volume);
    }
    s.state.cull = {};
    s.state.stencil = {};
}

void component_pass(Script& s, const Model& model) {
    Random& r = s.random;
    begin(s, "component");
    s.state.depth = {true, DepthFunc::Equal, false};
    s.state.color_mask = {};
    s.state.blend = additive;
    s.state.color_source = r.chance(80) ? ColorSource::Lighting : ColorSource::Vertex;
    s.state.lighting = any_lighting(r);
    s.state.shade_model = r.chance(85) ? ShadeModel::Smooth : ShadeModel::Flat;
    s.state.stencil = {};
    if (r.chance(60))
        s.state.stencil = {.test = true,
                           .func = r.pick({StencilFunc::Equal, StencilFunc::NotEqual})};
    if (r.chance(10)) s.state.stencil.zpass = StencilOp::Incr;
    s.state.texture = any_texture_state(r);
    s.state.texture.gen =
        r.pick({TexGen::None, TexGen::None, TexGen::SphereMap, TexGen::EyeLinear});
    s.state.fog = {};
    if (r.chance(30)) s.state.fog = any_fog(r, eye_depth(s.frame));
    draw_all(s, model, r.pick({0, 50, 100}));
}

void frame(Script& s, const Model& model) {
    Random& r = s.random;
    depth_pass(s, model);
    s.state.color_mask = {};
    add(s, Clear{mask_of(Plane::Color), any_color(r)});
    const int components = r.between(1, 4);
    for (int i = 0; i < components; ++i) {
        s.state.stencil = {};
        if (r.chance(40)) {
            add(s, Clear{mask_of(Plane::Stencil)});
            s.state.color_mask = {false, false, false, false};
            shadow_pass(s, model);
            s.state.color_mask = {};
        }
        component_pass(s, model);
        if (r.chance(10)) add(s, any_pixels(r, s.out));
        if (r.chance(10)) copy_texture(s, Plane::Color);
        if (r.chance(10)) add(s, any_read(r, s.out));
    }
}

}  // namespace

Case multipass_case(Random& r) {
    Script s = script(r);
    Model model;
    const int count = r.between(1, 3);
    for (int i = 0; i < count; ++i) {
        const MeshWish wish{.normals = true, .texcoords = true, .most = 7};
        model.meshes.push_back(i == 0 && r.chance(40)
                                   ? cover_mesh(r, s.frame, wish, s.frame.far_z * 0.75)
                                   : any_mesh(r, s.frame, wish));
    }
    model.volume = any_triangles(r, s.frame, {.most = 6});
    const int samples = r.chance(60) ? 1 : r.between(2, 4);
    for (int i = 0; i < samples; ++i) {
        s.state = {.projection = s.frame.projection};
        if (samples > 1) s.state.jitter = any_jitter(r, s.out.profile);
        frame(s, model);
        s.state.stencil = {};
        if (samples > 1 || r.chance(30))
            add(s, Accumulate{i == 0 ? AccumOp::Load : AccumOp::Accum, 1});
    }
    if (samples > 1) add(s, Accumulate{AccumOp::Return, 1.0f / float(samples)});
    return s.out;
}

}  // namespace gw::conformance
