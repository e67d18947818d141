#include "inspect/report/pass_observer.h"

#include "scene/draw/draw_commands.h"

#include <algorithm>

namespace gw::report {
namespace {

/// One more than the largest identifier.
std::uint32_t id_count(const Mesh& mesh) {
    const auto& ids = mesh.data().polygon_ids;
    if (!ids.empty()) return *std::ranges::max_element(ids) + 1;
    return mesh.polygon_count() +
           static_cast<std::uint32_t>(mesh.lines().size() + mesh.points().size());
}

bool writes_color_or_depth(const State& s) {
    const bool color = s.color_mask.r || s.color_mask.g || s.color_mask.b || s.color_mask.a;
    return color || (s.depth.test && s.depth.mask);
}

}  // namespace

PolygonPlane::PolygonPlane(const inspect::Recording& recording)
    : width_(recording.width), ids_(std::size_t(recording.width) * std::size_t(recording.height)) {
    std::uint32_t next = 1;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands)
            if (const auto* draw = std::get_if<Draw>(&command))
                if (first_.emplace(object_of(*draw), next).second) next += id_count(*draw->mesh);
}

PolygonPlane::Object PolygonPlane::object_of(const Draw& draw) {
    Object object{draw.mesh.get(), {}};
    for (int i = 0; i < 16; ++i) object.second[std::size_t(i)] = draw.eye_from_object[i / 4][i % 4];
    return object;
}

void PolygonPlane::written(const Fragment& fragment, std::uint32_t polygon, const State& state) {
    if (writes_color_or_depth(state)) id_at(fragment.x, fragment.y) = drawn_ + polygon;
}

void PassObserver::begin_command(std::size_t place) {
    FollowingObserver::begin_command(place);
    if (const auto* set = std::get_if<SetState>(&command())) state_ = set->state;
    if (const auto* draw = std::get_if<Draw>(&command())) polygons_.begin(*draw);
}

void PassObserver::fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                            const PixelValues& after) {
    if (draw() && fate == Fate::Written) polygons_.written(fragment, *polygon(fragment), state_);
    if (history_)
        history_->add({fragment.x, fragment.y, command_index(), before, after, &fragment, fate,
                       draw(), named(fragment)});
}

std::optional<std::uint32_t> PassObserver::named(const Fragment& fragment) const {
    return identifiers_ ? scene::id_of(fragment.color) : polygon(fragment);
}

void PassObserver::pixel(int x, int y, const PixelValues& before, const PixelValues& after) {
    const auto* clear = std::get_if<Clear>(&command());
    if (clear && clear->planes & (mask_of(Plane::Color) | mask_of(Plane::Depth)))
        polygons_.cleared(x, y);
    if (history_) history_->add({x, y, command_index(), before, after});
}

}  // namespace gw::report
