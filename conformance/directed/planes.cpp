// Planes of surfaces as textures, and blits, under state that must not change them [R16.5] [R16.9].
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

constexpr int side = 16;

/// All pixels, with random colours; texture coordinates of 0 .. 1.
MeshData painted_square(Random& r) {
    MeshData mesh = rectangle(0, 0, float(side), float(side));
    mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.colors.push_back(any_color(r));
    return mesh;
}

/// A square of random colours and depths, in the surface in use.
void draw_slope(Script& s) {
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    s.state.texture = {};
    MeshData mesh = painted_square(s.random);
    for (vec3& p : mesh.positions) p.z = float(s.random.real(-1, 1));
    add(s, Draw{.mesh = make_mesh(mesh)});
}

void draw_plane(Script& s, Plane plane) {
    s.state.depth = {};
    s.state.texture = {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
    s.state.texture.env = TexEnv::Replace;
    MeshData mesh = painted_square(s.random);
    mesh.texcoords_rq.assign(mesh.positions.size(), {0.5f, 1});
    TextureBinding map;
    map.surface = SurfacePlane{1, plane};
    s.state.texture.shadow_compare = plane == Plane::Depth;
    add(s, Draw{.mesh = make_mesh(mesh), .map = map});
}

}  // namespace

Case surface_rules_case(Random& r) {
    Profile profile = opengl_up_to(&Extensions::surfaces);
    profile.extensions.shadow_texture = true;
    profile.depth_bits = 16;
    profile.color_planes = 2;
    Script s = pixel_script(r, profile, side, side);
    s.out.list.add(MakeSurface{1, {side, side, surface_planes, 32}});
    s.out.list.add(UseSurface{1});
    draw_slope(s);
    s.out.list.add(UseSurface{0});
    draw_plane(s, Plane::Color);
    draw_plane(s, Plane::Depth);  // r is compared with 32 bits, not with the window's 16
    s.state.draw_buffer = DrawBuffer::Back;
    draw_slope(s);
    s.state.read_buffer = ReadBuffer::Back;
    s.state.color_mask.r = s.state.color_mask.b = false;
    set_state(s);
    const Rect all{0, 0, side, side};
    const PlaneMask color = mask_of(Plane::Color);
    s.out.list.add(UseSurface{1});
    s.out.list.add(Blit{.from_surface = 0, .planes = color, .source = all, .target = all});
    s.out.list.add(UseSurface{0});
    s.state.draw_buffer = DrawBuffer::Front;
    set_state(s);
    s.out.list.add(Blit{.from_surface = 1, .planes = color, .source = all, .target = all});
    return s.out;
}

}  // namespace gw::conformance
