// Reflection and refraction maps, a vector of vertices at a time. docs/manual.md, "Texture
// coordinates"; scalar twin: gw/stages/texgen.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/vertices/texgen.cpp"
#include <hwy/foreach_target.h>

#include "gw/base/arithmetic.h"
#include "gw/fast/vertices/eye-inl.h"
#include "gw/fast/vertices/texgen.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Any kind of generation.
inline void generate_one_by_one(const VertexProgram& p, std::span<const std::uint32_t> indices,
                                std::span<dvec4> strq) {
    for (const std::uint32_t i : indices) strq[i] = run_vertex(p, i).texcoord;
}

#if HWY_HAVE_FLOAT64

inline Vec3 reflected(const Vec3& u, const Vec3& n) {
    const auto k = hn::Mul(all(2), dot(n, u));
    return {hn::Sub(u.x, hn::Mul(k, n.x)), hn::Sub(u.y, hn::Mul(k, n.y)),
            hn::Sub(u.z, hn::Mul(k, n.z))};
}

/// The refracted ray, or the reflected one at total reflection.
inline Vec3 refracted(const Vec3& u, const Vec3& n, double eta) {
    const auto c = hn::Neg(dot(n, u));
    const auto root = hn::Sub(all(1), hn::Mul(all(eta * eta), hn::Sub(all(1), hn::Mul(c, c))));
    const auto total = hn::Lt(root, hn::Zero(D64()));
    const auto k = hn::Sub(hn::Mul(all(eta), c), hn::Sqrt(root));
    const auto through = [&](V64 u_i, V64 n_i) {
        return hn::Add(hn::Mul(all(eta), u_i), hn::Mul(k, n_i));
    };
    const Vec3 r = reflected(u, n);
    return {hn::IfThenElse(total, r.x, through(u.x, n.x)),
            hn::IfThenElse(total, r.y, through(u.y, n.y)),
            hn::IfThenElse(total, r.z, through(u.z, n.z))};
}

struct SphereLanes {
    V64 s, t;
};
inline SphereLanes sphere_map(const Vec3& d) {
    const auto z1 = hn::Add(d.z, all(1)), half = all(0.5);
    const auto square = hn::Add(hn::Add(hn::Mul(d.x, d.x), hn::Mul(d.y, d.y)), hn::Mul(z1, z1));
    const auto m = hn::Mul(all(2), hn::Sqrt(square));
    const auto some = hn::Gt(m, hn::Zero(D64()));
    const auto at = [&](V64 v) { return hn::IfThenElse(some, hn::Add(hn::Div(v, m), half), half); };
    return {at(d.x), at(d.y)};
}

/// bounded() of gw/base/arithmetic.h.
inline V64 bounded_lanes(V64 v, double limit) {
    return hn::IfThenElse(hn::Gt(v, all(-limit)),
                          hn::IfThenElse(hn::Lt(v, all(limit)), v, all(limit)), all(-limit));
}

void generate_all(const VertexProgram& p, std::span<const std::uint32_t> indices,
                  std::span<dvec4> strq) {
    const D64 d;
    const TextureState& state = p.state->texture;
    const bool is_map = state.gen == TexGen::SphereMap || state.gen == TexGen::RefractionMap;
    if (!is_map || !p.is_common) return generate_one_by_one(p, indices, strq);
    for (std::size_t first = 0; first < indices.size(); first += hn::Lanes(d)) {
        const auto some = indices.subspan(first, std::min(hn::Lanes(d), indices.size() - first));
        const EyeVertices v = eye_vertices(p, some);
        const Vec3 u = unit(v.position);
        const SphereLanes at =
            sphere_map(state.gen == TexGen::SphereMap ? reflected(u, v.normal)
                                                      : refracted(u, v.normal, state.eta));
        alignas(64) double s[8], t[8];
        hn::Store(bounded_lanes(at.s, largest_coordinate), d, s);
        hn::Store(bounded_lanes(at.t, largest_coordinate), d, t);
        for (std::size_t i = 0; i < some.size(); ++i) strq[some[i]] = {s[i], t[i], 0, 1};
    }
}

#else  // no vectors of doubles here

void generate_all(const VertexProgram& p, std::span<const std::uint32_t> indices,
                  std::span<dvec4> strq) {
    generate_one_by_one(p, indices, strq);
}

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(generate_all);

void generate_texcoords(const VertexProgram& program, std::span<const std::uint32_t> indices,
                        std::span<dvec4> strq) {
    HWY_DYNAMIC_DISPATCH(generate_all)(program, indices, strq);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
