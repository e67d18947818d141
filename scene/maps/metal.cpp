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

struct Means {
    double roughness = 0, metallic = 0;
    bool is_even = true;  ///< of the metallic part
};

Means means_of(const Texture& texture) {
    const TexelValues& rgba = texture.levels.front().rgba;
    Means means;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        means.roughness += rgba[i + green];
        means.metallic += rgba[i + blue];
        means.is_even = means.is_even && rgba[i + blue] == rgba[blue];
    }
    const double whole = 65535.0 * double(rgba.size() / 4);
    means.roughness /= whole;
    means.metallic /= whole;
    return means;
}

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

/// encoded(1 - m), for m = k / 255: what a metallic part leaves of Kd.
std::array<float, 256> rests() {
    std::array<float, 256> rests{};
    for (std::size_t k = 0; k < rests.size(); ++k) rests[k] = encoded(dvec3(1 - double(k) / 255)).x;
    return rests;
}

/// Kd and Ks of each texel, relative to the material's.
class TexelMaker {
public:
    TexelMaker(Material& material, const Physical& surface)
        : material_(material),
          base_(material.map_Kd.empty() ? nullptr : material.map_Kd[0].texture),
          metal_(*material.map_metal[0].texture),
          metallic_(surface.metallic) {
        Physical p = surface;
        p.metallic = 0;
        dielectric_ = reflection_of(p);
        p.metallic = 1;
        pure_ = reflection_of(p);
    }

    void set(double mean_metallic) {
        const float part = float(metallic_ * mean_metallic);
        material_.Ka = dielectric_.diffuse;
        material_.Kd = glm::max(dielectric_.Kd(), pure_.Kd());
        material_.Ks = glm::max(dielectric_.Ks(), pure_.Ks());
        material_.Ns = dielectric_.Ns + (pure_.Ns - dielectric_.Ns) * part;
        Map map = material_.map_metal[0];
        make_texels();
        material_.map_Ka = material_.map_Kd;
        if (material_.map_Ka.empty()) {  // else the map of Kd would stand for it
            map.texture = make_texture8("white", 1, 1, std::vector<std::uint8_t>(4, 255));
            material_.map_Ka = {map};
        }
        map.texture = make_texture(metal_.name, width_, height_, Kd_);
        material_.map_Kd = {map};
        map.texture = make_texture(metal_.name, width_, height_, Ks_);
        material_.map_Ks = {map};
    }

private:
    void make_texels() {
        width_ = std::max(metal_.width(), base_ ? base_->width() : 1);
        height_ = std::max(metal_.height(), base_ ? base_->height() : 1);
        const std::array<float, 256> rest = rests();
        constexpr std::array<std::uint16_t, 4> white{0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const std::uint16_t* const base =
                    base_ ? texel(*base_, x, y, width_, height_) : white.data();
                const double m = metallic_ * texel(metal_, x, y, width_, height_)[blue] / 65535.0;
                const double left = double(rest[std::size_t(quantize(m, 8))]);
                for (int k = 0; k < 3; ++k) add(base[k] / 65535.0, m, left, k);
                Kd_.push_back(base[3]);
                Ks_.push_back(base[3]);
            }
    }

    void add(double base, double m, double left, int k) {
        const double of_metal = m * double(pure_.highlight[k]) * base;
        const double broad = of_metal * double(pure_.broad);
        const double Kd = base * left * double(dielectric_.diffuse[k]) + broad;
        const double Ks = (1 - m) * double(dielectric_.highlight[k]) + of_metal - broad;
        Kd_.push_back(part_of(Kd, double(material_.Kd[k])));
        Ks_.push_back(part_of(Ks, double(material_.Ks[k])));
    }

    static std::uint16_t part_of(double value, double most) {
        return most > 0 ? std::uint16_t(quantize(std::min(value / most, 1.0), 16)) : 0;
    }

    Material& material_;
    TextureRef base_;
    const Texture& metal_;
    double metallic_;
    Reflection dielectric_, pure_;
    int width_ = 1, height_ = 1;
    std::vector<std::uint16_t> Kd_, Ks_;
};

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

/// Ka, Kd and Ks of each texel of a surface with F0: reflection_of with the surface's base and F0 times
/// the texels of the maps that are not null.
class GlossTexels {
public:
    GlossTexels(const Physical& surface, const Texture* base, const Texture* F0)
        : surface_(surface),
          factor_(*surface.F0),
          base_(base),
          F0_(F0),
          width_(std::max(base ? base->width() : 1, F0 ? F0->width() : 1)),
          height_(std::max(base ? base->height() : 1, F0 ? F0->height() : 1)) {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) add(x, y);
    }

    /// One map for each, in the place of the given one.
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
    }

private:
    void add(int x, int y) {
        const std::uint16_t* const base = base_ ? texel(*base_, x, y, width_, height_) : white;
        const std::uint16_t* const of_F0 = F0_ ? texel(*F0_, x, y, width_, height_) : white;
        dvec3 diffuse = surface_.base, F0 = factor_;
        for (int k = 0; k < 3; ++k) {
            diffuse[k] *= tables_.decode(base[k]);
            F0[k] *= tables_.decode(of_F0[k]);
        }
        const double metallic = metallic_of(F0), broad = metallic * surface_.roughness / 2;
        diffuse *= 1 - metallic;
        const dvec3 lit = lit_at_peak(F0, diffuse, surface_.roughness);
        for (int k = 0; k < 3; ++k) {
            const double Kd = tables_.encode(diffuse[k]), highlight = tables_.encode(lit[k]) - Kd;
            Ka_.push_back(std::uint16_t(quantize(tables_.encode(diffuse[k] + F0[k]), 16)));
            Kd_.push_back(std::uint16_t(quantize(Kd + highlight * broad, 16)));
            Ks_.push_back(std::uint16_t(quantize(highlight * (1 - broad), 16)));
        }
        for (std::vector<std::uint16_t>* rgba : {&Ka_, &Kd_, &Ks_}) rgba->push_back(base[3]);
    }

    static constexpr std::uint16_t white[] = {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
    const SrgbTables tables_;
    const Physical& surface_;
    const dvec3 factor_;
    const Texture *base_, *F0_;
    int width_, height_;
    std::vector<std::uint16_t> Ka_, Kd_, Ks_;
};

double mean_gloss(const Texture& texture) {
    const TexelValues& rgba = texture.levels.front().rgba;
    double sum = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) sum += rgba[i + gloss] / 65535.0;
    return sum / double(rgba.size() / 4);
}

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

/// A surface with F0: the map has factors of it and of the glossiness.
void apply_specular_glossiness(Material& material, Warnings& warnings) {
    Physical p = *material.physical;
    const Map* const map = material.map_metal.empty() ? nullptr : &material.map_metal[0];
    const Texture* F0 = nullptr;
    if (map) {
        p.roughness = 1 - (1 - p.roughness) * mean_gloss(*map->texture);
        F0 = texels_beside(material, *map, "specularGlossinessTexture", warnings);
        if (!F0) *p.F0 *= mean_of(*map->texture, true);
    }
    const Texture* const base =
        material.map_Kd.empty() ? nullptr : material.map_Kd[0].texture.get();
    if (!base && !F0) return set_words(p, material);
    const Map place = base ? material.map_Kd[0] : *map;
    GlossTexels(p, base, F0).set(material, place);
    if (base) p.base *= mean_of(*base, true);
    if (F0) *p.F0 *= mean_of(*F0, true);
    material.Ns = reflection_of(p).Ns;
}

void apply_metallic_roughness(Material& material, Warnings& warnings) {
    const Map& map = material.map_metal[0];
    const Means means = means_of(*map.texture);
    Physical p = *material.physical;
    p.roughness *= means.roughness;
    if (!means.is_even && texels_beside(material, map, "metallicRoughnessTexture", warnings) &&
        p.metallic > 0)
        return TexelMaker(material, p).set(means.metallic);
    p.metallic *= means.metallic;
    set_words(p, material);
    if (p.metallic > 0.5) material.map_Ks = material.map_Kd;
}

}  // namespace

void apply_metal_maps(Scene& scene, Warnings& warnings) {
    for (Material& material : scene.materials) {
        if (!material.map_metal.empty() && !material.map_metal[0].texture) continue;
        if (!material.physical) continue;
        if (material.physical->F0)
            apply_specular_glossiness(material, warnings);
        else if (!material.map_metal.empty())
            apply_metallic_roughness(material, warnings);
        else if (material.physical->metallic > 0.5)
            material.map_Ks = material.map_Kd;
        material.map_metal.clear();
        material.physical = nullptr;
    }
}

}  // namespace gw::scene
