// [camera] and [fog].
#include "scene/toml/toml_sections.h"

namespace gw::scene {

namespace {

Key place_key(std::string name, dvec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_placeable(value); }};
}

}  // namespace

Camera to_camera(const TomlValue& table) {
    Camera camera;
    read_table(table, {
                          place_key("eye", camera.eye),
                          place_key("at", camera.at),
                          place_key("up", camera.up),
                          key("fov", camera.fov, {0.1, 179}),
                          key("near", camera.near_plane, not_negative),
                          key("far", camera.far_plane, not_negative),
                          key("ortho", camera.ortho_height, not_negative),
                          key("aperture", camera.aperture, not_negative),
                          key("focus", camera.focus, not_negative),
                      });
    const dvec3 view = camera.at - camera.eye, side = glm::cross(view, camera.up);
    if (view == dvec3(0)) table.fail("camera.at is camera.eye; expected another point");
    if (side == dvec3(0)) table.fail("camera.up is along the view; expected another direction");
    if (camera.aperture > 0 && camera.ortho_height > 0)
        table.fail("camera.aperture beside ortho; expected a perspective camera");
    if (camera.far_plane > 0 && camera.far_plane <= camera.near_plane)
        table.fail("camera.far is not beyond camera.near; expected near < far");
    return camera;
}

Fog to_fog(const TomlValue& table) {
    Fog fog;
    read_table(
        table,
        {
            key("mode", fog.mode,
                {{"linear", FogMode::Linear}, {"exp", FogMode::Exp}, {"exp2", FogMode::Exp2}}),
            color_key("color", fog.color),
            key("density", fog.density, not_negative),
            key("start", fog.start, not_negative),
            key("end", fog.end, not_negative),
        });
    if (fog.mode == FogMode::Linear && fog.start >= fog.end)
        table.fail("fog.end is not beyond fog.start; expected start < end");
    return fog;
}

}  // namespace gw::scene
