// The matrices that OpenGL gets, and coordinates on our side.
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include <glm/matrix.hpp>

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gw::irisgl {

namespace {

dvec4 row(const dmat4& m, int i) { return {m[0][i], m[1][i], m[2][i], m[3][i]}; }

dvec4 times(const dmat4& m, const dvec4& v) {
    dvec4 out;
    for (int i = 0; i < 4; ++i) out[i] = dot4(row(m, i), v);
    return out;
}

void load(GLenum mode, const dmat4& m) {
    glMatrixMode(mode);
    glLoadMatrixd(&m[0][0]);
}

}  // namespace

void load_matrices() {
    const State& s = state();
    load(GL_PROJECTION, s.matrix_mode == MSINGLE ? dmat4(1) : s.projection);
    if (s.textured) load(GL_TEXTURE, s.texture);
    load(GL_MODELVIEW, s.matrices.back());
}

dvec4 clip_from_object(const dvec4& p) {
    const State& s = state();
    const dvec4 eye = times(s.matrices.back(), p);
    return s.matrix_mode == MSINGLE ? eye : times(s.projection, eye);
}

std::optional<dvec3> window_from_object(const dvec4& p) {
    const dvec4 clip = clip_from_object(p);
    if (!(clip.w > 0)) return std::nullopt;
    const Bounds& v = state().viewport;
    const double near = depth_of_range(state().near), far = depth_of_range(state().far);
    return dvec3{v.left + (clip.x / clip.w + 1) / 2 * v.width(),
                 v.bottom + (clip.y / clip.w + 1) / 2 * v.height(),
                 near + (clip.z / clip.w + 1) / 2 * (far - near)};
}

namespace {

bool is_finite(const dvec4& p) { return std::isfinite(p.x + p.y + p.z + p.w); }

/// Moves vertices on the screen, by their object coordinates. Their depth stays, unless that needs
/// far greater moves than others: of shadows on a plane, or after scale(x, y, 0).
class Mover {
public:
    explicit Mover(const dmat4& clip_from_object)
        : matrix_(clip_from_object), inverse_(glm::inverse(matrix_)) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) products_[i][j] = dot4(row_of(i), row_of(j));
        products_ = glm::inverse(products_);
        constexpr double most = 100;
        for (int i = 0; i < 2; ++i) {
            dvec4 move(0);
            move[i] = 1;
            const dvec4 least = smallest(move), exact = inverse_[i];
            keeps_depth_ &= dot4(exact, exact) <= most * most * dot4(least, least);
        }
    }

    /// The mover of the matrices now; the last one is kept.
    static const Mover& now() {
        const State& s = state();
        const dmat4& m = s.matrices.back();
        const dmat4 matrix = s.matrix_mode == MSINGLE ? m : s.projection * m;
        static Mover last(matrix);
        if (last.matrix_ != matrix) last = Mover(matrix);
        return last;
    }

    /// Not moved if that cannot be.
    dvec4 moved(const dvec4& p, const dvec4& from, const dvec4& to) const {
        const dvec4 there = keeps_depth_ ? times(inverse_, to) : p + smallest(to - from);
        return is_finite(there) ? there : p;
    }

private:
    /// The row that makes x, y or w.
    dvec4 row_of(int i) const { return row(matrix_, i < 2 ? i : 3); }
    dvec4 smallest(const dvec4& move) const {
        const dvec3 parts = products_ * dvec3(move.x, move.y, move.w);
        return parts.x * row_of(0) + parts.y * row_of(1) + parts.z * row_of(2);
    }

    dmat4 matrix_, inverse_;
    bool keeps_depth_ = true;
    dmat3 products_{1};  ///< of the rows, inverted
};

}  // namespace

void snap_to_pixels(std::span<Vertex> vertices, bool is_area) {
    const Mover& mover = Mover::now();
    const Bounds& view = state().viewport;
    // A number that rounding put just beside a pixel's side is on it.
    constexpr double tiny = 1.0 / 4096;
    const auto upper = [](double v) { return std::floor(v + tiny) + 0.5; };
    const auto lower = [](double v) { return std::ceil(v - tiny) - 0.5; };
    for (Vertex& v : vertices) {
        const dvec4 from = clip_from_object(v.p);
        dvec4 clip = from;
        if (!(clip.w > 0)) continue;
        const double x = upper((clip.x / clip.w + 1) / 2 * view.width());
        const double at = (clip.y / clip.w + 1) / 2 * view.height();
        const double y = is_area ? lower(at) : upper(at);
        clip.x = (x / view.width() * 2 - 1) * clip.w;
        clip.y = (y / view.height() * 2 - 1) * clip.w;
        v.p = mover.moved(v.p, from, clip);
    }
}

bool own_edge_pixels(std::vector<dvec4>& corners) {
    const Bounds& view = state().viewport;
    std::array<dvec4, 4> clip;
    std::array<dvec2, 4> at;
    for (std::size_t i = 0; i < 4; ++i) {
        clip[i] = clip_from_object(corners[i]);
        if (!(clip[i].w > 0)) return false;
        at[i] = {(clip[i].x / clip[i].w + 1) / 2 * view.width(),
                 (clip[i].y / clip[i].w + 1) / 2 * view.height()};
    }
    const auto same = [](double a, double b) { return std::abs(a - b) < 1e-3; };
    const bool upright = same(at[0].y, at[1].y) && same(at[1].x, at[2].x) && same(at[2].y, at[3].y);
    const bool turned = same(at[0].x, at[1].x) && same(at[1].y, at[2].y) && same(at[2].x, at[3].x);
    if (!upright && !turned) return false;
    dvec2 low = at[0], high = at[0];
    for (const dvec2& p : at) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const bool right = same(low.x, high.x) ? i == 1 || i == 2 : same(at[i].x, high.x);
        const bool upper = same(low.y, high.y) ? i >= 2 : same(at[i].y, high.y);
        const double x = right ? std::floor(high.x) + 1 : std::floor(low.x);
        const double y = upper ? std::floor(high.y) + 1 : std::floor(low.y);
        clip[i].x = (x / view.width() * 2 - 1) * clip[i].w;
        clip[i].y = (y / view.height() * 2 - 1) * clip[i].w;
    }
    const Mover& mover = Mover::now();
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = mover.moved(corners[i], clip_from_object(corners[i]), clip[i]);
    return true;
}

double depth_of(long z) {
    const double at = double(std::int32_t(std::uint32_t(z)) - z_min) / double(z_max - z_min);
    return std::clamp(at, 0.0, 1.0);
}

double depth_of_range(long z) {
    if (!program().are_depths_mapped) return depth_of(z);
    return std::clamp(double(std::int32_t(std::uint32_t(z))) / double(z_max), 0.0, 1.0);
}

}  // namespace gw::irisgl
