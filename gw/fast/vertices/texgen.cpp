// Texture coordinates, a vector of vertices at a time. docs/manual.md, "Texture coordinates"; scalar
// twin: gw/stages/texgen.cpp.
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

/// Any vertices.
inline void generate_one_by_one(const VertexProgram& p, std::size_t of,
                                std::span<const std::uint32_t> indices, std::span<dvec4> strq) {
    for (const std::uint32_t i : indices) strq[i] = run_vertex(p, i).texcoord_of(of);
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

inline V64 component(const Vec3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

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

struct Vec4 {
    V64 lane[4];  ///< s, t, r, q
};

/// transform() of gw/stages/vertex.h.
inline Vec4 transform(const dmat4& m, const Vec4& v) {
    const auto at = [&](int i) {
        const auto product = [&](int k) { return hn::Mul(all(m[k][i]), v.lane[k]); };
        return hn::Add(hn::Add(product(0), product(1)), hn::Add(product(2), product(3)));
    };
    return {{at(0), at(1), at(2), at(3)}};
}

/// given_texcoord() of gw/stages/vertex.h. Lanes beyond the last vertex repeat the first.
inline Vec4 given_texcoords(const Draw& draw, std::size_t of,
                            std::span<const std::uint32_t> indices) {
    const D64 d;
    const MeshData& mesh = draw.mesh->data();
    if ((of == 0 ? mesh.texcoords : mesh.more_texcoords[of - 1].st).empty()) {
        const dvec4 one = given_texcoord(draw, indices[0], of);
        return {{all(one.x), all(one.y), all(one.z), all(one.w)}};
    }
    alignas(64) double lanes[4][8];
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const dvec4 v = given_texcoord(draw, indices[i < indices.size() ? i : 0], of);
        for (int c = 0; c < 4; ++c) lanes[c][i] = v[c];
    }
    return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2]),
             hn::Load(d, lanes[3])}};
}

/// Up to a vector of vertices of one draw. Precondition: the program is affine.
struct TexgenLanes {
    const VertexProgram& p;
    std::size_t of;  ///< the texture unit
    std::span<const std::uint32_t> indices;
    const TextureState& state = texture_of(*p.state, of);

    SphereLanes map() const {
        const Vec3 u = unit(eye_position(p, indices)), n = eye_normal(p, indices);
        return sphere_map(state.gen == TexGen::RefractionMap ? refracted(u, n, state.eta)
                                                             : reflected(u, n));
    }

    /// All coordinates lie on planes of one kind.
    bool all_are(CoordinateMode mode) const {
        return std::ranges::all_of(state.coordinates,
                                   [&](const auto& of_one) { return of_one.mode == mode; });
    }
    Vec4 on_planes(const Vec3& at) const {
        const auto on = [&](std::size_t i) { return dot(state.coordinates[i].plane, at); };
        return {{on(0), on(1), on(2), on(3)}};
    }
    Vec4 by_coordinate() const {
        if (all_are(CoordinateMode::EyeLinear)) return on_planes(eye_position(p, indices));
        return one_by_one();
    }
    Vec4 one_by_one() const {
        Vec4 out = given_texcoords(*p.draw, of, indices);
        for (int i = 0; i < 4; ++i) {
            const auto& [mode, plane] = state.coordinates[std::size_t(i)];
            V64& lane = out.lane[i];
            switch (mode) {
                case CoordinateMode::Given: break;
                case CoordinateMode::ObjectLinear:
                    lane = dot(plane, gather(p.draw->mesh->data().positions, indices));
                    break;
                case CoordinateMode::EyeLinear: lane = dot(plane, eye_position(p, indices)); break;
                case CoordinateMode::SphereMap: lane = i == 0 ? map().s : map().t; break;
                case CoordinateMode::NormalMap: lane = component(eye_normal(p, indices), i); break;
                case CoordinateMode::ReflectionMap:
                    lane = component(
                        reflected(unit(eye_position(p, indices)), eye_normal(p, indices)), i);
                    break;
            }
        }
        return out;
    }

    Vec4 generated() const {
        switch (state.gen) {
            case TexGen::None: break;
            case TexGen::SphereMap:
            case TexGen::RefractionMap: {
                const SphereLanes at = map();
                return {{at.s, at.t, all(0), all(1)}};
            }
            case TexGen::EyeLinear: {
                const Vec3 at = eye_position(p, indices);
                const dmat4& m = state.eye_linear;
                return {{row(m, 0, at), row(m, 1, at), row(m, 2, at), row(m, 3, at)}};
            }
            case TexGen::PerCoordinate: return by_coordinate();
        }
        return given_texcoords(*p.draw, of, indices);
    }
};

void generate_all(const VertexProgram& p, std::size_t of, std::span<const std::uint32_t> indices,
                  std::span<dvec4> strq) {
    if (!p.is_affine) return generate_one_by_one(p, of, indices, strq);
    const D64 d;
    const dmat4& matrix = texture_of(*p.state, of).matrix;
    const bool transforms = matrix != dmat4(1), is_line = is_one_dimensional(*p.draw, of);
    for (std::size_t first = 0; first < indices.size(); first += hn::Lanes(d)) {
        const auto some = indices.subspan(first, std::min(hn::Lanes(d), indices.size() - first));
        Vec4 at = TexgenLanes{p, of, some}.generated();
        if (transforms) at = transform(matrix, at);
        if (is_line) at.lane[1] = all(0);
        alignas(64) double out[4][8];
        for (int c = 0; c < 4; ++c) hn::Store(bounded(at.lane[c], largest_coordinate), d, out[c]);
        for (std::size_t i = 0; i < some.size(); ++i)
            strq[some[i]] = {out[0][i], out[1][i], out[2][i], out[3][i]};
    }
}

#else  // no vectors of doubles here

void generate_all(const VertexProgram& p, std::size_t of, std::span<const std::uint32_t> indices,
                  std::span<dvec4> strq) {
    generate_one_by_one(p, of, indices, strq);
}

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(generate_all);

void generate_texcoords(const VertexProgram& program, std::size_t unit,
                        std::span<const std::uint32_t> indices, std::span<dvec4> strq) {
    HWY_DYNAMIC_DISPATCH(generate_all)(program, unit, indices, strq);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
