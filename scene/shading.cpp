#include "scene/shading.h"

#include "gw/elementary.h"
#include "gw/lighting.h"
#include "gw/texgen.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

/// A texel index folded into the image.
int folded(double i, int size, Wrap wrap) {
    if (wrap == Wrap::Clamp) return int(std::clamp(i, 0.0, double(size - 1)));
    return int(i - std::floor(i / size) * size);
}

dvec3 texel(const TextureLevel& level, double i, double j, Wrap wrap) {
    const auto at = 4 * (std::size_t(folded(j, level.height, wrap)) * std::size_t(level.width) +
                         std::size_t(folded(i, level.width, wrap)));
    return dvec3(level.rgba[at], level.rgba[at + 1], level.rgba[at + 2]) / 65535.0;
}

/// Bilinear: texel centres lie at half numbers.
dvec3 in_level(const TextureLevel& level, const dvec2& st, Wrap wrap) {
    const double u = st.x * level.width - 0.5, v = st.y * level.height - 0.5;
    const double i = std::floor(u), j = std::floor(v), f = u - i, g = v - j;
    const dvec3 low = (1 - f) * texel(level, i, j, wrap) + f * texel(level, i + 1, j, wrap);
    const dvec3 high = (1 - f) * texel(level, i, j + 1, wrap) + f * texel(level, i + 1, j + 1, wrap);
    return (1 - g) * low + g * high;
}

/// [GL11] 3.8.1: log2 of the texels that a pixel covers, at least 0.
double level_of_detail(const Texture& texture, const dvec2& dx, const dvec2& dy) {
    const auto length = [&](const dvec2& d) {
        const double u = d.x * texture.width(), v = d.y * texture.height();
        return std::sqrt(u * u + v * v);
    };
    const double rho = std::max(length(dx), length(dy));
    return rho > 1 ? std::min(log(rho) / log(2), double(texture.levels.size() - 1)) : 0;
}

dvec3 sample(const Map& map, Wrap wrap, const dvec2& st, const dvec2& st_dx, const dvec2& st_dy) {
    if (!map.texture) return dvec3(1);
    const dvec2 scale(map.scale), at = st * scale + dvec2(map.offset);
    const double lod = level_of_detail(*map.texture, st_dx * scale, st_dy * scale);
    const auto level = static_cast<std::size_t>(lod);
    const double f = lod - double(level);
    const dvec3 fine = in_level(map.texture->levels[level], at, wrap);
    if (f == 0) return fine;
    return (1 - f) * fine + f * in_level(map.texture->levels[level + 1], at, wrap);
}

double eta(const Material& material) { return material.Ni > 0 ? 1.0 / double(material.Ni) : 1.0; }

}  // namespace

dvec3 sample(const Map& map, const dvec2& st, const dvec2& st_dx, const dvec2& st_dy) {
    return sample(map, map.wrap, st, st_dx, st_dy);
}

dvec3 far_color(std::span<const Map> maps, const dvec3& d) {
    dvec3 sum(0);
    for (const Map& map : maps) sum += sample(map, Wrap::Clamp, sphere_map(d), dvec2(0), dvec2(0));
    return sum;
}

dvec3 map_color(const Material& material, Component component, const SurfacePoint& point) {
    const auto list = maps(material, component);
    if (component == Component::Reflection) return far_color(list, reflected(-point.to_eye, point.n));
    if (component == Component::Refraction)
        return far_color(list, refracted(-point.to_eye, point.n, eta(material)));
    if (list.empty()) return dvec3(1);
    dvec3 sum(0);
    for (const Map& map : list) sum += sample(map, point.st, point.st_dx, point.st_dy);
    return sum;
}

dvec3 light_color(const Material& m, const gw::Light& light, const SurfacePoint& point, double arrives) {
    const bool gloss = m.Ks != vec3(0);
    const LightTerms terms = light_terms(light, point.p, point.n, point.to_eye, double(m.Ns), gloss);
    dvec3 sum = terms.ambient * dvec3(light.Ia) * dvec3(m.Ka) * map_color(m, Component::Ambient, point);
    if (arrives == 0) return sum;
    if (terms.diffuse != 0)
        sum += (arrives * terms.diffuse) * dvec3(light.Id) * dvec3(m.Kd) *
               map_color(m, Component::Diffuse, point);
    if (terms.specular != 0)
        sum += (arrives * terms.specular) * dvec3(light.Is) * dvec3(m.Ks) *
               map_color(m, Component::Specular, point);
    return sum;
}

dvec3 own_color(const Material& material, const SurfacePoint& point) {
    dvec3 sum(0);
    for (const Component c : {Component::Emission, Component::Reflection, Component::Refraction})
        if (has_component(material, c))
            sum += dvec3(coefficient(material, c)) * map_color(material, c, point);
    return sum;
}

dvec3 shade(const Material& material, std::span<const gw::Light> lights, const SurfacePoint& point) {
    dvec3 sum = own_color(material, point);
    for (const gw::Light& light : lights) sum += light_color(material, light, point);
    return sum;
}

}  // namespace gw::scene
