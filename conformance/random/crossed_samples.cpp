// Samples and surfaces crossed with every stage before and after them: clip control, diamond lines,
// stipples, sizes of points, sprites, units with textures of every kind, fog coordinates, secondary
// colours, blending of alpha, masks of bits, queries, planes as textures and blits.
#include "conformance/cases.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"
#include "conformance/generate/units.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace gw::conformance {
namespace {

constexpr std::uint32_t map_number = 3;  ///< of the surface whose planes are textures

/// A script, and its surfaces; the window is the first. While one is in use, the script's window has
/// its size.
struct Crossed {
    Script s;
    std::array<Surface, 4> surfaces{};
    int window_depth_bits = s.out.profile.depth_bits;
    std::uint32_t used = 0;
    std::optional<std::uint32_t> query{};

    int depth_bits_of(std::uint32_t number) const {
        return surfaces[number].depth_bits != 0 ? surfaces[number].depth_bits : window_depth_bits;
    }
    bool has_samples() const { return surfaces[used].samples != 0; }
    void use(std::uint32_t number) {
        used = number;
        s.out.list.add(UseSurface{number});
        s.out.width = surfaces[number].width;
        s.out.height = surfaces[number].height;
        s.out.profile.depth_bits = depth_bits_of(number);
    }
};

void make_surfaces(Crossed& all) {
    Random& r = all.s.random;
    const Surface window{all.s.out.width, all.s.out.height, all_planes};
    all.surfaces[0] = window;
    Surface sampled{window.width, window.height, surface_planes};
    if (r.chance(30)) {
        sampled.width = r.between(1, 60);
        sampled.height = r.between(1, 60);
    }
    sampled.samples = r.pick({2, 4, 4, 8});
    all.surfaces[1] = all.surfaces[2] = sampled;
    if (r.chance(40)) all.surfaces[2].samples = 0;
    Surface& map = all.surfaces[map_number] = {r.between(1, 20), r.between(1, 20), surface_planes};
    if (r.chance(30)) map.depth_bits = r.between(16, 32);
    for (std::uint32_t number = 1; number < all.surfaces.size(); ++number)
        all.s.out.list.add(MakeSurface{number, all.surfaces[number]});
}

std::shared_ptr<const std::array<std::uint32_t, 32>> any_pattern(Random& r) {
    std::array<std::uint32_t, 32> rows;
    for (std::uint32_t& row : rows) {
        const std::uint32_t bits = r.bits(32);
        row = bits | r.bits(32);
    }
    return std::make_shared<const std::array<std::uint32_t, 32>>(rows);
}

/// What decides the pixels and depths of primitives.
void crossed_shapes(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    const Extensions& has = s.out.profile.extensions;
    state.clip_control = {r.any<ClipOrigin>(),
                          r.chance(30) ? ClipDepth::ZeroToOne : ClipDepth::NegativeOneToOne};
    state.depth_range = r.chance(20) ? any_depth_range(r) : DepthRangeState{};
    state.cull = r.chance(20) ? any_cull(r) : CullState{};
    state.polygon_mode = r.chance(65) ? PolygonMode::Fill : r.any(PolygonMode::Line);
    state.two_side_polygon_mode = r.chance(20);
    state.back_polygon_mode = r.any(PolygonMode::Fill);
    state.polygon_offset =
        r.chance(30) ? any_polygon_offset(r, s.out.profile) : PolygonOffsetState{};
    state.polygon_offset.lines = has.polygon_offset && r.chance(20);
    state.polygon_offset.points = has.polygon_offset && r.chance(20);
    state.line_stipple = r.chance(35) ? any_dashes(r) : LineStippleState{};
    state.polygon_stipple.pattern = r.chance(30) ? any_pattern(r) : nullptr;
    state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
    state.point_size = r.chance(50) ? float(r.between(1, 12)) : float(r.real(1, 9));
    state.point_parameters =
        r.chance(40) ? any_point_parameters(r, eye_depth(s.frame)) : PointParameters{};
    state.point_sprite = r.chance(40);
    state.line_width = r.chance(50) ? float(r.between(1, 6)) : float(r.real(1, 6));
    state.diamond_lines = r.chance(50);
    state.point_smooth = state.line_smooth = state.polygon_smooth =
        s.out.profile.coverage_bits > 0 && r.chance(25);
}

void any_colors(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    state.shade_model = r.any(ShadeModel::Smooth);
    state.color_source = r.chance(75)   ? ColorSource::Vertex
                         : r.chance(80) ? ColorSource::Lighting
                                        : ColorSource::PolygonId;
    state.lighting =
        state.color_source == ColorSource::Lighting ? any_lighting(r) : LightingState{};
    state.lighting.separate_specular = r.chance(50);
    state.color_sum = r.chance(50);
    state.fog = r.chance(30) ? any_fog(r, eye_depth(s.frame)) : FogState{};
    state.fog.source = r.any<FogSource>();
}

/// What fragments meet. Most of them pass.
void crossed_fragments(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    state.multisample = {.enable = r.chance(85), .alpha_to_coverage = r.chance(20)};
    state.multisample.alpha_to_one = r.chance(20);
    state.multisample.coverage_test = r.chance(20);
    state.multisample.coverage = float(r.real(0, 1));
    state.multisample.invert = r.chance(40);
    state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
    state.depth = r.chance(50) ? any_depth(r) : DepthState{};
    state.stencil = r.chance(35) ? any_stencil(r, s.out.profile) : StencilState{};
    state.blend = r.chance(40) ? any_separate_blend(r) : BlendState{};
    state.logic_op = r.chance(10) ? any_logic_op(r) : LogicOpState{};
    state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
    state.color_mask = r.chance(20) ? any_color_mask(r) : ColorMask{};
    state.color_mask_bits = {};
    if (r.chance(30))
        for (std::uint16_t* bits : {&state.color_mask_bits.r, &state.color_mask_bits.g,
                                    &state.color_mask_bits.b, &state.color_mask_bits.a})
            *bits = std::uint16_t(r.bits(16));
    const bool has_back = s.out.profile.color_planes == 2;
    state.draw_buffer = r.chance(85) ? DrawBuffer::Front
                        : has_back   ? r.any<DrawBuffer>()
                                     : r.pick({DrawBuffer::None, DrawBuffer::Front});
    state.read_buffer = has_back ? r.any<ReadBuffer>() : ReadBuffer::Front;
}

/// Attributes that no other mesh of the random tests has together.
MeshRef with_attributes(Random& r, const Mesh& mesh) {
    MeshData data = with_units(r, mesh)->data();
    const bool has_secondary = r.chance(50), has_fog = r.chance(50);
    for (std::size_t i = 0; i < data.positions.size(); ++i) {
        if (has_secondary)
            data.secondary_colors.push_back({any_fraction(r), any_fraction(r), any_fraction(r)});
        if (has_fog) data.fog_coordinates.push_back(float(r.real(-1, 3)));
    }
    return make_mesh(std::move(data));
}

/// Gives some units a plane of a surface that is not drawn to, instead of their textures.
void any_planes(const Crossed& all, State& state, Draw& d) {
    Random& r = all.s.random;
    if (all.used == map_number) return;
    const auto plane = [&](TextureBinding& map, TextureState& t) {
        if (!r.chance(25)) return;
        map = {};
        map.surface = SurfacePlane{map_number, r.pick({Plane::Color, Plane::Depth})};
        t.shadow_compare = map.surface->plane == Plane::Depth && r.chance(70);
    };
    plane(d.map, state.texture);
    if (!d.more_maps || !state.more_textures.units) return;
    MoreBindings more = *d.more_maps;
    auto units = *state.more_textures.units;
    for (std::size_t i = 0; i < more.size(); ++i) plane(more[i], units[i]);
    d.more_maps = std::make_shared<const MoreBindings>(more);
    state.more_textures.units = std::make_shared<const decltype(units)>(units);
}

/// Sprites and exact slopes, for each unit.
void any_unit_rules(Random& r, State& state) {
    const auto rules = [&r](TextureState& t) {
        t.coord_replace = r.chance(50);
        t.exact_rho = r.chance(30);
    };
    rules(state.texture);
    if (!state.more_textures.units) return;
    auto units = *state.more_textures.units;
    for (TextureState& unit : units) rules(unit);
    state.more_textures.units = std::make_shared<const decltype(units)>(units);
}

void draw_any(Crossed& all) {
    Script& s = all.s;
    Random& r = s.random;
    crossed_shapes(s);
    any_colors(s);
    crossed_fragments(s);
    const MeshWish wish{.normals = true, .texcoords = r.chance(70), .most = 5};
    const int kind = r.below(10);
    const MeshRef mesh = kind < 5   ? any_triangles(r, s.frame, wish)
                         : kind < 8 ? any_lines(r, s.frame, wish)
                                    : any_points(r, s.frame, wish);
    Draw d = any_draw(s, with_attributes(r, *mesh));
    s.state.texture = {};
    s.state.more_textures = {};
    if (r.chance(60)) {
        any_units(r, s.state, d);
        any_planes(all, s.state, d);
        any_unit_rules(r, s.state);
    }
    if (r.chance(15) && !all.has_samples()) also_pixels(s, d);
    add(s, std::move(d));
}

void any_blit(Crossed& all, std::uint32_t number) {
    Random& r = all.s.random;
    const Surface &from = all.surfaces[number], &to = all.surfaces[all.used];
    Blit blit{.from_surface = number, .planes = PlaneMask(r.chance(70) ? 7 : r.below(8))};
    blit.source = {r.between(-3, from.width / 2), r.between(-3, from.height / 2),
                   r.between(0, from.width + 4), r.between(0, from.height + 4)};
    blit.target = {r.between(-3, to.width / 2), r.between(-3, to.height / 2),
                   r.between(0, to.width + 4), r.between(0, to.height + 4)};
    if (from.samples != 0 || to.samples != 0) {
        blit.target.width = blit.source.width;
        blit.target.height = blit.source.height;
    }
    blit.flip_x = r.chance(25);
    blit.flip_y = r.chance(25);
    blit.filter = r.any(MagFilter::Linear);
    if (all.depth_bits_of(number) != all.depth_bits_of(all.used))
        blit.planes = PlaneMask(blit.planes & ~mask_of(Plane::Depth));
    add(all.s, blit);
}

void any_query(Crossed& all) {
    const bool begins = !all.query;
    const std::uint32_t key = begins ? std::uint32_t(all.s.random.below(3)) : *all.query;
    all.s.out.list.add(Query{key, begins});
    all.query = begins ? std::optional(key) : std::nullopt;
}

void any_step(Crossed& all) {
    Script& s = all.s;
    Random& r = s.random;
    if (r.chance(30)) all.use(std::uint32_t(r.below(int(all.surfaces.size()))));
    if (r.chance(25)) any_query(all);
    const int kind = r.below(100);
    if (kind < 65) return draw_any(all);
    if (kind < 80) return any_blit(all, std::uint32_t(r.below(int(all.surfaces.size()))));
    crossed_fragments(s);
    if (kind < 88) return add(s, any_clear(r));
    if (kind < 92) return add(s, any_pixels(r, s.out));
    any_colors(s);
    DrawPixels pixels = any_draw_pixels(s);
    pixels.raster.secondary_color = any_pixel(r, s.out.profile.color_bits);
    pixels.raster.fog_coordinate = r.real(-1, 3);
    if (!pixels.source || !all.has_samples()) add(s, std::move(pixels));
}

/// All that the surfaces hold, in the window.
void show_all(Crossed& all) {
    if (all.query) any_query(all);
    all.use(0);
    all.s.state = {};
    for (const std::uint32_t number : {2u, 1u, map_number}) {
        const Surface& surface = all.surfaces[number];
        const Rect rect{0, 0, surface.width, surface.height};
        Blit blit{.from_surface = number, .planes = surface_planes, .source = rect, .target = rect};
        if (all.depth_bits_of(number) != all.window_depth_bits)
            blit.planes = PlaneMask(blit.planes & ~mask_of(Plane::Depth));
        add(all.s, blit);
        between_draws(all.s);
    }
}

}  // namespace

Case crossed_samples_case(Random& r) {
    Profile profile = any_opengl_profile(r, &Extensions::multisample);
    profile.subpixel_bits = std::max(profile.subpixel_bits, 3);
    if (r.chance(40)) profile.texel_bits = r.between(2, 10);
    Crossed all{script(r, profile)};
    make_surfaces(all);
    all.use(1);
    const int steps = r.between(3, 10);
    for (int i = 0; i < steps; ++i) any_step(all);
    show_all(all);
    all.s.out.profile.depth_bits = all.window_depth_bits;
    return all.s.out;
}

}  // namespace gw::conformance
