#include "scene/validate/rules.h"

#include "scene/draw/view.h"

#include <glm/matrix.hpp>

namespace gw::scene {
namespace {

constexpr const char* any_direction = "a direction that is not 0";

}  // namespace

std::optional<Fault> fault_of(const Camera& camera) {
    const dvec3 view = camera.at - camera.eye;
    if (view == dvec3(0)) return Fault{"at", "the eye", "another point"};
    if (camera.up == dvec3(0)) return Fault{"up", "0", any_direction};
    if (is_along(view, camera.up)) return Fault{"up", "along the view", "another direction"};
    if (camera.aperture > 0 && camera.ortho_height > 0)
        return Fault{"aperture", "above 0 beside ortho", "a perspective camera"};
    if (camera.far_plane > 0 && camera.far_plane <= camera.near_plane)
        return Fault{{"far", "far_plane"}, "not beyond near", "near < far"};
    return {};
}

std::optional<Fault> fault_of(const Fog& fog) {
    if (fog.mode == FogMode::Linear && fog.start >= fog.end)
        return Fault{"end", "not beyond start", "start < end"};
    return {};
}

std::optional<Fault> fault_of(const AreaLight& area) {
    using Shape = AreaLight::Shape;
    constexpr const char* half_axis = "a half axis in world units";
    if (area.shape == Shape::None) return {};
    if (area.u == vec3(0)) return Fault{"u", "0", half_axis};
    if (area.shape != Shape::Line && area.v == vec3(0)) return Fault{"v", "0", half_axis};
    return {};
}

std::optional<Fault> fault_of(const Light& light) {
    if (light.kind != LightKind::Point && light.direction == vec3(0))
        return Fault{"direction", "0", any_direction};
    if (light.constant_attenuation + light.linear_attenuation + light.quadratic_attenuation == 0)
        return Fault{"attenuation", "0 everywhere", "a factor above 0"};
    return {};
}

std::optional<Fault> fault_of(const PixmapChoice& pixmap) {
    if ((pixmap.width == 0) != (pixmap.height == 0))
        return Fault{{"size", "height"}, "without a width, or the reverse", "both, or none"};
    if (!pixmap.name.empty() && !pixmap.given_st)
        return Fault{{"st", "given_st"}, "automatic beside a name", "texcoords"};
    if (pixmap.width == 0 && pixmap.given_st)
        return Fault{{"size", "width"}, "missing", "[width, height] beside ST that are texcoords"};
    if (pixmap.width != 0 && pixmap.texels_per_unit != 0)
        return Fault{{"texels", "texels_per_unit"}, "given beside a size", "one of them"};
    return {};
}

std::optional<Fault> fault_of(const dmat4& m) {
    const FieldName name{"matrix", "world_from_object"};
    if (dvec4(m[0][3], m[1][3], m[2][3], m[3][3]) != dvec4(0, 0, 0, 1))
        return Fault{name, "not affine", "0, 0, 0, 1 as its last row"};
    if (glm::determinant(dmat3(m)) == 0) return Fault{name, "singular", "one that can be inverted"};
    return {};
}

}  // namespace gw::scene
