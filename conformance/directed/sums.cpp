// Sums and products of pixels: secondary colours under each colour source, fractions of the
// accumulation plane.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <memory>
#include <utility>
#include <vector>

namespace gw::conformance {
namespace {

constexpr int sum_side = 8;

TextureRef small_noise(Random& r) {
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 16; ++i) texels.push_back(std::uint16_t(r.bits(16)));
    return make_texture("noise", 4, 4, texels);
}

/// A square with all that a sum may read, lit so that it has a highlight.
Draw shining_square(Random& r, TextureRef texture) {
    MeshData data = rectangle(0, 0, sum_side, sum_side);
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) {
        data.normals.push_back({float(r.real(-0.5, 0.5)), float(r.real(-0.5, 0.5)), 1});
        data.colors.push_back({float(r.real(0, 0.5)), float(r.real(0, 0.5)), 0.25f, 0.5f});
        data.secondary_colors.push_back({float(r.real(0.1, 0.5)), float(r.real(0.1, 0.5)), 0.5f});
    }
    Draw d{.mesh = make_mesh(std::move(data)), .map = {std::move(texture), {}}};
    d.material.Ks = {float(r.real(0.3, 0.8)), float(r.real(0.3, 0.8)), 0.5f};
    d.material.Ns = float(r.between(1, 4));
    d.lights = std::make_shared<const std::vector<Light>>(1);
    d.id_base = r.bits(24);
    return d;
}

DrawPixels pixels_with_highlight(Random& r, TextureRef texture) {
    DrawPixels d{.width = 3, .height = 3, .zoom_x = 2.5, .zoom_y = 2};
    d.map.texture = std::move(texture);
    d.raster.texcoord = {float(r.real(0, 1)), float(r.real(0, 1)), 0, 1};
    d.raster.distance = r.real(0.2, 1);
    for (std::size_t c = 0; c < 3; ++c)
        d.raster.secondary_color[c] = std::uint16_t(r.between(10, 99));
    for (int i = 0; i < 9; ++i) d.colors.push_back(any_pixel(r, 8));
    return d;
}

/// [R8.13] [R13.12] Every source, with and without each of the two switches; fog.
void sum_colors(Script& s) {
    Random& r = s.random;
    const TextureRef texture = small_noise(r);
    const Draw square = shining_square(r, texture);
    const DrawPixels pixels = pixels_with_highlight(r, texture);
    s.state.texture.mag_filter = MagFilter::Nearest;
    for (const ColorSource source :
         {ColorSource::Vertex, ColorSource::Lighting, ColorSource::PolygonId})
        for (const bool color_sum : {false, true})
            for (const bool separate_specular : {false, true}) {
                s.state.color_source = source;
                s.state.color_sum = color_sum;
                s.state.lighting.separate_specular = separate_specular;
                s.state.fog = {.enable = r.chance(50), .mode = FogMode::Exp, .density = 1};
                s.state.fog.color = any_color(r);
                add(s, square);
                add(s, pixels);
            }
    s.state.fog = {};
    s.state.color_source = ColorSource::Vertex;
    s.state.color_sum = s.state.lighting.separate_specular = false;
}

/// [R13.8] Mult does not scale what has fractions already.
void multiply_fractions(Script& s) {
    for (const float value : {0.5f, -0.75f, 1.0f, 0.3f}) {
        add(s, Accumulate{AccumOp::Load, 1});
        add(s, Accumulate{AccumOp::Mult, value});
        add(s, Accumulate{AccumOp::Add, 0.25f});
        add(s, Accumulate{AccumOp::Return, 0.9f});
    }
}

}  // namespace

Case sum_rules_case(Random& r) {
    Script s = pixel_script(r, opengl_up_to(&Extensions::secondary_color), sum_side, sum_side);
    sum_colors(s);
    multiply_fractions(s);
    return s.out;
}

}  // namespace gw::conformance
