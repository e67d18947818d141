#include "scene/shapes/shapes.h"

#include "scene/shapes/grid.h"
#include "scene/shapes/teapot_data.h"

#include <glm/geometric.hpp>

namespace gw::scene {
namespace {

using BernsteinWeights = std::array<double, 4>;

// Bernstein polynomials at k / n, the same bits at k and n - k in mirrored order: patches that meet
// agree.
BernsteinWeights weights(int k, int n) {
    const double t = static_cast<double>(k) / n, u = static_cast<double>(n - k) / n;
    return {u * u * u, 3 * (t * u * u), 3 * (t * t * u), t * t * t};
}

// Their derivatives, from the differences of the control points, so that equal points have a
// derivative of exactly 0.
dvec3 differences(const std::array<dvec3, 4>& p, int k, int n) {
    const double t = static_cast<double>(k) / n, u = static_cast<double>(n - k) / n;
    return u * u * (p[1] - p[0]) + 2 * u * t * (p[2] - p[1]) + t * t * (p[3] - p[2]);
}

dvec3 sum(const std::array<dvec3, 4>& p, const BernsteinWeights& w) {
    return (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);
}

// y up: the published z is y, the published y is -z.
dvec3 control_point(int patch, std::size_t i) {
    const double* p = teapot_points[teapot_patches[patch][i]];
    return {p[0], p[2], -p[1]};
}

// The curve across the patch at row k of n, as four control points, and their derivative along the
// patch.
struct Across {
    std::array<dvec3, 4> points, along;
};

Across across(int patch, int row, int n) {
    Across curve;
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<dvec3, 4> column{control_point(patch, j), control_point(patch, 4 + j),
                                          control_point(patch, 8 + j),
                                          control_point(patch, 12 + j)};
        curve.points[j] = sum(column, weights(row, n));
        curve.along[j] = differences(column, row, n);
    }
    return curve;
}

// Patches side by side round the pot, and the part of t they take.
struct Band {
    int first, count;
    double t_first, t_last;
};

constexpr Band bands[] = {
    {0, 4, 1, 0.95},  {4, 4, 0.95, 0.35}, {8, 4, 0.35, 0},                   // rim, body
    {12, 2, 0, 0.5},  {14, 2, 0.5, 1},    {16, 2, 0, 0.6}, {18, 2, 0.6, 1},  // handle, spout
    {20, 4, 1, 0.55}, {24, 4, 0.55, 0},   {28, 4, 1, 0},                     // lid, bottom
};

// At the poles of lid and bottom all points of row 0 are one, and the derivative across is 0. There
// the normal is the limit of its neighbours: the derivative across grows as the mixed derivative.
dvec3 normal(const Across& curve, int column, int n) {
    const dvec3 along = sum(curve.along, weights(column, n));
    const dvec3 cross = differences(curve.points, column, n);
    return glm::cross(cross == dvec3(0) ? differences(curve.along, column, n) : cross, along);
}

MeshData make_patch(const Band& band, int ordinal, int n) {
    return make_grid(n, n, [&](int column, int row) {
        const Across curve = across(band.first + ordinal, row, n);
        const double turn = (ordinal + static_cast<double>(column) / n) / band.count;
        const double s = band.t_first > band.t_last ? 1 - turn : turn;  // not mirrored either way
        const double t = band.t_first + (band.t_last - band.t_first) * row / n;
        return GridVertex{sum(curve.points, weights(column, n)), normal(curve, column, n), {s, t}};
    });
}

}  // namespace

MeshData make_teapot(int segments) {
    MeshData mesh;
    for (const Band& band : bands)
        for (int i = 0; i < band.count; ++i) append(mesh, make_patch(band, i, segments));
    return mesh;
}

}  // namespace gw::scene
