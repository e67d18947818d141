#include "conformance/generate/units.h"

#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gw::conformance {
namespace {

void any_texels(Random& r, TextureLevel& level) {
    const int most = r.pick({1, 8, 16});
    for (int i = 0; i < 4 * level.width * level.height * level.layers; ++i)
        level.rgba.edit().push_back(std::uint16_t(most == 1 ? 65535 * r.below(2) : r.bits(most)));
}

/// Levels of a texture of any kind, the first of these sides.
TextureRef with_levels(Random& r, Texture t, int width, int height, int layers) {
    const int most = r.between(1, 5);
    while (int(t.levels.size()) < most) {
        TextureLevel level{width, height, {}, layers};
        any_texels(r, level);
        t.levels.push_back(std::move(level));
        if (width == 1 && height == 1 && (layers == 1 || t.cube)) break;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        if (!t.cube) layers = std::max(1, layers / 2);
    }
    return make_texture(std::move(t));
}

TextureRef any_flat(Random& r) {
    Texture t{.name = "flat"};
    t.format = r.any(TextureFormat::Intensity);
    if (r.chance(10)) t.dimensions = 1;
    const int height = t.dimensions == 1 ? 1 : r.between(1, 16), width = r.between(1, 16);
    return with_levels(r, std::move(t), width, height, 1);
}

TextureRef any_kind(Random& r) {
    const int kind = r.below(10);
    if (kind < 4) return any_flat(r);
    return kind < 6 ? any_depths(r) : kind < 8 ? any_cube(r) : any_volume(r);
}

CompareFunc any_func(Random& r) { return r.any<CompareFunc>(); }

void any_sources(Random& r, CombineState& s) {
    for (CombineSource* source : {&s.source0, &s.source1, &s.source2})
        if (r.chance(60)) *source = r.any<CombineSource>();
}

using States = std::array<TextureState, max_texture_units>;

}  // namespace

TextureRef any_depths(Random& r) {
    Texture t{.name = "depths"};
    t.depths = true;
    t.format = r.pick({TextureFormat::Luminance, TextureFormat::Intensity, TextureFormat::Alpha});
    const int height = r.between(1, 20), width = r.between(1, 20);
    return with_levels(r, std::move(t), width, height, 1);
}

TextureRef any_cube(Random& r) {
    Texture t{.name = "cube"};
    t.cube = true;
    t.srgb = r.chance(10);
    t.format = r.chance(30) ? r.any(TextureFormat::Intensity) : TextureFormat::RGBA;
    const int side = r.between(1, 9);
    return with_levels(r, std::move(t), side, side, 6);
}

TextureRef any_volume(Random& r) {
    Texture t{.name = "volume"};
    t.dimensions = 3;
    t.format = r.chance(30) ? r.any(TextureFormat::Intensity) : TextureFormat::RGBA;
    const int layers = r.between(1, 9), height = r.between(1, 9), width = r.between(1, 9);
    return with_levels(r, std::move(t), width, height, layers);
}

TextureState any_state_with_r(Random& r, const TextureRef& texture) {
    TextureState t = any_later_texture_state(r);
    t.wrap_r = r.any<Wrap>();
    t.seamless = r.chance(50);
    t.compare_func = any_func(r);
    t.shadow_compare = texture && texture->depths && r.chance(75);
    return t;
}

void turn(Random& r, TextureState& t) {
    for (int row = 0; row < 3; ++row) {
        const double scale = r.chance(10) ? r.pick({1e-30, 1e6, 1e30, 0.0}) : r.real(0.2, 4);
        for (int c = 0; c < 4; ++c) t.matrix[c][row] = scale * r.real(-1, 1);
    }
    if (r.chance(40))
        for (int c = 0; c < 4; ++c) t.matrix[c][3] = r.real(-0.5, 1);
}

void any_rules(Random& r, TextureState& t) {
    t.gen = TexGen::PerCoordinate;
    for (std::size_t i = 0; i < 4; ++i) {
        CoordinateGen& rule = t.coordinates[i];
        rule.mode = i == 3 ? r.any(CoordinateMode::EyeLinear) : r.any<CoordinateMode>();
        if (i == 2 && rule.mode == CoordinateMode::SphereMap) rule.mode = CoordinateMode::NormalMap;
        if (i == 3 && r.chance(60)) rule.mode = CoordinateMode::Given;
        for (int c = 0; c < 4; ++c) rule.plane[c] = r.real(-2, 2);
    }
}

MeshRef with_units(Random& r, const Mesh& mesh) {
    MeshData data = mesh.data();
    for (UnitTexcoords& unit : data.more_texcoords) {
        if (r.chance(30)) continue;
        const bool projective = r.chance(30);
        for (std::size_t i = 0; i < data.positions.size(); ++i) {
            unit.st.push_back({float(r.real(-1, 2)), float(r.real(-1, 2))});
            if (projective)
                unit.rq.push_back(
                    {float(r.real(-1, 1)), float(r.real(r.chance(90) ? 0.25 : -1, 2))});
        }
    }
    return make_mesh(std::move(data));
}

void any_units(Random& r, State& state, Draw& d) {
    States states;
    MoreBindings more;
    for (std::size_t unit = 0; unit < states.size(); ++unit) {
        const TextureRef texture = r.chance(70) ? any_kind(r) : nullptr;
        TextureState& t = states[unit] = any_state_with_r(r, texture);
        if (r.chance(40)) turn(r, t);
        if (r.chance(15)) t.gen = r.any(TexGen::EyeLinear);
        if (r.chance(15)) any_rules(r, t);
        if (r.chance(50)) {
            t.env = TexEnv::Combine;
            any_combine(r, t);
            any_sources(r, t.combine_rgb);
            any_sources(r, t.combine_alpha);
        }
        (unit == 0 ? d.map : more[unit - 1]).texture = texture;
    }
    state.texture = states[0];
    if (r.chance(85))
        state.more_textures.units = std::make_shared<const std::array<TextureState, 3>>(
            std::array{states[1], states[2], states[3]});
    else
        for (TextureBinding& map : more)
            if (map.texture) map.texture = any_flat(r);
    if (r.chance(90)) d.more_maps = std::make_shared<const MoreBindings>(more);
    CurrentValues current;
    for (vec4& v : current.more_texcoords)
        v = {float(r.real(-1, 2)), float(r.real(-1, 2)), float(r.real(-1, 2)),
             r.chance(70) ? 1.0f : float(r.real(-0.2, 2))};
    if (r.chance(60)) d.current = std::make_shared<const CurrentValues>(current);
}

void also_pixels(Script& s, const Draw& d) {
    DrawPixels pixels = any_draw_pixels(s);
    pixels.map = d.map;
    pixels.more_maps = d.more_maps;
    if (d.current) pixels.raster.more_texcoords = d.current->more_texcoords;
    add(s, std::move(pixels));
}

PointParameters any_point_parameters(Random& r, double depth) {
    const auto any_size = [&] {
        return r.chance(50) ? float(r.between(1, 12)) : float(r.real(1, 9));
    };
    PointParameters p;
    if (r.chance(70))
        p = {float(r.real(-0.2, 1)), float(r.real(-0.2, 2) / depth),
             float(r.real(-0.2, 2) / (depth * depth))};
    if (r.chance(8)) p.quadratic = float(r.scaled(-1, 1, -100, 120));
    if (r.chance(40)) p.min_size = any_size();
    if (r.chance(40)) p.max_size = any_size();
    return p;
}

}  // namespace gw::conformance
