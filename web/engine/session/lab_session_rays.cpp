// The item buffer and rays [K4]: the pictures of eq. 5 and of the ordinary ray tracer, identifiers,
// traced pixels, reasons of differences, paths of rays, and the scene from outside.
#include "gw/error.h"
#include "image/plane_pictures.h"
#include "inspect/replay/forwarding_machine.h"
#include "itembuffer/differences.h"
#include "multipass/frame/driver.h"
#include "web/engine/json_point.h"
#include "web/engine/method.h"
#include "web/engine/outside.h"
#include "web/engine/rgba.h"

#include <algorithm>

namespace gw::lab {
namespace {

/// Draws no face that looks away: a room is open towards the eye outside.
class CullingMachine : public inspect::ForwardingMachine {
public:
    using ForwardingMachine::ForwardingMachine;

    void execute(const CommandList& list) override {
        CommandList culling = list;
        for (Command& command : culling.commands)
            if (auto* set = std::get_if<SetState>(&command)) set->state.edit().cull.enable = true;
        ForwardingMachine::execute(culling);
    }
};

/// By columns.
Json json_of(const dmat4& m) {
    Json values = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) values.push_back(m[column][row]);
    return values;
}

/// Rows from the top.
template <class Value>
std::vector<std::uint8_t> turned(const std::vector<Value>& values, int width) {
    std::vector<std::uint8_t> bytes;
    for (auto end = values.end(); end != values.begin(); end -= width)
        for (auto at = end - width; at != end; ++at) bytes.push_back(std::uint8_t(*at));
    return bytes;
}

}  // namespace

LabSession::Rays LabSession::rays_for(const Json& options) {
    Machine& machine = machine_for(options);
    const render::Drawing drawing = drawing_of(options);
    const scene::Scene scene = render::scene_with_maps(drawing, drawing.view(), machine);
    Json key = options;
    for (const char* other : {"eye", "at", "up", "fov", "from", "x", "y"}) key.erase(other);
    if (!rays_ || key.dump() != rays_key_ || render::has_scene_maps(drawing)) {
        rays_.reset();
        rays_ = std::make_unique<RayScene>(machine, itembuffer::compared_scene(scene),
                                           drawing.request.depth);
        rays_key_ = key.dump();
    }
    return {machine, *rays_, drawing.view()};
}

Json LabSession::rays(const Json& options) {
    const Rays rays = rays_for(options);
    Json answer = rays.scene.by_passes(rays.view);
    keep_picture(rays.machine);
    return answer;
}

Json LabSession::raytraced(const Json& options) {
    const Rays rays = rays_for(options);
    Json answer = rays.scene.by_rays(rays.view);
    keep_picture(rays.machine);
    return answer;
}

Json LabSession::identifiers(const Json& options) {
    const Rays rays = rays_for(options);
    const int width = rays.view.width, height = rays.view.height;
    picture_ = rgba_of(image::id_colors(rays.scene.identify(rays.view), width, height, 0));
    const std::vector<std::uint8_t> traced = rays.scene.traced();
    difference_ = turned(traced, width);
    return {{"traced", std::count(traced.begin(), traced.end(), 1)}};
}

Json LabSession::reasons(const Json& options) {
    const Rays rays = rays_for(options);
    const itembuffer::Differences d = itembuffer::differences(
        rays.machine, rays.scene.scene(), rays.view, {.depth = rays.scene.depth(), .threads = 1});
    difference_ = turned(d.reason, rays.view.width);
    Json rows = Json::array();
    for (const itembuffer::Reason reason : itembuffer::reasons) {
        const itembuffer::ReasonCount c = count_of(d, reason);
        rows.push_back({{"why", itembuffer::name_of(reason)},
                        {"pixels", c.pixels},
                        {"mean", c.mean},
                        {"largest", c.largest}});
    }
    return {{"reasons", rows}, {"passes", d.passes}};
}

Json LabSession::path(const Json& options) {
    if (!rays_) throw Error("no pixel has an identifier; expected identifiers() before");
    return rays_->path(options.at("x"), options.at("y"), options.value("ordinary", false));
}

Json LabSession::outside(const Json& options) {
    check_pictures();
    scene::Scene scene = scene_for(options);
    scene.camera = outside_camera(scene);
    scene.camera->fov *= 0.7;  // a box fills less than the sphere around it
    if (options.contains("from"))
        for (int i = 0; i < 3; ++i) scene.camera->eye[i] = options["from"].at(std::size_t(i));
    for (scene::Object& object : scene.objects) object.glare.reset();
    Machine& machine = machine_for(options);
    CullingMachine culling(machine);
    const scene::View view = view_of(scene, options);
    render::draw(
        {.request = {.renderer = "hardware"}, .profile = machine.profile(), .scene = scene}, view,
        culling);
    keep_picture(machine);
    return {{"eye", json_of(scene.camera->eye)},
            {"at", json_of(scene.camera->at)},
            {"up", json_of(scene.camera->up)},
            {"matrix", json_of(view.clip_from_eye * view.eye_from_world)}};
}

const Method rays_methods[] = {
    {"rays", &LabSession::rays, {{"picture", &LabSession::picture}}},
    {"raytraced", &LabSession::raytraced, {{"picture", &LabSession::picture}}},
    {"identifiers",
     &LabSession::identifiers,
     {{"ids", &LabSession::picture}, {"mask", &LabSession::difference}}},
    {"reasons", &LabSession::reasons, {{"reason", &LabSession::difference}}},
    {"path", &LabSession::path},
    {"outside", &LabSession::outside, {{"picture", &LabSession::picture}}},
};

}  // namespace gw::lab
