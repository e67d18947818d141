#include "scene/maps/metal.h"

#include "gw/base/arithmetic.h"
#include "scene/maps/mean.h"
#include "scene/maps/physical.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace gw::scene {
namespace {

constexpr std::size_t green = 1, blue = 2, gloss = 3;

/// Whether the same coordinates look up both.
bool is_beside(const Map& a, const Map& b) {
    const auto lookup = [](const Map& m) {
        return std::tuple(m.wrap_s, m.wrap_t, m.scale.x, m.scale.y, m.offset.x, m.offset.y);
    };
    return lookup(a) == lookup(b);
}

/// The texel of a larger grid's x, y.
const std::uint16_t* texel(const Texture& texture, int x, int y, int width, int height) {
    const int i = x * texture.width() / width, j = y * texture.height() / height;
    return texture.levels.front().rgba.data() + 4 * pixel_index(i, j, texture.width());
}

/// encoded and decoded by tables.
class SrgbTables {
public:
    SrgbTables() {
        for (std::size_t i = 0; i < decoded_.size(); ++i)
            decoded_[i] = decoded(dvec3(double(i) / 255)).x;
        for (std::size_t i = 0; i < encoded_.size(); ++i)
            encoded_[i] = double(encoded(dvec3(double(i) / last)).x);
    }
    double decode(std::uint16_t texel) const { return decoded_[rescale(texel, 16, 8)]; }
    double encode(double linear) const {
        return encoded_[std::size_t(round_even(clamp01(linear) * last))];
    }

private:
    static constexpr int last = 1 << 14;
    std::array<double, 256> decoded_{};
    std::array<double, last + 1> encoded_{};
};

/// A texel of a map that is 1 everywhere.
constexpr std::uint16_t white[] = {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};

/// The surface where its map of metal has this texel.
Physical at_texel(const Physical& surface, const std::uint16_t* rgba, const SrgbTables& tables) {
    Physical p = surface;
    if (!p.F0) {
        p.metallic *= rgba[blue] / 65535.0;
        p.roughness *= rgba[green] / 65535.0;
        return p;
    }
    for (int k = 0; k < 3; ++k) (*p.F0)[k] *= tables.decode(rgba[k]);
    p.roughness = 1 - (1 - p.roughness) * (rgba[gloss] / 65535.0);
    return p;
}

/// Of the texels of a map, each as often as it reflects: a highlight is where F0 is.
double mean_roughness(const Physical& surface, const Texture& map, const SrgbTables& tables) {
    const TexelValues& rgba = map.levels.front().rgba;
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const Physical p = at_texel(surface, rgba.data() + i, tables);
        const double weight = metallic_of(p.F0_of_all());
        sum += weight * p.roughness;
        weights += weight;
    }
    return weights > 0 ? sum / weights : surface.roughness;
}

/// Ka, Kd and Ks of each texel: reflection_of with the texels of the maps that are not null.
class SurfaceTexels {
public:
    /// All have the surface's roughness.
    SurfaceTexels(const Physical& surface, const Texture* base, const Texture* metal,
                  const SrgbTables& tables)
        : tables_(tables),
          surface_(surface),
          base_(base),
          metal_(metal),
          width_(std::max(base ? base->width() : 1, metal ? metal->width() : 1)),
          height_(std::max(base ? base->height() : 1, metal ? metal->height() : 1)) {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) add(x, y);
    }

    /// One map for each, in the place of the given one. Ns is that of the mean of all texels, each as
    /// often as it reflects.
    void set(Material& material, Map map) const {
        const auto maps = [&](const std::vector<std::uint16_t>& rgba) {
            map.texture =
                make_texture("texels of " + printable(material.name), width_, height_, rgba);
            return std::vector{map};
        };
        material.Ka = material.Kd = material.Ks = vec3(1);
        material.map_Ka = maps(Ka_);
        material.map_Kd = maps(Kd_);
        material.map_Ks = maps(Ks_);
        material.Ns =
            weights_ > 0
                ? highlight_of(F0s_ / weights_, diffuses_ / weights_, surface_.roughness).Ns
                : 0;
    }

private:
    void add(int x, int y) {
        const std::uint16_t* const base = base_ ? texel(*base_, x, y, width_, height_) : white;
        Physical p =
            metal_ ? at_texel(surface_, texel(*metal_, x, y, width_, height_), tables_) : surface_;
        for (int k = 0; k < 3; ++k) p.base[k] *= tables_.decode(base[k]);
        const double metallic = p.metallic_part(), broad = metallic * surface_.roughness / 2;
        const dvec3 F0 = p.F0_of_all(), diffuse = p.base * (1 - metallic);
        const dvec3 lit = lit_at_peak(F0, diffuse, surface_.roughness);
        for (int k = 0; k < 3; ++k) {
            const double Kd = tables_.encode(diffuse[k]), highlight = tables_.encode(lit[k]) - Kd;
            Ka_.push_back(std::uint16_t(quantize(tables_.encode(diffuse[k] + F0[k]), 16)));
            Kd_.push_back(std::uint16_t(quantize(Kd + highlight * broad, 16)));
            Ks_.push_back(std::uint16_t(quantize(highlight * (1 - broad), 16)));
        }
        for (std::vector<std::uint16_t>* rgba : {&Ka_, &Kd_, &Ks_}) rgba->push_back(base[3]);
        const double weight = metallic_of(F0);
        F0s_ += F0 * weight;
        diffuses_ += diffuse * weight;
        weights_ += weight;
    }

    const SrgbTables& tables_;
    const Physical& surface_;
    const Texture *base_, *metal_;
    int width_, height_;
    std::vector<std::uint16_t> Ka_, Kd_, Ks_;
    dvec3 F0s_{0}, diffuses_{0};
    double weights_ = 0;
};

/// The texture of a map that lies where the colours do; else null, with a warning.
const Texture* texels_beside(const Material& material, const Map& map, const std::string& name,
                             Warnings& warnings) {
    if (map.is_mean) return nullptr;
    if (material.map_Kd.empty() || is_beside(material.map_Kd[0], map)) return map.texture.get();
    warnings.add(map.origin.file, map.origin.line, "metal map",
                 "material '" + printable(material.name) + "': its " + name +
                     " lies in another way than its colours; expected the same, so it is drawn "
                     "with its means");
    return nullptr;
}

/// The mean of a map of metal.
Physical at_mean(const Physical& surface, const Texture& map) {
    Physical p = surface;
    const dvec3 mean = mean_of(map, p.F0.has_value());
    if (p.F0)
        *p.F0 *= mean;
    else
        p.metallic *= mean.z;
    return p;
}

bool is_even(const Texture& map, const Physical& surface) {
    const TexelValues& rgba = map.levels.front().rgba;
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        const std::size_t k = i % 4;
        if ((surface.F0 ? k != gloss : k == blue) && rgba[i] != rgba[k]) return false;
    }
    return true;
}

void apply(Material& material, Warnings& warnings, const SrgbTables& tables) {
    Physical p = *material.physical;
    const Map* const map = material.map_metal.empty() ? nullptr : &material.map_metal[0];
    const Texture* metal = nullptr;
    if (map) {
        p.roughness = mean_roughness(p, *map->texture, tables);
        if (!is_even(*map->texture, p) && (p.F0 || p.metallic > 0))
            metal = texels_beside(material, *map,
                                  p.F0 ? "specularGlossinessTexture" : "metallicRoughnessTexture",
                                  warnings);
        if (!metal) p = at_mean(p, *map->texture);
    }
    const Texture* const base =
        material.map_Kd.empty() ? nullptr : material.map_Kd[0].texture.get();
    if (!metal && (!base || p.metallic_part() == 0)) {
        if (map) set_words(p, material);
        return;
    }
    const Map place = base ? material.map_Kd[0] : *map;
    SurfaceTexels(p, base, metal, tables).set(material, place);
}

}  // namespace

void apply_metal_maps(Scene& scene, Warnings& warnings) {
    std::optional<SrgbTables> tables;
    for (Material& material : scene.materials) {
        if (!material.map_metal.empty() && !material.map_metal[0].texture) continue;
        if (!material.physical) continue;
        if (!tables) tables.emplace();
        apply(material, warnings, *tables);
        material.map_metal.clear();
        material.physical = nullptr;
    }
}

}  // namespace gw::scene
