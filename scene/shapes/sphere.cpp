#include "scene/shapes/sphere.h"

#include "gw/base/elementary.h"
#include "scene/shapes/revolve.h"

namespace gw::scene {

MeshData make_sphere(double radius, int slices, int stacks) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= stacks; ++i) {
        const double degrees = 180.0 * i / stacks - 90;
        const dvec2 normal{cos_degrees(degrees), sin_degrees(degrees)};
        profile.push_back({radius * normal, normal, static_cast<double>(i) / stacks});
    }
    return revolve(profile, slices);
}

}  // namespace gw::scene
