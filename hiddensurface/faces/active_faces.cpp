#include "hiddensurface/faces/active_faces.h"

#include <algorithm>

namespace gw::hiddensurface {

ActiveFaces::ActiveFaces(const std::vector<Face>& faces, const Input& input)
    : width_(input.view.width), y_(input.view.height), waiting_(std::size_t(input.view.height)) {
    for (const Face& face : faces) {
        auto active = std::make_unique<ActiveFace>(ActiveFace{.face = &face});
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const GridPoint &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
            if (a.y == b.y) continue;
            const EdgeWalk edge(a, b, input.subpixel_bits(), input.view.height - 1);
            if (!edge.done()) (b.y < a.y ? active->left : active->right).push_back(edge);
        }
        const auto lower = [](const EdgeWalk& a, const EdgeWalk& b) { return a.row() < b.row(); };
        std::stable_sort(active->left.begin(), active->left.end(), lower);
        std::stable_sort(active->right.begin(), active->right.end(), lower);
        if (active->left.empty() || active->left.back().row() < 0) continue;
        waiting_[std::size_t(active->left.back().row())].push_back(std::move(active));
    }
}

void ActiveFaces::next_line() {
    std::erase_if(active_, [](const auto& active) { return active->done; });
    y_ -= 1;
    begun_.clear();
    for (auto& active : waiting_[std::size_t(y_)]) {
        begun_.push_back(active.get());
        active_.push_back(std::move(active));
    }
    waiting_[std::size_t(y_)].clear();
    for (auto& active : active_) step(*active);
}

void ActiveFaces::step(ActiveFace& active) const {
    const auto end = [](std::vector<EdgeWalk>& edges) {
        const int x = edges.back().x();
        edges.back().down();
        return x;
    };
    for (auto* edges : {&active.left, &active.right})
        while (!edges->empty() && edges->back().done()) edges->pop_back();
    active.done = active.left.empty() || active.right.empty();
    if (active.done) return;
    active.x0 = std::clamp(end(active.left), 0, width_);
    active.x1 = std::clamp(end(active.right), 0, width_);
}

std::uint64_t ActiveFaces::bytes() const {
    std::uint64_t edges = 0;
    for (const auto& active : active_) edges += active->left.size() + active->right.size();
    return active_.size() * sizeof(ActiveFace) + edges * sizeof(EdgeWalk);
}

}  // namespace gw::hiddensurface
