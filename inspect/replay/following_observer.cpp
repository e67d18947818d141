#include "inspect/replay/following_observer.h"

namespace gw::inspect {

FollowingObserver::FollowingObserver(const Recording& recording) : passes_(pass_ranges(recording)) {
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) commands_.push_back(&command);
}

void FollowingObserver::begin_command(std::size_t) {
    if (started_) ++command_;
    started_ = true;
    while (pass_ + 1 < passes_.size() && command_ >= passes_[pass_].end) {
        ++pass_;
        draws_ = 0;
    }
    if (std::holds_alternative<Draw>(command())) ++draws_;
}

std::optional<std::size_t> FollowingObserver::draw() const {
    if (!std::holds_alternative<Draw>(command())) return {};
    return draws_ - 1;
}

std::optional<std::uint32_t> FollowingObserver::place_in_mesh(const Fragment& fragment) const {
    const auto* drawn = std::get_if<Draw>(&command());
    if (!drawn) return {};
    const Mesh& mesh = *drawn->mesh;
    return mesh.kind() == MeshKind::Triangles ? mesh.triangles()[fragment.primitive].polygon
                                              : fragment.primitive;
}

std::optional<std::uint32_t> FollowingObserver::polygon(const Fragment& fragment) const {
    const auto place = place_in_mesh(fragment);
    if (!place) return {};
    return std::get<Draw>(command()).mesh->polygon_id(*place);
}

}  // namespace gw::inspect
