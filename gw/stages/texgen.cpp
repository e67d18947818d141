// Sphere maps by reflected and refracted rays [K3.1, K1], and coordinates linear in eye space.
#include "gw/stages/texgen.h"

#include "gw/stages/vertex.h"

#include <cmath>

namespace gw {

dvec2 sphere_map(const dvec3& d) {
    const double z1 = d.z + 1;
    const double m = 2 * std::sqrt((d.x * d.x + d.y * d.y) + z1 * z1);
    return m > 0 ? dvec2(d.x / m + 0.5, d.y / m + 0.5) : dvec2(0.5, 0.5);
}

dvec3 reflected(const dvec3& u, const dvec3& n) {
    const double k = 2 * dot3(n, u);
    return {u.x - k * n.x, u.y - k * n.y, u.z - k * n.z};
}

dvec3 refracted(const dvec3& u, const dvec3& n, double eta) {
    const double c = -dot3(n, u);
    const double root = 1 - (eta * eta) * (1 - c * c);
    if (root < 0) return reflected(u, n);
    const double k = eta * c - std::sqrt(root);
    return {eta * u.x + k * n.x, eta * u.y + k * n.y, eta * u.z + k * n.z};
}

namespace {

dvec2 reflection_map(const TexgenInput& v) {
    return sphere_map(reflected(normalized(v.p_eye), v.n_eye));
}

dvec4 by_coordinate(const std::array<CoordinateGen, 4>& rules, const TexgenInput& v) {
    dvec4 out = v.given;
    for (int i = 0; i < 4; ++i) {
        const auto& [mode, plane] = rules[std::size_t(i)];
        switch (mode) {
            case CoordinateMode::Given: break;
            case CoordinateMode::ObjectLinear: out[i] = dot4(plane, v.p_object); break;
            case CoordinateMode::EyeLinear: out[i] = dot4(plane, v.p_eye4); break;
            case CoordinateMode::SphereMap: out[i] = reflection_map(v)[i]; break;
            case CoordinateMode::NormalMap: out[i] = v.n_eye[i]; break;
            case CoordinateMode::ReflectionMap:
                out[i] = reflected(normalized(v.p_eye), v.n_eye)[i];
                break;
        }
    }
    return out;
}

dvec4 generated(const TextureState& state, const TexgenInput& v) {
    switch (state.gen) {
        case TexGen::None: return v.given;
        case TexGen::SphereMap: return {reflection_map(v), 0, 1};
        case TexGen::RefractionMap:
            return {sphere_map(refracted(normalized(v.p_eye), v.n_eye, state.eta)), 0, 1};
        case TexGen::EyeLinear: return transform(state.eye_linear, v.p_eye4);
        case TexGen::PerCoordinate: return by_coordinate(state.coordinates, v);
    }
    return v.given;
}

bool generates_q(const TextureState& state) {
    return state.gen == TexGen::EyeLinear || (state.gen == TexGen::PerCoordinate &&
                                              state.coordinates[3].mode != CoordinateMode::Given);
}

bool keeps_q(const dmat4& m) {
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

bool gives_q(const Draw& draw, std::size_t unit) {
    if (unit > 0) {
        const UnitTexcoords& own = draw.mesh->data().more_texcoords[unit - 1];
        if (!own.st.empty()) return !own.rq.empty();
        return draw.current && draw.current->more_texcoords[unit - 1].w != 1;
    }
    if (!draw.mesh->data().texcoords.empty()) return !draw.mesh->data().texcoords_rq.empty();
    return draw.current && draw.current->texcoord.w != 1;
}

}  // namespace

dvec4 texture_coordinates(const TextureState& state, const TexgenInput& vertex) {
    const dvec4 out = generated(state, vertex);
    return state.matrix == dmat4(1) ? out : transform(state.matrix, out);
}

bool divides_by_q(const TextureState& state, const Draw& draw, std::size_t unit) {
    const TextureBinding& map = map_of(draw, unit);
    if (map.texture && needs_r(*map.texture)) return true;
    if (map.surface && map.surface->plane == Plane::Depth) return true;
    const bool takes_given = state.gen == TexGen::None || state.gen == TexGen::PerCoordinate;
    return generates_q(state) || !keeps_q(state.matrix) || (takes_given && gives_q(draw, unit));
}

}  // namespace gw
