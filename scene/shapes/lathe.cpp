#include "scene/shapes/lathe.h"

#include "scene/shapes/grid.h"
#include "scene/shapes/revolve.h"

#include <glm/geometric.hpp>

namespace gw::scene {
namespace {

dvec2 point(const ProfileCurve& c, double t) {
    const double u = 1 - t;
    if (c.straight) return u * c.from + t * c.to;
    return (u * u * u * c.from + t * t * t * c.to) + 3 * u * t * (u * c.control1 + t * c.control2);
}

// A control point on an end leaves the direction to the other one.
dvec2 direction(const ProfileCurve& c, double t) {
    const double u = 1 - t;
    if (c.straight) return c.to - c.from;
    const dvec2 d = u * u * (c.control1 - c.from) + 2 * u * t * (c.control2 - c.control1) +
                    t * t * (c.to - c.control2);
    return d == dvec2(0) ? (t == 0 ? c.control2 - c.from : c.to - c.control1) : d;
}

// One curve as rows; t is the length of the chords so far.
std::vector<ProfilePoint> rows_of(const ProfileCurve& curve, int segments, double& length) {
    const int n = curve.straight ? 1 : segments;
    std::vector<ProfilePoint> rows;
    for (int i = 0; i <= n; ++i) {
        const double t = static_cast<double>(i) / n;
        const dvec2 p = point(curve, t), d = direction(curve, t);
        if (i > 0) length += glm::length(p - rows.back().position);
        rows.push_back({p, {d.y, -d.x}, length});
    }
    return rows;
}

}  // namespace

MeshData make_lathe(const Profile& profile, int slices, int segments) {
    double length = 0;
    std::vector<std::vector<ProfilePoint>> curves;
    for (const ProfileCurve& curve : profile) curves.push_back(rows_of(curve, segments, length));
    MeshData mesh;
    for (std::vector<ProfilePoint>& rows : curves) {
        for (ProfilePoint& row : rows) row.t /= length;
        append(mesh, revolve(rows, slices));
    }
    return mesh;
}

}  // namespace gw::scene
