// The mouse of gw view: left orbits, right or Shift pans, the wheel zooms; in radiosity Ctrl moves a
// figure over the floor.
#include "apps/view/orbit.h"
#include "apps/view/viewer.h"
#include "scene/geometry/transform.h"

#include <fmt/format.h>

#include <cmath>

namespace gw::apps {
namespace {

/// Degrees that a drag over the picture's height turns.
constexpr double degrees_per_height = 180;

scene::Bounds bounds_of(const radiosity::PixmapModel& model, const std::string& name) {
    scene::Scene part;
    part.materials = model.drawn.materials;
    for (std::size_t i = 0; i < model.sources.size(); ++i)
        for (const radiosity::Figure& figure : model.figures)
            if (figure.name == name && figure.object == model.sources[i].object) {
                part.objects.push_back(model.drawn.objects[i]);
                break;
            }
    return scene::bounds(part);
}

}  // namespace

bool Viewer::is_in_picture(int x, int y) const {
    return x >= 0 && y >= 0 && x < settings_.picture.size.width &&
           y < settings_.picture.size.height;
}

void Viewer::press(const Input& input) {
    history_.clear();
    if (!is_in_picture(input.x, input.y)) return;
    grasp_ = {.button = input.button,
              .x = input.x,
              .y = input.y,
              .first_x = input.x,
              .first_y = input.y,
              .pan = input.button != 1 || input.shift};
    if (show_ == Show::Light && input.ctrl) grasp_figure(input);
}

void Viewer::drag(const Input& input) {
    mouse_x_ = input.x;
    mouse_y_ = input.y;
    if (grasp_.button == 0) {
        is_screen_old_ = false;
        return;
    }
    const double height = settings_.picture.size.height;
    const double right = (input.x - grasp_.x) / height, down = (input.y - grasp_.y) / height;
    grasp_.x = input.x;
    grasp_.y = input.y;
    if (!grasp_.figure.empty()) {
        grasp_.by = grasped_by(input);
        return say(fmt::format("{} by {:.3f} {:.3f} {:.3f}", grasp_.figure, grasp_.by.x,
                               grasp_.by.y, grasp_.by.z));
    }
    settings_.camera = grasp_.pan ? panned(settings_.camera, right, -down)
                                  : orbited(settings_.camera, -right * degrees_per_height,
                                            down * degrees_per_height);
    moved();
}

void Viewer::release(const Input& input) {
    if (grasp_.button != input.button) return;
    if (!grasp_.figure.empty() && grasp_.by != dvec3(0)) {
        changes_.push_back({grasp_.figure, "move", grasp_.by});
        light_worker_->change(changes_.back());
    }
    grasp_ = {};
}

void Viewer::grasp_figure(const Input& input) {
    const std::optional<Light> now = light();
    if (!now || !now->model) return;
    const int row = settings_.picture.size.height - 1 - input.y;
    const auto figure = picker_.figure_at(*now, view(), input.x, row);
    if (!figure) return say("no figure here");
    grasp_.figure = now->model->figures[*figure].name;
    const scene::Bounds box = bounds_of(*now->model, grasp_.figure);
    grasp_.center = (box.low + box.high) / 2.0;
    grasp_.from = dvec3(0);
    grasp_.from = grasped_by(input);
}

// The horizontal plane through the figure's middle; if it is seen edge-on, the plane that faces the
// eye.
dvec3 Viewer::grasped_by(const Input& input) const {
    const scene::View seen = view();
    const scene::PixelRay ray = scene::PixelRays(seen).through(
        input.x + 0.5, settings_.picture.size.height - 1 - input.y + 0.5);
    const dvec3 sight = normalize(settings_.camera.at - settings_.camera.eye);
    const dvec3 normal = std::abs(sight.y) > 0.15 ? dvec3(0, 1, 0) : sight;
    const double along = dot(normal, ray.d);
    if (along == 0) return grasp_.by;
    const double t = dot(normal, grasp_.center - ray.o) / along;
    if (!(t > 0 && t < 1)) return grasp_.by;
    return ray.o + t * ray.d - grasp_.center - grasp_.from;
}

std::vector<std::array<int, 4>> Viewer::grasped_box() const {
    const std::optional<Light> now = light();
    if (grasp_.figure.empty() || !now || !now->model) return {};
    const scene::Bounds box = bounds_of(*now->model, grasp_.figure);
    if (box.empty) return {};
    const scene::View seen = view();
    std::array<std::array<int, 2>, 8> corners{};
    for (int i = 0; i < 8; ++i) {
        const dvec4 clip = seen.clip_from_eye *
                           (seen.eye_from_world * dvec4(scene::corner(box, i) + grasp_.by, 1));
        if (clip.w <= 0) return {};
        const auto at = [&](double v, int size) {
            return int(std::clamp((v / clip.w + 1) / 2 * size, -1e6, 1e6));
        };
        corners[std::size_t(i)] = {at(clip.x, seen.width), at(clip.y, seen.height)};
    }
    std::vector<std::array<int, 4>> strokes;
    for (std::size_t a = 0; a < 8; ++a)
        for (const std::size_t bit : {1u, 2u, 4u})
            if ((a & bit) == 0)
                strokes.push_back(
                    {corners[a][0], corners[a][1], corners[a | bit][0], corners[a | bit][1]});
    return strokes;
}

}  // namespace gw::apps
