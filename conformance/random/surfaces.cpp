// Surfaces: made, drawn to, read, copied into each other, looked up as textures. What they hold at the
// end is copied to the window.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace gw::conformance {
namespace {

/// A script, and the surfaces that there are. While one is in use, the script's window is its size.
struct Surfaces {
    Script s;
    Surface window{s.out.width, s.out.height, all_planes};
    std::map<std::uint32_t, Surface> made{};
    std::uint32_t used = 0;
    int window_depth_bits = s.out.profile.depth_bits;

    Surface of(std::uint32_t number) const { return number == 0 ? window : made.at(number); }
    Surface current() const { return of(used); }
    bool can_read(Plane plane) const { return current().has(plane); }
    int depth_bits_of(const Surface& surface) const {
        return surface.depth_bits != 0 ? surface.depth_bits : window_depth_bits;
    }
    void use(std::uint32_t number) {
        used = number;
        const Surface surface = current();
        s.out.list.add(UseSurface{number});
        s.out.width = surface.width;
        s.out.height = surface.height;
        s.out.profile.depth_bits = depth_bits_of(surface);
    }
    /// The window, or a surface.
    std::uint32_t any() const {
        const auto i = std::uint32_t(s.random.below(int(made.size()) + 1));
        return i == 0 ? 0 : std::next(made.begin(), i - 1)->first;
    }
    void make() {
        Random& r = s.random;
        const auto number = std::uint32_t(r.chance(90) ? r.between(1, 3) : 1023);
        if (number == used) return;
        Surface surface{r.between(1, 70), r.between(1, 70),
                        PlaneMask(r.chance(60) ? surface_planes : r.between(1, 7))};
        if (r.chance(50)) surface.depth_bits = r.between(16, 32);
        if (r.chance(3)) surface.width = surface.height = 0;
        s.out.list.add(MakeSurface{number, surface});
        made.erase(number);
        if (surface.width != 0) made[number] = surface;
    }
};

/// Sides of equal size, scaled and beyond the borders.
Blit any_blit(const Surfaces& all, std::uint32_t number) {
    Random& r = all.s.random;
    const Surface from = all.of(number), to = all.current();
    Blit blit{.from_surface = number, .planes = PlaneMask(r.chance(50) ? 7 : r.below(8))};
    blit.source = {r.between(-3, from.width / 2), r.between(-3, from.height / 2),
                   r.between(0, from.width + 4), r.between(0, from.height + 4)};
    blit.target = {r.between(-3, to.width / 2), r.between(-3, to.height / 2),
                   r.between(0, to.width + 4), r.between(0, to.height + 4)};
    if (r.chance(40)) {
        blit.target.width = blit.source.width;
        blit.target.height = blit.source.height;
    }
    blit.flip_x = r.chance(25);
    blit.flip_y = r.chance(25);
    blit.filter = r.any(MagFilter::Linear);
    if (all.depth_bits_of(from) != all.depth_bits_of(to))
        blit.planes = PlaneMask(blit.planes & ~mask_of(Plane::Depth));
    return blit;
}

void any_fragment_state(Surfaces& all) {
    Script& s = all.s;
    Random& r = s.random;
    s.state.scissor = r.chance(25) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
    s.state.depth = r.chance(70) ? any_depth(r) : DepthState{};
    s.state.stencil = r.chance(40) ? any_stencil(r, s.out.profile) : StencilState{};
    s.state.blend = r.chance(30) ? any_extended_blend(r) : BlendState{};
    s.state.color_mask = r.chance(20) ? any_color_mask(r) : ColorMask{};
    s.state.fog = r.chance(10) ? any_fog(r, eye_depth(s.frame)) : FogState{};
    s.state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
    s.state.polygon_offset.enable = s.out.profile.extensions.polygon_offset && r.chance(20);
    s.state.polygon_offset.factor = float(r.real(-2, 2));
    s.state.polygon_offset.units = float(r.real(-50, 50));
    if (s.out.profile.color_planes == 2) {
        s.state.draw_buffer = r.any(DrawBuffer::FrontAndBack);
        s.state.read_buffer = r.any(ReadBuffer::Back);
    }
}

/// A plane of a surface that is not drawn to; none if there is none.
std::optional<SurfacePlane> any_map(const Surfaces& all) {
    Random& r = all.s.random;
    const std::uint32_t number = all.any();
    if (number == 0 || number == all.used) return {};
    const Plane plane = r.pick({Plane::Color, Plane::Depth});
    if (!all.of(number).has(plane)) return {};
    return SurfacePlane{number, plane};
}

/// 4 x 4 depths of 32 bits.
TextureRef square_of_depths(Random& r) {
    Texture t{.name = "depths"};
    t.depths = true;
    t.format = TextureFormat::Luminance;
    TextureLevel level{4, 4, {}};
    for (int i = 0; i < 4 * 16; ++i) level.rgba.edit().push_back(std::uint16_t(r.bits(16)));
    t.levels.push_back(std::move(level));
    return make_texture(std::move(t));
}

/// Mostly compares r with depths.
void compare_depths(Script& s, TextureState& t, const TextureBinding& map) {
    Random& r = s.random;
    const bool depths = map.surface ? map.surface->plane == Plane::Depth : map.texture != nullptr;
    if (!depths || !r.chance(80)) return;
    t.shadow_compare = s.out.profile.extensions.shadow_texture;
    t.compare_func = r.chance(50) ? CompareFunc::LEqual : r.any<CompareFunc>();
    for (int i = 0; i < 4; ++i) t.matrix[3][i] = r.real(-0.3, 1);
}

/// Planes of surfaces as textures of other units.
void more_maps(Surfaces& all, Draw& d) {
    Script& s = all.s;
    MoreBindings maps;
    std::array<TextureState, max_texture_units - 1> units;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (s.random.chance(60)) maps[i].surface = any_map(all);
        units[i] = any_texture_state(s.random);
        compare_depths(s, units[i], maps[i]);
    }
    s.state.more_textures.units =
        std::make_shared<const std::array<TextureState, max_texture_units - 1>>(units);
    d.more_maps = std::make_shared<const MoreBindings>(maps);
}

void draw_any(Surfaces& all) {
    Script& s = all.s;
    Random& r = s.random;
    any_fragment_state(all);
    s.state.texture = any_texture_state(r);
    Draw d = any_draw(s, any_mesh(r, s.frame, {.texcoords = true, .most = 6}));
    if (r.chance(60)) d.map.surface = any_map(all);
    d.map.texture = d.map.surface || r.chance(80) ? nullptr : square_of_depths(r);
    compare_depths(s, s.state.texture, d.map);
    s.state.more_textures = {};
    if (r.chance(25)) more_maps(all, d);
    if (r.chance(15)) {
        DrawPixels pixels = any_draw_pixels(s);
        const bool fits = !pixels.source || all.can_read(pixels.source->plane);
        pixels.map = d.map;
        pixels.more_maps = d.more_maps;
        if (fits) add(s, std::move(pixels));
    }
    add(s, std::move(d));
    s.state.texture.shadow_compare = false;
    s.state.more_textures = {};
}

void copy_any(Surfaces& all) {
    Script& s = all.s;
    Random& r = s.random;
    const Copy copy = any_copy(r, s.out);
    if (all.can_read(copy.plane) && r.chance(50)) return add(s, copy);
    Read read = any_read(r, s.out);
    if (all.can_read(read.plane)) add(s, read);
}

void any_surfaces_step(Surfaces& all) {
    Script& s = all.s;
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 12) return all.make();
    if (kind < 34) return all.use(all.any());
    if (kind < 62) return draw_any(all);
    if (kind < 80) return add(s, any_blit(all, all.any()));
    any_fragment_state(all);
    if (kind < 88) return add(s, any_clear(r));
    if (kind < 93) return copy_any(all);
    add(s, kind < 97 ? Command(any_pixels(r, s.out)) : Command(any_spans(r, s.out)));
}

/// Copies all planes to the window, and draws what is left by depths as texels.
void show_all(Surfaces& all) {
    Script& s = all.s;
    all.use(0);
    s.state.scissor = {};
    for (const auto& [number, surface] : all.made) {
        Blit blit{.from_surface = number, .planes = 7};
        blit.source = {0, 0, surface.width, surface.height};
        blit.target = {s.random.between(0, s.out.width / 2), 0, s.out.width / 2 + 1, s.out.height};
        if (all.depth_bits_of(surface) != all.window_depth_bits) blit.planes = 5;
        add(s, blit);
        if (!surface.has(Plane::Depth)) continue;
        s.state.depth = {};
        s.state.stencil = {};
        s.state.blend = {};
        s.state.color_mask = {};
        DrawPixels pixels{.width = 4, .height = 4, .colors = std::vector<Rgba>(16)};
        for (Rgba& color : pixels.colors) color = any_pixel(s.random, s.out.profile.color_bits);
        pixels.raster.texcoord = {float(s.random.real(0, 1)), float(s.random.real(0, 1)), 0, 1};
        pixels.map.surface = SurfacePlane{number, Plane::Depth};
        add(s, std::move(pixels));
    }
}

}  // namespace

Case surfaces_case(Random& r) {
    Profile profile = any_opengl_profile(r, &Extensions::surfaces);
    profile.extensions.shadow_texture = r.chance(85);
    Surfaces all{script(r, profile)};
    for (int i = r.between(1, 3); i > 0; --i) all.make();
    const int steps = r.between(4, 24);
    for (int i = 0; i < steps; ++i) {
        any_surfaces_step(all);
        if (all.used == 0) between_draws(all.s);
    }
    show_all(all);
    all.s.out.profile.depth_bits = all.window_depth_bits;
    return all.s.out;
}

}  // namespace gw::conformance
