// Many textures in turn: new ones, recent ones again, slots that are filled again between draws.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {
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

}  // namespace gw::fuzz
