#include "gw/base/elementary.h"
#include "scene/shapes/grid.h"
#include "scene/shapes/shapes.h"

#include <glm/geometric.hpp>

namespace gw::scene {
namespace {

constexpr double thickness = 0.4;  // of the torus that the curve lies on, by its radius

// A point of the curve and two directions across it. The first is near the torus' normal, so that
// the frame closes.
struct Frame {
    dvec3 center, outward, sideways;
};

// At `turn` of the whole curve, an angle in degrees; c = ((1 + k cos v) sin u, k sin v, (1 + k cos
// v) cos u), u = p turn, v = q turn.
Frame frame(int p, int q, double radius, double turn) {
    const double su = sin_degrees(p * turn), cu = cos_degrees(p * turn);
    const double sv = sin_degrees(q * turn), cv = cos_degrees(q * turn);
    const double r = 1 + thickness * cv;
    const dvec3 torus_normal{cv * su, sv, cv * cu};
    const dvec3 along = p * r * dvec3(cu, 0, -su) + q * thickness * dvec3(-sv * su, cv, -sv * cu);
    const dvec3 sideways = glm::normalize(glm::cross(torus_normal, along));
    return {radius * dvec3(r * su, thickness * sv, r * cu),
            glm::normalize(glm::cross(along, sideways)), sideways};
}

}  // namespace

MeshData make_torus_knot(int p, int q, double radius, double tube, int segments, int sides) {
    return make_grid(segments, sides, [&](int column, int row) {
        const Frame f = frame(p, q, radius, 360.0 * (column % segments) / segments);
        const double degrees = 360.0 * (row % sides) / sides;
        const dvec3 normal = cos_degrees(degrees) * f.outward + sin_degrees(degrees) * f.sideways;
        return GridVertex{
            f.center + tube * normal,
            normal,
            {static_cast<double>(column) / segments, static_cast<double>(row) / sides}};
    });
}

}  // namespace gw::scene
