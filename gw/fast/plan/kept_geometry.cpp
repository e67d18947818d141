#include "gw/fast/plan/kept_geometry.h"

#include <utility>

namespace gw::fast {

KeptGeometry::Kept* KeptGeometry::find(const GeometrySet& wanted) {
    GeometryKey key = wanted.key;
    key.mesh.reset();
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        const std::size_t at = (next_ + i) % kept_.size();
        Kept& kept = kept_[at];
        if (kept.address != wanted.key.mesh.get() || kept.mesh.expired()) continue;
        if (!(kept.set.key == key)) continue;
        next_ = at + 1;
        return &kept;
    }
    return nullptr;
}

void KeptGeometry::give(std::deque<GeometrySet>& sets) {
    std::vector<GeometrySet*> rest;
    for (GeometrySet& set : sets) {
        Kept* kept = find(set);
        if (!kept) {
            rest.push_back(&set);
            continue;
        }
        set.take(kept->set);
        *kept = {};
    }
    for (Kept& kept : kept_) {
        if (rest.empty()) break;
        if (!kept.address) continue;
        rest.back()->take_memory(kept.set);
        rest.pop_back();
        kept = {};
    }
}

void KeptGeometry::keep(std::deque<GeometrySet> sets) {
    if (sets.empty()) return;
    kept_.clear();
    kept_.reserve(sets.size());
    next_ = 0;
    for (GeometrySet& set : sets) {
        const MeshRef mesh = std::move(set.key.mesh);
        kept_.push_back({std::move(set), mesh.get(), mesh});
    }
}

}  // namespace gw::fast
