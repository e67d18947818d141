#include "scene/draw/shading.h"

#include "gw/base/elementary.h"
#include "gw/stages/lighting.h"
#include "gw/stages/texgen.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gw::scene {
namespace {

/// A texel index folded into the image, whose sides are powers of two.
int folded(double i, int size, Wrap wrap) {
    if (wrap == Wrap::Clamp) return int(std::clamp(i, 0.0, double(size - 1)));
    if (std::abs(i) < 0x1p30) return int(i) & (size - 1);
    return int(i - std::floor(i / size) * size);
}

/// v / 65535 of every 16-bit value: the division would take most of a look-up's time.
const std::vector<double>& fractions() {
    static const std::vector<double> table = [] {
        std::vector<double> t(65536);
        for (std::size_t v = 0; v < t.size(); ++v) t[v] = double(v) / 65535.0;
        return t;
    }();
    return table;
}

/// Row and column of the four texels around a point, and how far it is from the first.
struct TexelPlace {
    std::array<std::size_t, 2> row, column;
    double f, g;
};

/// In s and in t.
struct Wraps {
    Wrap s, t;
};

TexelPlace place_in(const TextureLevel& level, const dvec2& st, Wraps wraps) {
    const double u = st.x * level.width - 0.5, v = st.y * level.height - 0.5;
    const double i = std::floor(u), j = std::floor(v);
    const auto row = [&](double k) {
        return std::size_t(folded(k, level.height, wraps.t)) * std::size_t(level.width);
    };
    const auto column = [&](double k) { return std::size_t(folded(k, level.width, wraps.s)); };
    return {{row(j), row(j + 1)}, {column(i), column(i + 1)}, u - i, v - j};
}

/// Bilinear: texel centres lie at half numbers.
dvec3 in_level(const TextureLevel& level, const dvec2& st, Wraps wraps) {
    const TexelPlace p = place_in(level, st, wraps);
    const double* fraction = fractions().data();
    const auto texel = [&](std::size_t row, std::size_t column) {
        const std::uint16_t* rgba = &level.rgba[4 * (p.row[row] + p.column[column])];
        return dvec3(fraction[rgba[0]], fraction[rgba[1]], fraction[rgba[2]]);
    };
    const dvec3 low = (1 - p.f) * texel(0, 0) + p.f * texel(0, 1);
    const dvec3 high = (1 - p.f) * texel(1, 0) + p.f * texel(1, 1);
    return (1 - p.g) * low + p.g * high;
}

/// [GL11] 3.8.1: log2 of the texels that a pixel covers, at least 0.
double level_of_detail(const Texture& texture, const dvec2& dx, const dvec2& dy) {
    const auto length = [&](const dvec2& d) {
        const double u = d.x * texture.width(), v = d.y * texture.height();
        return std::sqrt(u * u + v * v);
    };
    static const double log_2 = log(2);
    const double rho = std::max(length(dx), length(dy));
    return rho > 1 ? std::min(log(rho) / log_2, double(texture.levels.size() - 1)) : 0;
}

dvec3 sample(const Map& map, Wraps wraps, const dvec2& st, const dvec2& st_dx, const dvec2& st_dy) {
    if (!map.texture) return dvec3(1);
    const dvec2 scale(map.scale), at = st * scale + dvec2(map.offset);
    const double lod = level_of_detail(*map.texture, st_dx * scale, st_dy * scale);
    const auto level = std::size_t(lod);
    const double f = lod - double(level);
    const dvec3 fine = in_level(map.texture->levels[level], at, wraps);
    if (f == 0) return fine;
    return (1 - f) * fine + f * in_level(map.texture->levels[level + 1], at, wraps);
}

double eta(const Material& material) { return material.Ni > 0 ? 1.0 / double(material.Ni) : 1.0; }

}  // namespace

dvec3 sample(const Map& map, const dvec2& st, const dvec2& st_dx, const dvec2& st_dy) {
    return sample(map, {map.wrap_s, map.wrap_t}, st, st_dx, st_dy);
}

dvec3 far_color(std::span<const Map> maps, const dvec3& d) {
    dvec3 sum(0);
    for (const Map& map : maps)
        sum += sample(map, {Wrap::Clamp, Wrap::Clamp}, sphere_map(d), dvec2(0), dvec2(0));
    return sum;
}

dvec3 map_color(const Material& material, Component component, const SurfacePoint& point) {
    const auto list = maps(material, component);
    if (component == Component::Reflection)
        return far_color(list, reflected(-point.to_eye, point.n));
    if (component == Component::Refraction)
        return far_color(list, refracted(-point.to_eye, point.n, eta(material)));
    if (list.empty()) return dvec3(1);
    dvec3 sum(0);
    for (const Map& map : list) sum += sample(map, point.st, point.st_dx, point.st_dy);
    return sum;
}

const dvec3& MapColors::of(Component component) {
    // The ambient component's maps may be the diffuse ones.
    if (component == Component::Ambient && material_.map_Ka.empty()) component = Component::Diffuse;
    auto& color = component == Component::Ambient   ? ambient_
                  : component == Component::Diffuse ? diffuse_
                                                    : specular_;
    if (!color) color = map_color(material_, component, point_);
    return *color;
}

dvec3 light_color(const Material& m, const gw::Light& light, const SurfacePoint& point,
                  MapColors& maps, double arrives) {
    const bool gloss = arrives != 0 && m.Ks != vec3(0);
    const LightTerms terms =
        light_terms(light, point.p, point.n, point.to_eye, double(m.Ns), gloss);
    dvec3 sum = terms.ambient * dvec3(light.Ia) * dvec3(m.Ka) * maps.of(Component::Ambient);
    if (arrives == 0) return sum;
    if (terms.diffuse != 0)
        sum +=
            (arrives * terms.diffuse) * dvec3(light.Id) * dvec3(m.Kd) * maps.of(Component::Diffuse);
    if (terms.specular != 0)
        sum += (arrives * terms.specular) * dvec3(light.Is) * dvec3(m.Ks) *
               maps.of(Component::Specular);
    return sum;
}

dvec3 light_color(const Material& m, const gw::Light& light, const SurfacePoint& point,
                  double arrives) {
    MapColors maps(m, point);
    return light_color(m, light, point, maps, arrives);
}

dvec3 own_color(const Material& material, const SurfacePoint& point) {
    dvec3 sum(0);
    for (const Component c : {Component::Emission, Component::Reflection, Component::Refraction})
        if (has_component(material, c))
            sum += dvec3(coefficient(material, c)) * map_color(material, c, point);
    return sum;
}

dvec3 shade(const Material& material, std::span<const gw::Light> lights,
            const SurfacePoint& point) {
    dvec3 sum = own_color(material, point);
    MapColors maps(material, point);
    for (const gw::Light& light : lights) sum += light_color(material, light, point, maps);
    return sum;
}

std::string_view name_of(Component component) {
    switch (component) {
        case Component::Ambient: return "ambient";
        case Component::Diffuse: return "diffuse";
        case Component::Specular: return "specular";
        case Component::Reflection: return "reflection";
        case Component::Refraction: return "refraction";
        case Component::Emission: return "emission";
    }
    return "";
}

vec3 coefficient(const Material& material, Component component) {
    switch (component) {
        case Component::Ambient: return material.Ka;
        case Component::Diffuse: return material.Kd;
        case Component::Specular: return material.Ks;
        case Component::Reflection: return material.Ks;
        case Component::Refraction: return material.Tf;
        case Component::Emission: return material.Ke;
    }
    return vec3(0);
}

std::span<const Map> maps(const Material& material, Component component) {
    switch (component) {
        case Component::Ambient: return material.map_Ka.empty() ? material.map_Kd : material.map_Ka;
        case Component::Diffuse: return material.map_Kd;
        case Component::Specular: return material.map_Ks;
        case Component::Reflection: return material.refl;
        case Component::Refraction: return material.refraction;
        case Component::Emission: return material.map_Ke;
    }
    return {};
}

bool has_component(const Material& material, Component component) {
    const bool by_map = component == Component::Reflection || component == Component::Refraction;
    return coefficient(material, component) != vec3(0) &&
           !(by_map && maps(material, component).empty());
}

const Map* hardware_map(const Material& material) {
    for (const auto* list :
         {&material.map_Kd, &material.map_Ka, &material.map_Ks, &material.map_Ke})
        if (!list->empty()) return &list->front();
    return nullptr;
}

}  // namespace gw::scene
