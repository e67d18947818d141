// Smooth points of every number of corners, and small smooth polygons in steep perspective.
#include "conformance/cases.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

constexpr int smooth_window = 48;

/// [R9.27] Sizes that need 8, 16, 32 and 64 corners an eighth; 16 bits of alpha show the areas.
void draw_discs(Script& s) {
    Random& r = s.random;
    s.state.point_smooth = true;
    for (const double size : {1.0, r.real(2.2, 4), r.real(8.2, 16), r.real(33, 44)}) {
        s.state.point_size = float(size);
        MeshData data{.primitive = Primitive::Points};
        const int count = size < 5 ? 30 : size < 20 ? 6 : 2;
        for (int i = 0; i < count; ++i) {
            const double x = r.real(0, smooth_window);
            data.positions.push_back({float(x), float(r.real(0, smooth_window)), 0});
            data.colors.push_back({float(i + 1) / float(count), 0.5f, 1, 1});
        }
        add(s, Draw{.mesh = make_mesh(data)});
    }
    s.state.point_smooth = false;
}

/// [R9.28] Triangles of a few pixels, w from 1 to 16. Texture coordinates are 0 or 1: outside, the
/// quotient would go beyond 1 into other texels.
MeshRef steep_triangles(Random& r) {
    MeshData data;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i)
            for (int k = 0; k < 3; ++k) {
                const float w = r.pick({1.0f, 2.0f, 8.0f, 16.0f});
                const double x = 9 * i + 1 + r.real(0, 3) + (k == 1 ? 3 : 0);
                const double y = 9 * j + 1 + r.real(0, 3) + (k == 2 ? 3 : 0);
                data.positions.push_back({float(x) * w, float(y) * w, 0});
                data.w.push_back(w);
                data.texcoords.push_back({float(r.below(2)), float(r.below(2))});
                data.colors.push_back(any_color(r));
                data.colors.back().w = 1;
            }
    return make_mesh(data);
}

}  // namespace

Case smooth_case(Random& r) {
    Profile profile = opengl_up_to(&Extensions::draw_pixels);
    profile.color_bits = profile.coverage_bits = 16;
    Script s = pixel_script(r, profile, smooth_window, smooth_window);
    draw_discs(s);
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 16 * 16; ++i) texels.push_back(std::uint16_t(257 * r.bits(8)));
    const TextureRef texture = make_texture("noise", 16, 16, texels);
    s.state.polygon_smooth = s.state.line_smooth = true;
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        s.state.texture = {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
        s.state.texture.wrap_s = s.state.texture.wrap_t = wrap;
        s.state.texture.env = r.pick({TexEnv::Modulate, TexEnv::Decal});
        add(s, Clear{mask_of(Plane::Color)});
        add(s, Draw{.mesh = steep_triangles(r), .map = {texture, {}}});
    }
    return s.out;
}

}  // namespace gw::conformance
