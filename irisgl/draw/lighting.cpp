// IRIS GL's materials, lights and lighting models in OpenGL.
#include "irisgl/draw/apply.h"

#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "gw/base/elementary.h"

#include <GL/gl.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::irisgl {

namespace {

void material(GLenum face, const Material& m) {
    const vec4 none{0, 0, 0, 1};
    vec4 diffuse = m.diffuse;
    diffuse.w = m.alpha;
    glMaterialfv(face, GL_AMBIENT, &m.ambient[0]);
    glMaterialfv(face, GL_DIFFUSE, &diffuse[0]);
    glMaterialfv(face, GL_SPECULAR, m.shininess > 0 ? &m.specular[0] : &none[0]);
    glMaterialfv(face, GL_EMISSION, &m.emission[0]);
    glMaterialf(face, GL_SHININESS, std::clamp(m.shininess, 0.0f, 128.0f));
}

const Material& bound_material(short index) { return program().materials[index]; }

}  // namespace

void apply_materials() {
    const Bound& bound = state().bound;
    if (bound.material != 0) material(GL_FRONT_AND_BACK, bound_material(bound.material));
    if (bound.back_material != 0) material(GL_BACK, bound_material(bound.back_material));
}

void apply_light(int number) {
    const Bound& bound = state().bound;
    const GLenum name = GL_LIGHT0 + GLenum(number);
    const short index = bound.lights[std::size_t(number)];
    (index != 0 ? glEnable : glDisable)(name);
    if (index == 0) return;
    const Light& light = program().lights[index];
    glLightfv(name, GL_AMBIENT, &light.ambient[0]);
    glLightfv(name, GL_DIFFUSE, &light.color[0]);
    glLightfv(name, GL_SPECULAR, &light.color[0]);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();  // the bound places are of eye space
    glLightfv(name, GL_POSITION, &bound.positions[std::size_t(number)][0]);
    glLightfv(name, GL_SPOT_DIRECTION, &bound.directions[std::size_t(number)][0]);
    glLightf(name, GL_SPOT_EXPONENT, std::clamp(light.exponent, 0.0f, 128.0f));
    glLightf(name, GL_SPOT_CUTOFF, light.spread >= 0 && light.spread <= 90 ? light.spread : 180);
    const LightModel& model = program().models[bound.model];
    glLightf(name, GL_CONSTANT_ATTENUATION, model.attenuation.x);
    glLightf(name, GL_LINEAR_ATTENUATION, model.attenuation.y);
    glLightf(name, GL_QUADRATIC_ATTENUATION, model.attenuation2);
}

void apply_light_model() {
    const LightModel& model = program().models[state().bound.model];
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &model.ambient[0]);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, model.two_side ? 1 : 0);
    for (int i = 0; i < light_count; ++i) apply_light(i);
}

void apply_color_mode() {
    const long mode = state().bound.color_mode;
    glDisable(GL_COLOR_MATERIAL);
    if (mode == LMC_COLOR || mode == LMC_NULL) return apply_materials();
    constexpr GLenum words[] = {GL_EMISSION, GL_EMISSION, GL_AMBIENT,
                                GL_DIFFUSE,  GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
    apply_materials();
    glColorMaterial(GL_FRONT_AND_BACK, words[mode]);
    glEnable(GL_COLOR_MATERIAL);
}

void emit_material(bool is_lit, const vec4& rgb) {
    if (is_lit) return apply_materials();
    const vec4 none{0, 0, 0, rgb.w};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &none[0]);
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &none[0]);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &none[0]);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, &rgb[0]);
}

namespace {

dvec3 normalized(const dvec3& v) {
    const double l = length(v);
    return l > 0 ? dvec3{v.x / l, v.y / l, v.z / l} : v;
}

dvec3 eye_normal(const vec3& n) {
    const dmat3 inverse = glm::inverse(dmat3(state().matrices.back()));
    const dvec3 v{n.x, n.y, n.z};
    return normalized({dot3(inverse[0], v), dot3(inverse[1], v), dot3(inverse[2], v)});
}

dvec3 eye_point(const dvec4& p) {
    const dmat4& m = state().matrices.back();
    dvec3 out;
    for (int i = 0; i < 3; ++i) out[i] = dot4({m[0][i], m[1][i], m[2][i], m[3][i]}, p);
    return out;
}

/// Diffuse and specular sums of all lights; only their brightness counts.
dvec2 brightness(const dvec3& n, const dvec3& at, const Material& m) {
    const Bound& bound = state().bound;
    dvec2 sum{0, 0};
    for (std::size_t i = 0; i < bound.lights.size(); ++i) {
        if (bound.lights[i] == 0) continue;
        const vec4& place = bound.positions[i];
        const dvec3 p{place.x, place.y, place.z};
        const dvec3 l = normalized(place.w == 0 ? p : p - at);
        const dvec3 h = normalized(l + dvec3{0, 0, 1});
        const double facing = dot3(n, l);
        if (facing <= 0) continue;
        const vec4& c = program().lights[bound.lights[i]].color;
        const double strength = 0.3 * double(c.x) + 0.59 * double(c.y) + 0.11 * double(c.z);
        sum.x += strength * facing;
        if (m.shininess > 0)
            sum.y += strength * gw::pow(std::max(dot3(n, h), 0.0), double(m.shininess));
    }
    return {std::min(sum.x, 1.0), std::min(sum.y, 1.0)};
}

}  // namespace

// ambient + (1 - specular) * diffuse * (d - a) + specular * (s - a), as the porting guides say it.
void light_indices(std::vector<Vertex>& vertices) {
    const Material& m = bound_material(state().bound.material);
    for (Vertex& v : vertices) {
        if (!v.is_lit) continue;
        const dvec2 sum = brightness(eye_normal(v.normal), eye_point(v.p), m);
        const double a = double(m.indices.x), d = double(m.indices.y), s = double(m.indices.z);
        v.index = std::min(a + sum.x * (1 - sum.y) * (d - a) + sum.y * (s - a), std::max(d, s));
    }
}

}  // namespace gw::irisgl
