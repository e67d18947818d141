#include "conformance/generate/draw.h"

#include "conformance/generate/state.h"

#include <algorithm>

namespace gw::conformance {
namespace {

vec3 any_color3(Random& r) { return {any_fraction(r), any_fraction(r), any_fraction(r)}; }

vec3 any_direction(Random& r) {
    return {float(r.real(-1, 1)), float(r.real(-1, 1)), float(r.real(-1, 1))};
}

Light any_light(Random& r, double depth) {
    Light light;
    light.position = vec4(any_direction(r), 0);
    if (r.chance(60)) light.position = vec4(any_direction(r) * float(depth), 1);
    if (r.chance(10)) light.position *= float(r.scaled(0.5, 1, -10, 60));
    light.Ia = any_color3(r);
    light.Id = any_color3(r);
    light.Is = any_color3(r);
    if (r.chance(30)) {
        light.spot_direction = any_direction(r);
        light.spot_exponent = float(r.chance(40) ? r.between(0, 128) : r.real(0, 128));
        light.spot_cos_cutoff = float(r.real(-1, 1));
    }
    if (r.chance(40)) light.constant_attenuation = float(r.real(0, 2));
    if (r.chance(30)) light.linear_attenuation = float(r.real(0, 1) / depth);
    if (r.chance(30)) light.quadratic_attenuation = float(r.real(0, 1) / depth);
    return light;
}

int any_texture_side(Random& r) {
    const int kind = r.below(20);
    if (kind < 14) return 1 << r.between(0, 5);
    return kind < 19 ? r.between(1, 20) : 1 << r.between(6, 9);
}

/// A texel of noise, or of few levels, so that texels repeat.
std::uint16_t any_texel(Random& r, bool noise) {
    return static_cast<std::uint16_t>(noise ? r.bits(16)
                                            : 257 * r.pick({0, 1, 127, 128, 254, 255}));
}

}  // namespace

double eye_depth(const Frame& f) { return f.deep ? std::min(f.far_z, 9 * f.near_z) : 1; }

Material any_material(Random& r) {
    Material m;
    m.Ka = any_color3(r);
    m.Kd = any_color3(r);
    if (r.chance(60)) m.Ks = any_color3(r);
    if (r.chance(40)) m.Ke = any_color3(r);
    m.Ns = r.chance(50) ? float(r.between(0, 40)) : float(r.scaled(0, 1, 0, 13));
    m.alpha = any_fraction(r);
    return m;
}

LightsRef any_lights(Random& r, int most, double depth) {
    std::vector<Light> lights;
    const int count = r.between(0, std::min(most, 4));
    for (int i = 0; i < count; ++i) lights.push_back(any_light(r, depth));
    return std::make_shared<const std::vector<Light>>(std::move(lights));
}

TextureRef any_texture(Random& r) {
    const int width = any_texture_side(r),
              height = width > 64 ? r.between(1, 4) : any_texture_side(r);
    const bool noise = r.chance(60);
    std::vector<std::uint16_t> rgba;
    for (int i = 0; i < 4 * width * height; ++i) rgba.push_back(any_texel(r, noise));
    return make_texture("any", width, height, rgba);
}

TextureBinding any_binding(Script& s) {
    Random& r = s.random;
    if (s.state.texture.shadow_compare && s.depth_slots.empty())
        s.state.texture.shadow_compare = false;
    if (s.state.texture.shadow_compare) return {nullptr, r.pick(s.depth_slots)};
    if (!s.color_slots.empty() && r.chance(30)) return {nullptr, r.pick(s.color_slots)};
    if (!s.depth_slots.empty() && r.chance(10)) return {nullptr, r.pick(s.depth_slots)};
    return {any_texture(r), {}};
}

Draw any_draw(Script& s, MeshRef mesh, int mapped_percent) {
    Random& r = s.random;
    const TextureBinding map = r.chance(mapped_percent) ? any_binding(s) : TextureBinding{};
    Draw d{.mesh = std::move(mesh), .eye_from_object = s.frame.eye_from_object, .map = map};
    if (s.state.color_source == ColorSource::Lighting) {
        d.material = any_material(r);
        if (r.chance(95)) d.lights = any_lights(r, s.out.profile.max_lights, eye_depth(s.frame));
    }
    if (s.state.color_source == ColorSource::PolygonId) {
        d.id_base = r.chance(50) ? 0 : r.bits(32);
        d.id_shift = r.chance(60) ? 0 : r.below(32);
    }
    return d;
}

void draw(Script& s, MeshRef mesh, int mapped_percent) {
    add(s, any_draw(s, std::move(mesh), mapped_percent));
}

}  // namespace gw::conformance
