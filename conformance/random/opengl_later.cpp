// What the machine has for OpenGL 1.2 to 1.5.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gw::conformance {

// Colours and alpha blended by factors and equations of their own.
Case separate_blend_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::blend_square));
    add(s, any_pixels(r, s.out));
    const int draws = r.between(1, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.blend = any_separate_blend(r);
        s.state.logic_op = r.chance(10) ? any_logic_op(r) : LogicOpState{};
        s.state.color_mask = any_color_mask(r);
        s.state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        if (r.chance(25))
            add(s, any_pixels(r, s.out));
        else
            draw(s, any_triangles(r, s.frame, {.most = 6}));
        between_draws(s);
    }
    return s.out;
}

namespace {

/// Mostly small, seldom longer than the sides of OpenGL 1.1.
int any_side(Random& r) {
    const int kind = r.below(40);
    if (kind < 30) return r.between(1, 20);
    return kind < 39 ? r.between(20, 70) : r.between(4096, 8192);
}

TextureRef any_whole_texture(Random& r, bool srgb = false) {
    const int width = any_side(r), height = width < 100 ? any_side(r) : r.between(1, 3);
    const bool noise = r.chance(60);
    const int bits = srgb && r.chance(40) ? 12 : 16;  // dark, or of any value
    std::vector<std::uint16_t> rgba;
    for (int i = 0; i < 4 * width * height; ++i)
        rgba.push_back(std::uint16_t(noise ? r.bits(bits) : 257 * r.pick({0, 128, 255})));
    return make_whole_texture("whole", width, height, rgba, srgb);
}

/// Given levels of any size, with or without a border.
TextureRef any_given_levels(Random& r, bool srgb = false) {
    Texture t{.name = "given"};
    t.srgb = srgb;
    t.format = r.chance(20) ? TextureFormat::Alpha : r.any(TextureFormat::Intensity);
    t.border = r.chance(40);
    int width = r.between(1, 20), height = r.between(1, 20);
    const int most = r.between(1, 5);
    while (int(t.levels.size()) < most) {
        const int more = t.border ? 2 : 0;
        std::vector<std::uint16_t> rgba;
        for (int i = 0; i < 4 * (width + more) * (height + more); ++i)
            rgba.push_back(std::uint16_t(r.bits(16)));
        t.levels.push_back({width, height, std::move(rgba)});
        if (width == 1 && height == 1) break;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
    return make_texture(std::move(t));
}

/// Gives r and q values that change with s, and moves s and t beyond the sides.
void project(Random& r, dmat4& m) {
    m[0][2] = r.real(-1, 1);
    m[0][3] = r.real(-0.2, 0.2);
    for (int i = 0; i < 3; ++i) m[3][i] = r.real(-1, 1);
}

void copy_any_rectangle(Script& s, Plane plane) {
    Random& r = s.random;
    Rect rect{0, 0, r.between(1, s.out.width), r.between(1, s.out.height)};
    rect.x = r.between(0, s.out.width - rect.width);
    rect.y = r.between(0, s.out.height - rect.height);
    (plane == Plane::Color ? s.color_slots : s.depth_slots)
        .push_back(plane == Plane::Color ? 0 : 1);
    add(s, CopyTexture{plane == Plane::Color ? 0u : 1u, plane, rect});
}

}  // namespace

// Textures and slots of any size, under every wrap, filter and choice of levels; in perspective,
// projected, and with coordinates far from 0.
Case texture_sizes_case(Random& r) {
    Profile profile = any_opengl_profile(r, &Extensions::texture_lod);
    profile.extensions.shadow_texture = r.chance(60);
    Script s = script(r, profile);
    s.state.depth.test = r.chance(50);
    copy_any_rectangle(s, Plane::Color);
    copy_any_rectangle(s, Plane::Depth);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_later_texture_state(r);
        if (r.chance(15)) s.state.texture.gen = r.any(TexGen::EyeLinear);
        if (r.chance(50))
            s.state.texture.matrix[r.below(4)] *=
                r.pick({-3.0, 3.0, 6.0, 40.0, 300.0, 900.0, 3000.0, 1e9});
        Draw d = any_draw(s, any_mesh(r, s.frame, {.texcoords = r.chance(90), .most = 6}));
        const int kind = r.below(10);
        if (kind < 4) d.map = {any_whole_texture(r), {}};
        if (kind >= 4 && kind < 7) d.map = {any_given_levels(r), {}};
        if (kind >= 7) {
            s.state.texture.shadow_compare = kind >= 8 && profile.extensions.shadow_texture;
            d.map = {nullptr, kind >= 8 ? 1u : 0u};
            if (s.state.texture.shadow_compare) project(r, s.state.texture.matrix);
        }
        if (r.chance(15)) {
            DrawPixels pixels = any_draw_pixels(s);
            pixels.map = d.map;
            add(s, std::move(pixels));
        }
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

// Environments that add and combine, of textures of every format.
Case texture_combine_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::texture_combine));
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.env = r.chance(15) ? TexEnv::Add : TexEnv::Combine;
        any_combine(r, s.state.texture);
        s.state.alpha = r.chance(15) ? any_alpha(r) : AlphaState{};
        s.state.blend = r.chance(25) ? any_separate_blend(r) : BlendState{};
        s.state.fog = r.chance(15) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        Draw d = any_draw(s, any_mesh(r, s.frame, {.texcoords = r.chance(90), .most = 6}));
        d.map = {r.chance(70) ? any_given_levels(r) : any_texture(r), {}};
        if (r.chance(15)) {
            DrawPixels pixels = any_draw_pixels(s);
            pixels.map = d.map;
            add(s, std::move(pixels));
        }
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

// Textures of sRGB colours, filtered, in texels of every width.
Case texture_srgb_case(Random& r) {
    Profile profile = any_opengl_profile(r, &Extensions::texture_srgb);
    if (r.chance(30)) profile.texel_bits = r.between(1, 16);
    Script s = script(r, profile);
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = r.chance(40) ? any_later_texture_state(r) : any_texture_state(r);
        Draw d = any_draw(s, any_mesh(r, s.frame, {.texcoords = true, .most = 6}));
        const bool srgb = r.chance(85);
        d.map = {r.chance(50) ? any_given_levels(r, srgb) : any_whole_texture(r, srgb), {}};
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
