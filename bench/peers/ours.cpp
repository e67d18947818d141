// Workloads in the machine's words.
#include "bench/peers/ours.h"

#include <memory>

namespace gw::peers {
namespace {

/// The material with one component left.
Material component(const Material& m, Shade shade) {
    Material out{vec3(0), vec3(0), vec3(0), vec3(0), m.Ns, 1};
    switch (shade) {
        case Shade::Lit: return m;
        case Shade::Ambient: out.Ka = m.Ka; break;
        case Shade::Diffuse: out.Kd = m.Kd; break;
        case Shade::Specular: out.Ks = m.Ks; break;
        case Shade::Reflection: out.Ke = m.Ks; break;
        default: break;
    }
    return out;
}

StencilState stencil_state(Stencil s) {
    switch (s) {
        case Stencil::Off: break;
        case Stencil::Increment: return {.test = true, .zpass = StencilOp::Incr};
        case Stencil::Decrement: return {.test = true, .zpass = StencilOp::Decr};
        case Stencil::OutsideShadow: return {.test = true, .func = StencilFunc::Equal, .ref = 0};
    }
    return {};
}

State pass_state(const Pass& pass, const Frame& frame, const JitterState& jitter) {
    State s = frame.view;
    s.jitter = jitter;
    s.depth = pass.depth, s.blend = pass.blend, s.stencil = stencil_state(pass.stencil);
    if (pass.shade == Shade::None) s.color_mask = {false, false, false, false};
    s.color_source = pass.shade == Shade::Id            ? ColorSource::PolygonId
                     : pass.shade == Shade::VertexColor ? ColorSource::Vertex
                                                        : ColorSource::Lighting;
    if (pass.shade == Shade::VertexColor || pass.shade == Shade::Id)
        s.shade_model = ShadeModel::Flat;
    if (pass.shade == Shade::Reflection) s.texture.gen = TexGen::SphereMap;
    if (pass.stencil == Stencil::Decrement) s.cull.face = Face::Front;
    if (pass.fog != Fog::Off) {
        const vec4 color = pass.fog == Fog::Colored ? vec4(0.4f, 0.45f, 0.5f, 1) : vec4(0, 0, 0, 1);
        s.fog = {.enable = true, .mode = FogMode::Exp, .density = 0.06f, .color = color};
    }
    return s;
}

struct Writer {
    const Frame& frame;
    CommandList list;

    void draw(const Pass& pass, const Part& part, std::uint32_t id_base) {
        Draw d;
        d.mesh = part.mesh, d.eye_from_object = part.eye_from_object;
        d.material = component(part.material, pass.shade);
        if (pass.shade != Shade::None && !frame.lights.empty())
            d.lights = std::make_shared<const std::vector<Light>>(
                std::vector<Light>{frame.lights[std::size_t(pass.light)]});
        if (pass.textured)
            d.map.texture = pass.shade == Shade::Reflection ? frame.sphere_map : frame.texture;
        d.id_base = id_base;
        list.commands.emplace_back(std::move(d));
    }
    void draw(const Pass& pass, const JitterState& jitter) {
        list.commands.emplace_back(SetState{pass_state(pass, frame, jitter)});
        if (pass.geometry == Geometry::Volumes) return draw(pass, frame.volumes, 0);
        if (pass.geometry == Geometry::Quad) {
            Part quad = frame.quad;
            quad.eye_from_object = pass.eye_from_quad;
            return draw(pass, quad, 0);
        }
        std::uint32_t id = 1;
        for (const Part& part : frame.scene) {
            draw(pass, part, id);
            id += part.mesh->polygon_count();
        }
    }
    void sample(const Workload& w, const JitterState& jitter) {
        list.commands.emplace_back(SetState{frame.view});
        list.commands.emplace_back(
            Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth) |
                                      mask_of(Plane::Stencil))});
        for (const Pass& pass : w.passes) draw(pass, jitter);
    }
};

}  // namespace

CommandList command_list(const Workload& w, const Frame& frame) {
    Writer out{frame, {}};
    out.list.commands.emplace_back(BeginPass{w.name});
    for (std::size_t i = 0; i < w.samples.size(); ++i) {
        out.sample(w, w.samples[i]);
        if (w.samples.size() > 1)
            out.list.commands.emplace_back(Accumulate{i == 0 ? AccumOp::Load : AccumOp::Accum, 1});
    }
    if (w.samples.size() > 1) {
        out.list.commands.emplace_back(SetState{frame.view});
        out.list.commands.emplace_back(Accumulate{AccumOp::Return, 1.0f / float(w.samples.size())});
    }
    return std::move(out.list);
}

CommandList moved(CommandList list) {
    for (Command& command : list.commands)
        if (Draw* draw = std::get_if<Draw>(&command)) draw->eye_from_object[3][0] += 1e-12;
    return list;
}

}  // namespace gw::peers
