#include "apps/manifest.h"

#include "apps/counters_table.h"
#include "apps/profile_json.h"
#include "apps/versions.h"

namespace gw::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<Plane, const char*> plane_names[] = {
    {Plane::Color, "color"}, {Plane::Depth, "depth"}, {Plane::Stencil, "stencil"}, {Plane::Accum, "accum"}};

Json point(const dvec3& v) { return {v.x, v.y, v.z}; }

Json pass_json(const PassReport& pass) {
    Json json{{"name", pass.name}, {"counters", json_of(pass.counters)}};
    for (const auto& [plane, name] : plane_names) {
        if (pass.digested & mask_of(plane)) {
            json["digests"][name] = to_string(pass.digests[static_cast<std::size_t>(plane)]);
        }
    }
    return json;
}

Json camera_json(const scene::Camera& camera) {
    return {
        {"eye", point(camera.eye)}, {"at", point(camera.at)}, {"up", point(camera.up)}, {"fov", camera.fov}};
}

}  // namespace

std::string manifest(const Drawing& drawing, const scene::View& view, Machine& machine) {
    Json json{
        {"gw", version()},
        {"scene", drawing.options.scene.string()},
        {"renderer", drawing.renderer.name},
        {"profile", json_of(drawing.profile)},
        {"width", view.width},
        {"height", view.height},
        {"camera", camera_json(view.camera)},
        {"passes", Json::array()},
    };
    for (const PassReport& pass : machine.passes()) json["passes"].push_back(pass_json(pass));
    for (const auto& [plane, name] : plane_names)
        json["planes"][name] = to_string(digest(machine.planes(), plane));
    return json.dump(2) + "\n";
}

}  // namespace gw::apps
