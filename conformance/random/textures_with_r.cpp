// Several texture units, and textures looked up with r: depths, cubes, three dimensions.
#include "conformance/cases.h"
#include "conformance/generate/state.h"
#include "conformance/generate/units.h"

#include <array>
#include <memory>
#include <utility>

namespace gw::conformance {
namespace {

Case case_of(Random& r, bool Extensions::*last, TextureRef (*any)(Random&)) {
    Script s = script(r, any_opengl_profile(r, last));
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        Draw d = any_draw(
            s, any_mesh(r, s.frame, {.normals = true, .texcoords = r.chance(90), .most = 6}));
        d.map.texture = any(r);
        s.state.texture = any_state_with_r(r, d.map.texture);
        if (last != &Extensions::texture_3d) s.state.texture.wrap_r = Wrap::Repeat;
        if (last == &Extensions::texture_depth) s.state.texture.seamless = false;
        if (r.chance(85)) turn(r, s.state.texture);
        if (r.chance(15) && last != &Extensions::texture_depth) any_rules(r, s.state.texture);
        if (r.chance(15)) s.state.polygon_mode = r.any(PolygonMode::Line);
        s.state.line_smooth = s.state.polygon_smooth =
            s.out.profile.coverage_bits > 0 && r.chance(15);
        if (r.chance(15)) also_pixels(s, d);
        add(s, std::move(d));
        s.state.polygon_mode = PolygonMode::Fill;
        between_draws(s);
    }
    return s.out;
}

}  // namespace

// Up to four units with textures of every kind; environments that read other units.
Case texture_units_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::texture_3d));
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        const MeshRef mesh =
            any_mesh(r, s.frame, {.normals = true, .texcoords = r.chance(80), .most = 6});
        Draw d = any_draw(s, with_units(r, *mesh));
        s.state.more_textures = {};
        any_units(r, s.state, d);
        s.state.fog = r.chance(15) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        s.state.blend = r.chance(20) ? any_separate_blend(r) : BlendState{};
        s.state.polygon_smooth = s.out.profile.coverage_bits > 0 && r.chance(10);
        if (r.chance(15)) also_pixels(s, d);
        add(s, d);
        if (r.chance(20)) {  // the same geometry under Equal
            s.state.depth.func = DepthFunc::Equal;
            add(s, d);
            s.state.depth.func = DepthFunc::Less;
        }
        between_draws(s);
    }
    return s.out;
}

// Depth textures, compared by every function with r of every sign, and read as colours.
Case depth_textures_case(Random& r) { return case_of(r, &Extensions::texture_depth, any_depths); }

// Cubes under every filter, seamless or not, with directions near edges and corners and far from 1.
Case cubes_case(Random& r) { return case_of(r, &Extensions::texture_seamless, any_cube); }

// Three dimensions of any size, under every wrap and filter.
Case volumes_case(Random& r) { return case_of(r, &Extensions::texture_3d, any_volume); }

// Points whose sizes depend on the distance, and sprites with textures of every kind.
Case points_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::point_sprite));
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        State& state = s.state;
        const bool outlines = r.chance(25);
        const MeshWish wish{.normals = true, .texcoords = r.chance(80), .most = 6};
        const MeshRef mesh = outlines ? any_mesh(r, s.frame, wish) : any_points(r, s.frame, wish);
        Draw d = any_draw(s, with_units(r, *mesh));
        state.more_textures = {};
        any_units(r, state, d);
        state.texture.coord_replace = r.chance(70);
        if (state.more_textures.units) {
            std::array<TextureState, 3> units = *state.more_textures.units;
            for (TextureState& unit : units) unit.coord_replace = r.chance(60);
            state.more_textures.units = std::make_shared<const std::array<TextureState, 3>>(units);
        }
        if (r.chance(40)) d.more_maps = nullptr;
        state.polygon_mode = outlines ? PolygonMode::Point : PolygonMode::Fill;
        state.point_sprite = r.chance(70);
        state.point_smooth = s.out.profile.coverage_bits > 0 && r.chance(40);
        state.point_size = state.point_smooth ? float(r.real(1, 9)) : float(r.between(1, 12));
        state.point_parameters =
            r.chance(70) ? any_point_parameters(r, eye_depth(s.frame)) : PointParameters{};
        state.depth.test = r.chance(50);
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
