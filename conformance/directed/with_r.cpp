// Textures with r where a wrong rule gives another texel: depths between two steps, equal values
// compared, directions on the edges of a cube, and the direction that is none.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"

#include <array>
#include <initializer_list>
#include <memory>
#include <utility>

namespace gw::conformance {
namespace {

constexpr int r_side = 8;

void add_texel(TextureLevel& level, const Rgba& texel) {
    for (const std::uint16_t v : texel) level.rgba.edit().push_back(v);
}

/// One depth.
Texture depth_texture(std::uint32_t depth) {
    Texture t{.name = "depth", .format = TextureFormat::Luminance};
    t.depths = true;
    TextureLevel level{1, 1, {}};
    add_texel(level, {std::uint16_t(depth >> 16), std::uint16_t(depth & 0xFFFF), 0, 0});
    t.levels.push_back(std::move(level));
    return t;
}

/// Levels of noise; `layers` is halved if there are three dimensions.
TextureRef noise_levels(Random& r, Texture t, int width, int layers) {
    while (true) {
        TextureLevel level{width, width, {}, layers};
        for (int i = 0; i < width * width * layers; ++i) {
            Rgba texel;
            for (std::uint16_t& v : texel) v = std::uint16_t(r.bits(16));
            add_texel(level, texel);
        }
        t.levels.push_back(std::move(level));
        if (width == 1) return make_texture(std::move(t));
        width /= 2;
        if (t.dimensions == 3) layers = layers > 1 ? layers / 2 : 1;
    }
}
TextureRef noise_cube(Random& r) {
    Texture t{.name = "cube"};
    t.cube = true;
    return noise_levels(r, std::move(t), 4, 6);
}
TextureRef noise_volume(Random& r) {
    Texture t{.name = "volume", .dimensions = 3};
    return noise_levels(r, std::move(t), 4, 5);
}

/// A square of the window whose vertices have these coordinates s, t, r, q, on every unit.
MeshRef square_between(const std::array<vec4, 4>& strq) {
    MeshData data = rectangle(0, 0, r_side, r_side);
    for (const vec4& v : strq) {
        data.texcoords.push_back({v.x, v.y});
        data.texcoords_rq.push_back({v.z, v.w});
    }
    for (UnitTexcoords& unit : data.more_texcoords) {
        unit.st = data.texcoords;
        unit.rq = data.texcoords_rq;
    }
    return make_mesh(std::move(data));
}
MeshRef square_at(const vec4& strq) { return square_between({strq, strq, strq, strq}); }

TextureState replacing(MinFilter min, MagFilter mag) {
    TextureState t{.min_filter = min, .mag_filter = mag};
    t.env = TexEnv::Replace;
    return t;
}
TextureState nearest() { return replacing(MinFilter::Nearest, MagFilter::Nearest); }

/// [R10.40] A depth is cut off. [R10.41] r 2^24 is, too: r' of 3/4 is 12582912.
void compare_equal(Script& s) {
    s.state.texture = nearest();
    s.state.texture.shadow_compare = true;
    s.state.texture.compare_func = CompareFunc::Equal;
    const auto draw_with = [&s](std::uint32_t depth, float r) {
        add(s, Draw{.mesh = square_at(vec4(0.5f, 0.5f, r, 1)),
                    .map = {make_texture(depth_texture(depth)), {}}});
    };
    draw_with(0x800000FF, 0.5f);
    draw_with(12582912u << 8, 0.75f);
    // [R10.23] texel_bits do not concern the halves of a depth, nor the grey that it gives.
    s.state.texture = nearest();
    for (int i = 0; i < 4; ++i)
        add(s, Draw{.mesh = square_at(vec4(0.5f, 0.5f, 0, 1)),
                    .map = {make_texture(depth_texture(s.random.bits(32))), {}}});
}

/// [R10.18] Plain coordinates have r 0, whatever the vertices have.
void compare_plain(Script& s) {
    Random& r = s.random;
    s.state.texture = {};
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    MeshData slope = rectangle(0, 0, r_side, r_side);
    for (vec3& p : slope.positions) p.z = float(r.real(-1, 1));
    add(s, Draw{.mesh = make_mesh(std::move(slope))});
    s.state.depth = {};
    add(s, CopyTexture{.slot = 1, .plane = Plane::Depth, .rect = {0, 0, r_side, r_side}});
    s.state.texture = nearest();
    s.state.texture.shadow_compare = true;
    s.state.texture.matrix[3] = {0, 0, r.real(0.3, 0.7), 1};
    MeshData plain = rectangle(0, 0, r_side, r_side);
    plain.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    add(s, Draw{.mesh = make_mesh(std::move(plain)), .map = {{}, 1}});
}

/// [R10.42] Coordinates of equal size: s or t is 0 or 1, where indices leave the face.
void look_at_edges(Script& s) {
    Random& r = s.random;
    const TextureRef cube = noise_cube(r);
    const float v = float(r.real(-0.9, 0.9));
    for (const vec3& d : {vec3(1, v, -1), vec3(-1, -1, v), vec3(v, 1, 1), vec3(-1, v, -1)})
        for (const MagFilter mag : {MagFilter::Nearest, MagFilter::Linear}) {
            s.state.texture = replacing(MinFilter(mag), mag);
            add(s, Draw{.mesh = square_at(vec4(d, 1)), .map = {cube, {}}});
        }
    // [R10.43] No direction: rho is 0, and lod.min has no effect.
    for (const bool exact_rho : {false, true}) {
        s.state.texture = replacing(MinFilter::NearestMipmapNearest, MagFilter::Nearest);
        s.state.texture.lod.min = 1;
        s.state.texture.exact_rho = exact_rho;
        add(s, Draw{.mesh = square_at(vec4(0, 0, 0, 1)), .map = {cube, {}}});
        add(s, Draw{.mesh = square_between(
                        {vec4(-1, 0, 0, 1), {1, 0, 0, 1}, {1, 0, 0, 1}, {-1, 0, 0, 1}}),
                    .map = {cube, {}}});
    }
}

/// [R10.38] Slopes in s, t and r alone, integer parts, and q of both signs. [R14.6] Every filter, on
/// units with a texture of two dimensions before one of three.
void look_into_volumes(Script& s) {
    Random& r = s.random;
    const TextureRef volume = noise_volume(r);
    const auto at = [&r](float reach, float low_q) {
        return vec4{float(r.real(-reach, reach)), float(r.real(-reach, reach)),
                    float(r.real(-reach, reach)), float(r.real(low_q, 2))};
    };
    MoreBindings more;
    more[1].texture = volume;
    for (int min = 0; min <= int(MinFilter::LinearMipmapLinear); ++min) {
        s.state.texture = replacing(MinFilter(min), r.any(MagFilter::Linear));
        s.state.texture.wrap_s = r.any<Wrap>();
        s.state.texture.wrap_t = r.any<Wrap>();
        s.state.texture.wrap_r = r.any<Wrap>();
        std::array<TextureState, max_texture_units - 1> units{};
        units[1] = s.state.texture;
        s.state.more_textures.units = std::make_shared<const decltype(units)>(units);
        const float reach = r.pick({2.0f, 6.0f}), low_q = min % 2 == 0 ? 0.5f : -1.0f;
        const MeshRef mesh = square_between(
            {at(reach, low_q), at(reach, low_q), at(reach, low_q), at(reach, low_q)});
        add(s, Draw{.mesh = mesh,
                    .map = {make_texture("flat", 2, 2, std::vector<std::uint16_t>(16, 0x8000)), {}},
                    .more_maps = std::make_shared<const MoreBindings>(more)});
        add(s, Draw{.mesh = mesh, .map = {volume, {}}});
    }
    s.state.more_textures = {};
}

}  // namespace

Case r_rules_case(Random& r) {
    Profile profile = opengl_up_to(&Extensions::texture_3d);
    profile.texel_bits = r.between(2, 6);
    profile.extensions.shadow_texture = true;
    Script s = pixel_script(r, profile, r_side, r_side);
    compare_equal(s);
    compare_plain(s);
    look_at_edges(s);
    return s.out;
}

Case volume_rules_case(Random& r) {
    Script s = pixel_script(r, opengl_up_to(&Extensions::texture_3d), r_side, r_side);
    look_into_volumes(s);
    return s.out;
}

}  // namespace gw::conformance
