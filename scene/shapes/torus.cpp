#include "scene/shapes/torus.h"

#include "gw/base/elementary.h"
#include "scene/shapes/revolve.h"

namespace gw::scene {

MeshData make_torus(double radius, double tube, int segments, int sides) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= sides; ++i) {
        const double degrees = 360.0 * (i % sides) / sides;  // the last point is the first
        const dvec2 normal{cos_degrees(degrees), sin_degrees(degrees)};
        profile.push_back(
            {dvec2(radius, 0) + tube * normal, normal, static_cast<double>(i) / sides});
    }
    return revolve(profile, segments);
}

}  // namespace gw::scene
