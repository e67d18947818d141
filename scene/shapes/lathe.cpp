#include "scene/shapes/lathe.h"

#include "gw/base/elementary.h"
#include "scene/shapes/grid.h"

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

// Draws a profile as a pen does.
class Pen {
public:
    explicit Pen(dvec2 start) : at_(start) {}
    Pen& line(dvec2 to) { return add({at_, at_, to, to, true}); }
    Pen& curve(dvec2 control1, dvec2 control2, dvec2 to) {
        return add({at_, control1, control2, to, false});
    }
    LatheProfile done() { return std::move(profile_); }

private:
    Pen& add(const ProfileCurve& curve) {
        profile_.push_back(curve);
        at_ = curve.to;
        return *this;
    }
    LatheProfile profile_;
    dvec2 at_;
};

}  // namespace

MeshData make_lathe(const LatheProfile& profile, int slices, int segments) {
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

LatheProfile bottle_profile() {
    return Pen({0, 0.03})
        .curve({0.06, 0.03}, {0.12, 0.02}, {0.15, 0})       // a hollow under the bottom
        .curve({0.18, 0}, {0.19, 0.015}, {0.19, 0.05})      //
        .curve({0.195, 0.2}, {0.195, 0.35}, {0.19, 0.5})    // wall
        .curve({0.185, 0.64}, {0.07, 0.62}, {0.065, 0.78})  // shoulder and neck
        .line({0.06, 0.93})                                 //
        .curve({0.085, 0.93}, {0.085, 1}, {0.06, 1})        // lip
        .curve({0.045, 1}, {0.045, 0.98}, {0.045, 0.96})    // inside
        .curve({0.045, 0.9}, {0.05, 0.84}, {0.05, 0.78})    //
        .curve({0.055, 0.61}, {0.17, 0.63}, {0.175, 0.5})   //
        .curve({0.18, 0.35}, {0.18, 0.2}, {0.175, 0.07})    //
        .curve({0.17, 0.04}, {0.08, 0.05}, {0, 0.05})
        .done();
}

LatheProfile bowl_profile() {
    return Pen({0, 0.06})
        .line({0.24, 0.06})                                //
        .line({0.26, 0})                                   // foot
        .line({0.34, 0})                                   //
        .curve({0.36, 0.02}, {0.32, 0.06}, {0.34, 0.1})    //
        .curve({0.75, 0.16}, {0.95, 0.55}, {1, 0.96})      // outside
        .curve({1.005, 1}, {0.965, 1.015}, {0.955, 0.97})  // lip
        .curve({0.9, 0.58}, {0.7, 0.2}, {0.3, 0.16})       // inside
        .curve({0.2, 0.15}, {0.1, 0.15}, {0, 0.15})
        .done();
}

LatheProfile goblet_profile() {
    return Pen({0, 0})
        .line({0.27, 0})                                      //
        .curve({0.3, 0}, {0.3, 0.03}, {0.27, 0.035})          // foot
        .curve({0.15, 0.05}, {0.05, 0.06}, {0.035, 0.16})     //
        .curve({0.03, 0.2}, {0.03, 0.22}, {0.04, 0.24})       // stem
        .curve({0.075, 0.245}, {0.075, 0.305}, {0.04, 0.31})  // knob
        .curve({0.03, 0.34}, {0.03, 0.38}, {0.04, 0.42})      //
        .curve({0.06, 0.5}, {0.3, 0.48}, {0.3, 0.72})         // cup
        .curve({0.3, 0.84}, {0.27, 0.92}, {0.255, 0.99})      //
        .curve({0.253, 1}, {0.24, 1}, {0.24, 0.985})          // lip
        .curve({0.26, 0.9}, {0.285, 0.82}, {0.28, 0.72})      // inside
        .curve({0.28, 0.52}, {0.1, 0.5}, {0, 0.5})
        .done();
}

LatheProfile pedestal_profile() {
    return Pen({0, 0})
        .line({0.3, 0})                                     //
        .line({0.3, 0.06})                                  // plinth
        .curve({0.345, 0.06}, {0.345, 0.12}, {0.29, 0.12})  // torus
        .curve({0.25, 0.13}, {0.245, 0.15}, {0.24, 0.18})   //
        .curve({0.235, 0.4}, {0.23, 0.6}, {0.21, 0.82})     // shaft
        .curve({0.21, 0.86}, {0.27, 0.86}, {0.29, 0.9})     // capital
        .line({0.32, 0.9})                                  //
        .line({0.32, 1})                                    // plate
        .line({0, 1})
        .done();
}

LatheProfile vase_profile() {
    return Pen({0, 0.02})
        .line({0.13, 0.02})                                 //
        .line({0.14, 0})                                    // foot
        .line({0.17, 0})                                    //
        .curve({0.19, 0.01}, {0.165, 0.03}, {0.17, 0.05})   //
        .curve({0.2, 0.16}, {0.36, 0.3}, {0.34, 0.5})       // belly
        .curve({0.32, 0.68}, {0.12, 0.7}, {0.12, 0.84})     // shoulder and neck
        .curve({0.12, 0.91}, {0.16, 0.96}, {0.215, 0.985})  // mouth
        .curve({0.225, 0.99}, {0.22, 1.005}, {0.205, 1})    // lip
        .curve({0.14, 0.975}, {0.1, 0.92}, {0.1, 0.84})     // inside
        .curve({0.1, 0.69}, {0.3, 0.68}, {0.32, 0.5})       //
        .curve({0.34, 0.3}, {0.2, 0.16}, {0.14, 0.06})      //
        .curve({0.12, 0.04}, {0.06, 0.04}, {0, 0.04})
        .done();
}

MeshData revolve(const std::vector<ProfilePoint>& profile, int slices) {
    const int rows = static_cast<int>(profile.size()) - 1;
    // On the axis a vertex belongs to one triangle: that of the slice after it if the curve leaves
    // the axis, of the slice before it if the curve returns to it. It takes s and the normal from
    // the middle of that slice.
    const auto slice = [&](int column, int row) {
        const bool on_axis = profile[std::size_t(row)].position.x == 0;
        return on_axis ? column + (row == rows ? -0.5 : 0.5) : column;
    };
    return make_grid(slices, rows, [&](int column, int row) {
        const ProfilePoint& point = profile[std::size_t(row)];
        const double middle = slice(column, row);
        const double degrees =
            360 * (middle == slices ? 0 : middle) / slices;  // the last column is the first
        const double x = sin_degrees(degrees), z = cos_degrees(degrees);
        const dvec2 p = point.position, n = point.normal;
        return GridVertex{
            {p.x * x, p.y, p.x * z}, {n.x * x, n.y, n.x * z}, {middle / slices, point.t}};
    });
}

}  // namespace gw::scene
