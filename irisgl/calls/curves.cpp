// Cubic curves and patches: points on them, joined by lines.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace gw::irisgl::calls {

namespace {

constexpr long most_segments = 1000;  ///< of a curve, or curves of a patch

std::optional<dmat4> basis(const char* function, long id) {
    const auto found = program().bases.find(short(id));
    if (found != program().bases.end()) return found->second;
    warn(std::string(function) + ": basis " + std::to_string(id) +
         " is not defined; it is ignored");
    return std::nullopt;
}

/// The weights of the four control points at t: (t^3 t^2 t 1) times the basis, whose rows are the
/// columns of `m`.
dvec4 weights(const dmat4& m, double t) {
    const dvec4 powers{t * t * t, t * t, t, 1};
    dvec4 out;
    for (int i = 0; i < 4; ++i) out[i] = dot4(powers, {m[0][i], m[1][i], m[2][i], m[3][i]});
    return out;
}

dvec4 mixed(const dvec4& w, const std::array<dvec4, 4>& p) {
    dvec4 out;
    for (int i = 0; i < 4; ++i) out[i] = dot4(w, {p[0][i], p[1][i], p[2][i], p[3][i]});
    return out;
}

void line(const std::vector<dvec4>& points) {
    std::vector<Vertex> vertices;
    for (const dvec4& p : points) vertices.push_back(vertex_here(p.x, p.y, p.z, p.w));
    draw_shape(Shape::Line, vertices);
    if (!points.empty()) state().position = points.back();
}

void segment(const dmat4& m, const std::array<dvec4, 4>& control) {
    std::vector<dvec4> points;
    const long n = state().curve_segments;
    for (long i = 0; i <= n; ++i)
        points.push_back(mixed(weights(m, double(i) / double(n)), control));
    line(points);
}

using Grid = std::array<std::array<dvec4, 4>, 4>;

/// A curve of a patch: one parameter is `fixed`, the other goes from 0 to 1.
void patch_curve(const Grid& grid, const dvec4& fixed, const dmat4& along, long n, bool is_u) {
    std::vector<dvec4> points;
    for (long i = 0; i <= n; ++i) {
        const dvec4 moving = weights(along, double(i) / double(n));
        std::array<dvec4, 4> rows;
        for (std::size_t r = 0; r < 4; ++r)
            rows[r] =
                mixed(is_u ? moving : fixed, {grid[0][r], grid[1][r], grid[2][r], grid[3][r]});
        points.push_back(mixed(is_u ? fixed : moving, rows));
    }
    line(points);
}

void draw_patch(const Grid& grid) {
    const State& s = state();
    const auto u = basis("patch", s.u_basis), v = basis("patch", s.v_basis);
    if (!u || !v) return;
    const auto at = [](long i, long n) { return n > 1 ? double(i) / double(n - 1) : 0.0; };
    for (long i = 0; i < s.u_curves; ++i)
        patch_curve(grid, weights(*v, at(i, s.u_curves)), *u, s.u_segments, true);
    for (long i = 0; i < s.v_curves; ++i)
        patch_curve(grid, weights(*u, at(i, s.v_curves)), *v, s.v_segments, false);
}

Grid grid_of(Values x, Values y, Values z, const Values* w) {
    Grid grid;
    for (std::size_t i = 0; i < 16; ++i)
        grid[i / 4][i % 4] = {double(x[i]), double(y[i]), double(z[i]),
                              w != nullptr ? double((*w)[i]) : 1};
    return grid;
}

}  // namespace

void defbasis(short id, Values m) {
    dmat4 out;
    for (std::size_t i = 0; i < 16; ++i) out[int(i / 4)][int(i % 4)] = double(m[i]);
    program().bases[id] = out;
}
void curvebasis(short id) {
    if (basis("curvebasis", id)) state().basis = id;
}
void curveprecision(short segments) {
    state().curve_segments = std::clamp<long>(segments, 1, most_segments);
}
void patchbasis(long u, long v) {
    if (!basis("patchbasis", u) || !basis("patchbasis", v)) return;
    state().u_basis = short(u);
    state().v_basis = short(v);
}
void patchcurves(long u, long v) {
    state().u_curves = std::clamp(u, 0L, most_segments);
    state().v_curves = std::clamp(v, 0L, most_segments);
}
void patchprecision(long u, long v) {
    state().u_segments = std::clamp(u, 1L, most_segments);
    state().v_segments = std::clamp(v, 1L, most_segments);
}

void curve(long n, Values points, int dimensions) {
    const auto m = basis("crv", state().basis);
    if (!m) return;
    std::vector<dvec4> control;
    for (std::size_t i = 0;
         i + std::size_t(dimensions) <= points.size() && long(control.size()) < n;
         i += std::size_t(dimensions))
        control.push_back({double(points[i]), double(points[i + 1]), double(points[i + 2]),
                           dimensions > 3 ? double(points[i + 3]) : 1});
    for (std::size_t i = 0; i + 4 <= control.size(); ++i)
        segment(*m, {control[i], control[i + 1], control[i + 2], control[i + 3]});
}

// Forward differences: the current matrix' last row is the point; each step adds the rows below.
void curveit(short iterations) {
    dmat4 m = state().matrices.back();
    std::vector<dvec4> points;
    const dmat4 kept = m;
    for (int i = 0; i <= iterations; ++i) {
        points.push_back(m[3]);
        m[3] += m[2];
        m[2] += m[1];
        m[1] += m[0];
    }
    state().matrices.back() = dmat4(1);
    line(points);
    state().matrices.back() = kept;
}

void patch(Values x, Values y, Values z) { draw_patch(grid_of(x, y, z, nullptr)); }
void rpatch(Values x, Values y, Values z, Values w) { draw_patch(grid_of(x, y, z, &w)); }

}  // namespace gw::irisgl::calls
