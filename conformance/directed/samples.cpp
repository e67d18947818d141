// Surfaces with samples, under stages that random lists seldom cross with them; depths and blits at
// the borders of surfaces.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <array>
#include <memory>
#include <utility>

namespace gw::conformance {
namespace {

constexpr int sample_side = 12;
constexpr Rect every_sample{0, 0, sample_side, sample_side};

void use_surface(Script& s, std::uint32_t number) { s.out.list.add(UseSurface{number}); }

void show_samples(Script& s) {
    use_surface(s, 0);
    add(s, Blit{.from_surface = 1,
                .planes = surface_planes,
                .source = every_sample,
                .target = every_sample});
    use_surface(s, 1);
}

/// Lines whose ends are on borders and centres of pixels, and anywhere.
MeshRef lines_anywhere(Random& r, Primitive primitive) {
    MeshData data{.primitive = primitive};
    for (int i = 0; i < 10; ++i) {
        const auto at = [&r] {
            return r.chance(60) ? r.between(0, 2 * sample_side) / 2.0 : r.real(0, sample_side);
        };
        const double x = at(), y = at();
        data.positions.push_back({float(x), float(y), float(r.real(-1, 1))});
        data.colors.push_back(any_color(r));
    }
    return make_mesh(std::move(data));
}

/// [R17.2] diamond_lines and polygon_stipple; the steps of a strip are counted without jitter and
/// without the places of samples. [R17.7] A query counts samples.
void draw_shapes(Script& s) {
    Random& r = s.random;
    s.state.depth = {.test = true, .func = DepthFunc::LEqual};
    s.out.list.add(Query{4, true});
    for (const bool diamonds : {true, false}) {
        s.state.diamond_lines = diamonds;
        s.state.line_width = float(r.between(1, 3));
        add(s, Draw{.mesh = lines_anywhere(r, Primitive::Lines)});
        s.state.line_stipple = {true, r.between(1, 2), std::uint16_t(r.bits(16) | 1)};
        s.state.jitter = any_jitter(r, s.out.profile);
        add(s, Draw{.mesh = lines_anywhere(r, Primitive::LineStrip)});
        s.state.line_stipple = {};
        show_samples(s);
    }
    std::array<std::uint32_t, 32> rows;
    for (std::uint32_t& row : rows) row = r.bits(32);
    s.state.polygon_stipple.pattern = std::make_shared<const decltype(rows)>(rows);
    add(s, Draw{.mesh = make_mesh(rectangle(1.3f, 2.2f, 10.7f, 9.4f))});
    s.state.polygon_stipple = {};
    s.state.jitter = {};
    add(s, Draw{.mesh = make_mesh(rectangle(0.4f, 0.3f, 6.1f, 7.9f))});
    s.out.list.add(Query{4, false});
    show_samples(s);
}

/// Random colours and depths.
void draw_colored_slope(Script& s) {
    Random& r = s.random;
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    MeshData slope = rectangle(0, 0, sample_side, sample_side);
    for (vec3& p : slope.positions) {
        p.z = float(r.real(-1, 1));
        slope.colors.push_back(any_color(r));
    }
    add(s, Draw{.mesh = make_mesh(std::move(slope))});
}

/// [R17.6] Every sample gets the values of a surface without.
void copy_to_samples(Script& s) {
    use_surface(s, 0);
    draw_colored_slope(s);
    use_surface(s, 1);
    add(s, Blit{.from_surface = 0,
                .planes = surface_planes,
                .source = every_sample,
                .target = every_sample});
    // The means show all samples, depths the first.
    show_samples(s);
}

/// [R10.40] [R10.41] Depths of a texture have the profile's 24 bits on a surface with 32.
void compare_on_other_bits(Script& s) {
    Texture depths{.name = "depth", .format = TextureFormat::Luminance};
    depths.depths = true;
    depths.levels.push_back({1, 1, {0xC000, 0x0077, 0, 0}});
    MeshData data = rectangle(0, 0, sample_side, sample_side);
    data.texcoords.assign(4, {0.5f, 0.5f});
    data.texcoords_rq.assign(4, {0.75f, 1});
    s.state.texture.env = TexEnv::Replace;
    s.state.texture.shadow_compare = true;
    s.state.texture.compare_func = CompareFunc::Equal;
    add(s, Draw{.mesh = make_mesh(std::move(data)), .map = {make_texture(std::move(depths)), {}}});
    s.state.texture = {};
}

/// [R16.6] r and the border have the bits of the plane. [R16.8] Means at the surface's borders.
void cross_borders(Script& s) {
    Random& r = s.random;
    s.out.list.add(MakeSurface{2, {4, 4, surface_planes, 32}});
    use_surface(s, 2);
    add(s, Clear{surface_planes, any_color(r), 0.75});
    draw_colored_slope(s);
    compare_on_other_bits(s);
    use_surface(s, 0);
    s.state.depth = {};
    add(s, Blit{.from_surface = 2,
                .planes = mask_of(Plane::Color),
                .source = {-1, -1, 6, 6},
                .target = every_sample,
                .filter = MagFilter::Linear});
    MeshData data = rectangle(0, 0, sample_side, sample_side);
    data.texcoords = {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}};
    data.texcoords_rq.assign(4, {0.5f, 1});
    TextureState& t = s.state.texture;
    t = {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
    t.wrap_s = t.wrap_t = Wrap::ClampToBorder;
    t.border_color.x = 0.5f;
    t.env = TexEnv::Replace;
    t.shadow_compare = true;
    t.compare_func = CompareFunc::Equal;
    Draw d{.mesh = make_mesh(std::move(data))};
    d.map.surface = SurfacePlane{2, Plane::Depth};
    add(s, d);
    // [R16.5] The plane as it is now.
    use_surface(s, 2);
    add(s, Clear{mask_of(Plane::Depth), vec4(0), 0.5});
    use_surface(s, 0);
    add(s, d);
    t = {};
}

}  // namespace

Case sample_rules_case(Random& r) {
    Script s = pixel_script(r, opengl_up_to(&Extensions::multisample), sample_side, sample_side);
    const int samples = r.pick({2, 4, 8});
    s.out.list.add(MakeSurface{1, {sample_side, sample_side, surface_planes, 0, samples}});
    use_surface(s, 1);
    add(s, Clear{surface_planes, any_color(r), 1});
    draw_shapes(s);
    copy_to_samples(s);
    cross_borders(s);
    return s.out;
}

}  // namespace gw::conformance
