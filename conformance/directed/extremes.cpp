// Values at the ends of their ranges: lights, texture coordinates.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Lighting at the ends of its range: lengths that overflow or vanish, infinite strengths, NaN.
namespace {

/// A component of any size, from 0 to the largest.
float extreme_size(Random& r) {
    return r.pick({0.0f, 1.0f, -1.0f, 1e-45f, 1e-30f, 3e38f, -3e38f, 1e20f, 0.5f, -2.0f});
}
vec3 any_vector(Random& r) { return {extreme_size(r), extreme_size(r), extreme_size(r)}; }

Light extreme_light(Random& r) {
    Light light;
    const vec3 position = any_vector(r);
    light.position = vec4(position, r.pick({0.0f, 1.0f, -1.0f, 1e-30f}));
    light.Ia = any_vector(r);
    light.Id = any_vector(r);
    light.Is = any_vector(r);
    if (r.chance(50)) light.spot_direction = any_vector(r);
    light.spot_exponent = r.pick({0.0f, 1.0f, 128.0f, 0.5f});
    light.spot_cos_cutoff = r.pick({-1.0f, -0.5f, 0.0f, 0.5f, 1.0f});
    light.constant_attenuation = r.pick({0.0f, 1.0f, 1e-38f});
    light.linear_attenuation = r.pick({0.0f, 1.0f, 3e38f});
    light.quadratic_attenuation = r.pick({0.0f, 1e-30f, 3e38f});
    return light;
}

/// A square over the window, its normals of any length.
MeshRef lit_square(Random& r, int width, int height) {
    MeshData data{.primitive = Primitive::Quads};
    const float w = float(width), h = float(height);
    data.positions = {{0, 0, 0}, {w, 0, 0}, {w, h, 0}, {0, h, 0}};
    for (int i = 0; i < 4; ++i)
        data.normals.push_back(r.chance(40) ? vec3(0, 0, 1) : any_vector(r));
    return make_mesh(data);
}

}  // namespace

Case extreme_lights_case(Random& r) {
    Script s{r, {r.pick(paper_profiles()), 12, 12}};
    s.frame = {s.out.width, s.out.height};
    s.state.color_source = ColorSource::Lighting;
    s.state.projection[0][0] = s.state.projection[1][1] = 2.0 / 12;
    s.state.projection[2][2] = 0;  // depth 0 for every eye-space z
    s.state.projection[3] = {-1, -1, 0, 1};
    add(s, Clear{all_planes});
    for (int i = 0; i < 10; ++i) {
        s.state.lighting = {r.chance(50), r.chance(50), vec4(any_vector(r), 1)};
        set_state(s);
        Draw d{.mesh = lit_square(r, s.out.width, s.out.height)};
        if (r.chance(30)) d.eye_from_object[3].z = r.pick({-1.0, 1e200, -1e200, 1e-300});
        if (r.chance(20)) {
            const double size = r.pick({1e-200, 1e-320, 1e160});
            d.eye_from_object[2] *= size;  // the normals' lengths; positions have z = 0
        }
        d.material = {any_vector(r),
                      any_vector(r),
                      any_vector(r),
                      any_vector(r),
                      r.pick({0.0f, 1.0f, 10000.0f, 0.25f}),
                      extreme_size(r)};
        std::vector<Light> lights;
        const int count = r.between(0, 3);
        for (int k = 0; k < count; ++k) lights.push_back(extreme_light(r));
        d.lights = std::make_shared<const std::vector<Light>>(std::move(lights));
        s.out.list.add(std::move(d));
    }
    // [R8.7] Eye coordinates overflow although clip coordinates do not: a cosine is NaN.
    Draw far{.mesh = lit_square(r, s.out.width, s.out.height)};
    far.eye_from_object[0].z = 1e308;
    far.eye_from_object[3].z = 1.5e308;
    far.material.Ke = vec3(0.5f);
    const Light lamp{.position = {0, 0, 0, 1}};
    far.lights = std::make_shared<const std::vector<Light>>(std::vector<Light>{lamp});
    s.out.list.add(std::move(far));
    return s.out;
}

// Texture coordinates far from 0: integer parts beyond every clamp, spans beyond 1024 repeats,
// different wraps in s and t.
namespace {

float any_start(Random& r) {
    return r.pick({0.0f, 1000.0f, 1023.0f, 1024.0f, 3000.0f, 262144.0f, 16777216.0f, 1073741824.0f,
                   3e38f, -1023.0f, -1025.0f, -5000.0f, -16777216.0f});
}

/// The length of a coordinate's range: nearly constant, a few repeats, or thousands.
float any_span(Random& r) { return r.pick({0.25f, 1.0f, 2.5f, 1024.0f, 1500.0f, 70000.0f}); }

MeshRef textured_square(Random& r, float size) {
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    const float s = any_start(r), t = any_start(r), ds = any_span(r), dt = any_span(r);
    data.texcoords = {{s, t}, {s + ds, t}, {s + ds, t + dt}, {s, t + dt}};
    return make_mesh(data);
}

/// q grows over the square by up to 2^30, so that s and t are small beside the largest of them.
dmat4 any_projector(Random& r) {
    dmat4 m(0);
    m[0][3] = r.pick({0.0, 1.0, 1e4, 1e8, -0.1});
    m[3][3] = r.pick({1.0, 0.5, -1.0, 1e-3});
    for (int i = 0; i < 3; ++i) {
        m[0][i] = r.real(-1, 1);
        m[1][i] = r.real(-1, 1);
        m[3][i] = r.real(-4, 4);
    }
    return m;
}

}  // namespace

Case far_coordinates_case(Random& r) {
    Script s{r, {r.pick(paper_profiles()), 24, 24}};
    s.frame = {s.out.width, s.out.height};
    s.state.projection[0][0] = s.state.projection[1][1] = 2.0 / 24;
    s.state.projection[3] = {-1, -1, 0, 1};
    add(s, Clear{all_planes});
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 16 * 8; ++i) texels.push_back(static_cast<std::uint16_t>(r.bits(16)));
    const TextureRef texture = make_texture("noise", 16, 8, texels);
    for (int i = 0; i < 10; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.env = TexEnv::Replace;
        if (r.chance(40)) {
            s.state.texture.gen = TexGen::EyeLinear;
            s.state.texture.eye_linear = any_projector(r);
        }
        set_state(s);
        s.out.list.add(Draw{.mesh = textured_square(r, 24), .map = {texture, {}}});
    }
    return s.out;
}

}  // namespace gw::conformance
