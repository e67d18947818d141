#include "multipass/passes/pass.h"

#include "gw/escape_controls.h"
#include "multipass/passes/tokens.h"

#include <fmt/format.h>

namespace gw::multipass {
namespace {

std::string to_string(const Parameter& p) {
    if (p.kind != Parameter::Kind::Value) return std::string(token(p.kind));
    const auto& v = p.value;
    if (v[0] == v[1] && v[1] == v[2]) return fmt::format("{}", v[0]);
    return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

std::string depth_text(const DepthState& depth) {
    if (!depth.test) return "";
    return fmt::format("; depth {}{}", token(depth.func), depth.mask ? ", update" : ", no update");
}

std::string stencil_text(const StencilState& s) {
    if (!s.test) return "";
    std::string text = fmt::format("; stencil {} {}", token(s.func), s.ref);
    if (!keeps_stencil(s.front()))
        text += fmt::format(" ({} {} {})", token(s.fail), token(s.zfail), token(s.zpass));
    return text;
}

std::string blend_text(const BlendState& b) {
    if (!b.enable) return "";
    std::string text = fmt::format("; blend {} {}", token(b.src), token(b.dst));
    if (b.equation != BlendEquation::Add) text += fmt::format(", {}", token(b.equation));
    const BlendAlphaState& a = b.alpha;
    if (a.separate)
        text += fmt::format(", alpha {} {} {}", token(a.src), token(a.dst), token(a.equation));
    const vec4& c = b.color;
    if (c != vec4(0)) text += fmt::format(", color ({}, {}, {}, {})", c.x, c.y, c.z, c.w);
    return text;
}

std::string objects_text(const Pass& pass) {
    if (pass.objects == PassObjects::All) return "";
    if (pass.objects != PassObjects::Named) return fmt::format("; objects {}", token(pass.objects));
    return fmt::format("; objects {}", fmt::join(pass.names, ", "));
}

std::string clear_text(PlaneMask planes) {
    std::string text;
    for (const auto& [plane, name] : tokens(Plane{}))
        if (planes & mask_of(plane)) text += (text.empty() ? "; clear " : ", ") + std::string(name);
    return text;
}

std::string action_text(const Pass& pass) {
    switch (pass.action) {
        case PassAction::Draw: return to_string(pass.material);
        case PassAction::Shadow: return "stencil := in the light's shadow";
        case PassAction::Add: return "accumulation += frame buffer, colour := 0";
        case PassAction::Trace: return "pixels := reflection and transmission by rays";
    }
    return "";
}

}  // namespace

bool is_additive(const Pass& pass) {
    return pass.depth.test && pass.depth.func == DepthFunc::Equal && pass.blend.enable &&
           keeps_stencil(pass.stencil.front());
}

bool is_layer_pass(const Pass& pass) {
    return pass.action == PassAction::Draw && pass.objects == PassObjects::Translucent &&
           pass.depth.test && pass.depth.func == DepthFunc::Equal;
}

std::string to_string(const PassMaterial& m) {
    return fmt::format("(Ka={}, Kd={}, Ks={}, Ke={}, Map={})", to_string(m.Ka), to_string(m.Kd),
                       to_string(m.Ks), to_string(m.Ke), token(m.Map));
}

std::string to_string(const Pass& pass) {
    std::string text = fmt::format("{:<11} ", escape_controls(pass.name.view()));
    text += action_text(pass);
    if (pass.lights != PassLights::None) text += fmt::format("; lights {}", token(pass.lights));
    text += objects_text(pass) + depth_text(pass.depth) + stencil_text(pass.stencil) +
            blend_text(pass.blend);
    if (pass.fog != PassFog::None) text += fmt::format("; fog {}", token(pass.fog));
    text += clear_text(pass.clear);
    if (!pass.color) text += "; no colour";
    return text;
}

}  // namespace gw::multipass
