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

dvec4 texture_coordinates(const TextureState& state, const vec2& st, const dvec4& p_eye,
                          const dvec3& n_eye) {
    switch (state.gen) {
        case TexGen::None: return {st.x, st.y, 0, 1};
        case TexGen::SphereMap:
            return {sphere_map(reflected(normalized(dvec3(p_eye)), n_eye)), 0, 1};
        case TexGen::RefractionMap:
            return {sphere_map(refracted(normalized(dvec3(p_eye)), n_eye, state.eta)), 0, 1};
        case TexGen::EyeLinear: return transform(state.eye_linear, p_eye);
    }
    return {0, 0, 0, 1};
}

}  // namespace gw
