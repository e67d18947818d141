// Vertices in eye space, a vector at a time: positions and normals as in run_vertex() of
// gw/stages/vertex.cpp. Included once per Highway target that has vectors of doubles.
#if defined(GW_FAST_EYE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_EYE_INL_H_
#undef GW_FAST_EYE_INL_H_
#else
#define GW_FAST_EYE_INL_H_
#endif

#include "gw/fast/simd/doubles-inl.h"
#include "gw/stages/vertex.h"

#include <span>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

/// dot3 and normalized of gw/base/types.h and gw/stages/vertex.h.
inline V64 dot(const Vec3& a, const Vec3& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
inline Vec3 unit(const Vec3& v) {
    const auto length = hn::Sqrt(dot(v, v));
    const auto some = hn::Gt(length, hn::Zero(D64()));
    const auto over = [&](V64 c) { return hn::IfThenElseZero(some, hn::Div(c, length)); };
    return {over(v.x), over(v.y), over(v.z)};
}
inline Vec3 minus(const Vec3& v) { return {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)}; }
/// Object coordinates of up to a vector of vertices, in order; lanes beyond the last repeat the
/// first.
inline Vec3 gather(const std::vector<vec3>& from, std::span<const std::uint32_t> indices) {
    const D64 d;
    if (indices.size() == hn::Lanes(d) && indices.back() - indices[0] + 1 == hn::Lanes(d))
        return points_at(&from[indices[0]]);
    alignas(64) double lanes[3][8];
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const vec3& v = from[indices[i < indices.size() ? i : 0]];
        for (int c = 0; c < 3; ++c) lanes[c][i] = v[c];
    }
    return {hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])};
}

/// The positions of at most one vector of vertices. Precondition: the program is affine.
inline Vec3 eye_position(const VertexProgram& p, std::span<const std::uint32_t> indices) {
    const Vec3 at = gather(p.draw->mesh->data().positions, indices);
    const dmat4& eye = p.draw->eye_from_object;
    return {row(eye, 0, at), row(eye, 1, at), row(eye, 2, at)};
}

/// eye_normal() of gw/stages/vertex.cpp.
inline Vec3 eye_normal(const VertexProgram& p, std::span<const std::uint32_t> indices) {
    const MeshData& mesh = p.draw->mesh->data();
    const Vec3 given =
        mesh.normals.empty() ? all3(given_normal(*p.draw, 0)) : gather(mesh.normals, indices);
    const dmat3& m = p.normal_eye_from_object;
    const Vec3 n{row(m, 0, given), row(m, 1, given), row(m, 2, given)};
    if (p.state->normalize) return unit(n);
    const auto scaled = [&](V64 v) {
        return bounded(hn::Mul(v, all(p.normal_scale)), largest_coordinate);
    };
    return {scaled(n.x), scaled(n.y), scaled(n.z)};
}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
