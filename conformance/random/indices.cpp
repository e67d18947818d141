// Colours that are indices of a map, as IRIS GL's door draws them.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "gw/base/arithmetic.h"

#include <algorithm>
#include <utility>

namespace gw::conformance {
namespace {

using inspect::ColorMap;
using inspect::IndexPlanes;

/// Mostly of IRIS GL's form, of few bits so that a recording is small.
ColorMap any_map(Random& r) {
    ColorMap map{.planes = r.chance(60) ? IndexPlanes::Window : r.any(IndexPlanes::PopUp)};
    map.bits = r.chance(80) ? r.between(1, 8) : r.between(9, 11);
    map.bits_in_r = r.chance(60) ? 8 : r.between(1, 11);
    for (int i = 0; i < 1 << map.bits; ++i) map.entries.push_back(r.bits(24));
    return map;
}

/// [R18.2] The pixel that holds an index.
Rgba pixel_of(const ColorMap& map, unsigned index, const Profile& p) {
    const std::uint32_t most = max_of_bits(p.color_bits);
    return {std::uint16_t(index & ((1u << map.bits_in_r) - 1) & most),
            std::uint16_t((index >> map.bits_in_r) & most), 0, std::uint16_t(most)};
}

vec4 color_of(const Rgba& pixel, const Profile& p) {
    const auto most = float(max_of_bits(p.color_bits));
    return {float(pixel[0]) / most, float(pixel[1]) / most, float(pixel[2]) / most, 1};
}

unsigned any_index(Random& r, const ColorMap& map) {
    return r.chance(15) ? 0 : r.bits(std::max(map.bits, 1));
}

/// A texture whose texel i is the pixel of index i. [R18.3]
TextureRef index_texture(const ColorMap& map, const Profile& p) {
    std::vector<std::uint16_t> texels;
    const std::uint32_t most = max_of_bits(p.color_bits);
    for (unsigned i = 0; i < 1u << map.bits; ++i)
        for (const std::uint32_t v : pixel_of(map, i, p))
            texels.push_back(std::uint16_t((v * 65535 + most / 2) / most));
    return make_texture("indices", 1 << map.bits, 1, texels);
}

/// A mesh of one index, or shaded between several.
void draw_indices(Script& s, const ColorMap& map) {
    Random& r = s.random;
    const Profile& p = s.out.profile;
    const bool shaded = r.chance(40) && map.bits <= 8;
    MeshData data = any_triangles(r, s.frame, {.texcoords = true, .most = 4})->data();
    data.colors.assign(data.positions.size(), color_of(pixel_of(map, any_index(r, map), p), p));
    const auto texels = float(1 << map.bits);
    for (vec2& st : data.texcoords) st = {(float(any_index(r, map)) + 0.5f) / texels, 0.5f};
    s.state.texture = {};
    s.state.texture.env = TexEnv::Replace;
    s.state.texture.min_filter = MinFilter::Nearest;
    s.state.texture.mag_filter = MagFilter::Nearest;
    Draw d = any_draw(s, make_mesh(std::move(data)));
    if (shaded) d.map = {index_texture(map, p), {}};
    add(s, std::move(d));
}

void any_indices_step(Script& s, const ColorMap& map) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 10) {
        const Rgba pixel = pixel_of(map, any_index(r, map), s.out.profile);
        return add(s, Clear{mask_of(Plane::Color), color_of(pixel, s.out.profile)});
    }
    if (kind < 25) return add(s, any_pixels(r, s.out));  // any bits, also beside the index
    if (kind < 35) return add(s, any_copy(r, s.out));
    draw_indices(s, map);
}

/// IRIS GL's writemask.
void set_writemask(State& s, const ColorMap& map, unsigned mask) {
    s.color_mask_bits = {std::uint16_t(mask & ((1u << map.bits_in_r) - 1)),
                         std::uint16_t(mask >> map.bits_in_r)};
    s.color_mask = {true, true, false, false};
}

}  // namespace

Case indices_case(Random& r) {
    Script s = script(r, r.chance(50) ? any_profile(r) : any_opengl_profile(r));
    ColorMap map = any_map(r);
    s.out.maps.push_back({s.out.list.commands.size(), map});
    const int steps = r.between(3, 9);
    for (int i = 0; i < steps; ++i) {
        s.state.color_mask_bits = {};
        s.state.color_mask = {};
        if (r.chance(40)) set_writemask(s.state, map, r.bits(11));
        const bool has_logic = s.out.profile.extensions.logic_op;
        s.state.logic_op = has_logic && r.chance(20) ? any_logic_op(r) : LogicOpState{};
        s.state.shade_model = ShadeModel::Flat;
        any_indices_step(s, map);
        if (r.chance(20)) s.out.maps.push_back({s.out.list.commands.size(), {}});
        if (!r.chance(40)) continue;
        map = r.chance(15) ? ColorMap{} : any_map(r);
        s.out.maps.push_back({s.out.list.commands.size(), map});
        if (map.bits == 0) map = any_map(r);  // what is drawn; it is shown as colours
    }
    if (s.out.maps.back().command == s.out.list.commands.size()) add(s, any_read(r, s.out));
    return s.out;
}

}  // namespace gw::conformance
