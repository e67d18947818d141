// Lighting at the ends of its range: lengths that overflow or vanish, infinite strengths, NaN.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

using namespace fuzz;

namespace {

/// A component of any size, its ends too.
float any_size(Random& r) {
    return r.pick({0.0f, 1.0f, -1.0f, 1e-45f, 1e-30f, 3e38f, -3e38f, 1e20f, 0.5f, -2.0f});
}
vec3 any_vector(Random& r) { return {any_size(r), any_size(r), any_size(r)}; }

Light any_light(Random& r) {
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
MeshRef square(Random& r, int width, int height) {
    MeshData data{.primitive = Primitive::Quads};
    const float w = float(width), h = float(height);
    data.positions = {{0, 0, 0}, {w, 0, 0}, {w, h, 0}, {0, h, 0}};
    for (int i = 0; i < 4; ++i)
        data.normals.push_back(r.chance(40) ? vec3(0, 0, 1) : any_vector(r));
    return make_mesh(data);
}

}  // namespace

Case extreme_lights_case(Random& r) {
    Script s{r, {r.pick(profiles()), 12, 12}};
    s.frame = {s.out.width, s.out.height};
    s.state.color_source = ColorSource::Lighting;
    s.state.projection[0][0] = s.state.projection[1][1] = 2.0 / 12;
    s.state.projection[2][2] = 0;  // depth 0 wherever the eye space is
    s.state.projection[3] = {-1, -1, 0, 1};
    add(s, Clear{all_planes});
    for (int i = 0; i < 10; ++i) {
        s.state.lighting = {r.chance(50), r.chance(50), vec4(any_vector(r), 1)};
        set_state(s);
        Draw d{.mesh = square(r, s.out.width, s.out.height)};
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
                      any_size(r)};
        std::vector<Light> lights;
        const int count = r.between(0, 3);
        for (int k = 0; k < count; ++k) lights.push_back(any_light(r));
        d.lights = std::make_shared<const std::vector<Light>>(std::move(lights));
        s.out.list.add(std::move(d));
    }
    // [R8.7] Eye coordinates overflow where clip coordinates do not: a cosine is NaN.
    Draw far{.mesh = square(r, s.out.width, s.out.height)};
    far.eye_from_object[0].z = 1e308;
    far.eye_from_object[3].z = 1.5e308;
    far.material.Ke = vec3(0.5f);
    const Light lamp{.position = {0, 0, 0, 1}};
    far.lights = std::make_shared<const std::vector<Light>>(std::vector<Light>{lamp});
    s.out.list.add(std::move(far));
    return s.out;
}

}  // namespace gw::conformance
