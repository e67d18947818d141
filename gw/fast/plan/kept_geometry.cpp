#include "gw/fast/plan/kept_geometry.h"

#include "gw/base/prefetch.h"

#include <algorithm>
#include <utility>

namespace gw::fast {
namespace {

bool matches(const GeometrySet& set, const GeometryState& state, std::span<const PartKey> parts) {
    if (set.parts.size() != parts.size() || !(set.state == state)) return false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const GeometryPart& part = set.parts[i];
        const Mesh& mesh = **parts[i].mesh;
        if (part.mesh != &mesh || part.mesh_number != mesh.number() ||
            part.eye_from_object != *parts[i].eye_from_object)
            return false;
    }
    return true;
}

}  // namespace

void KeptGeometry::begin_segment() {
    segment_ += 1;
    has_made_ = false;
}

GeometrySet* KeptGeometry::find(std::uint64_t hash, const GeometryState& state,
                                std::span<const PartKey> parts) {
    const auto found = sets_.find(hash);
    if (found == sets_.end()) return nullptr;
    GeometrySet& set = *found->second;
    if (!matches(set, state, parts)) return nullptr;
    if (is_idle(set)) {
        used_.push_back(&set);
        set.lists_used = false;
        set.jitter = {};
    }
    set.last_segment = segment_;
    return &set;
}

bool KeptGeometry::is_stale(const GeometrySet& set) const {
    return is_idle(set) &&
           (set.last_segment + kept_segments < segment_ || set.first_mesh.expired());
}

KeptGeometry::SetRef KeptGeometry::take_spare() {
    if (spare_.empty()) return std::make_unique<GeometrySet>();
    SetRef set = std::move(spare_.back());
    spare_.pop_back();
    spare_bytes_ -= set->bytes();
    return set;
}

void KeptGeometry::retire(SetRef set) {
    kept_bytes_ -= std::exchange(set->kept_bytes, 0);
    set->clear();
    spare_bytes_ += set->bytes();
    spare_.push_back(std::move(set));
}

void KeptGeometry::retire_if_many_idle() {
    std::size_t used_bytes = 0;
    for (const GeometrySet* set : used_) used_bytes += set->kept_bytes;
    if (kept_bytes_ <= used_bytes + idle_bytes) return;
    for (auto i = sets_.begin(); i != sets_.end();) {
        if (!is_idle(*i->second)) {
            ++i;
            continue;
        }
        retire(std::move(i->second));
        i = sets_.erase(i);
    }
}

GeometrySet& KeptGeometry::make(std::uint64_t hash, const GeometryState& state,
                                std::span<const PartKey> parts) {
    if (!std::exchange(has_made_, true)) retire_if_many_idle();
    SetRef& listed = sets_[hash];
    const bool taken = listed && !is_idle(*listed);
    if (listed && !taken) retire(std::move(listed));
    SetRef& place = taken ? unlisted_.emplace_back() : listed;
    place = take_spare();
    GeometrySet& set = *place;
    if (!taken) used_.push_back(&set);
    set.state = state;
    set.last_segment = segment_;
    set.first_mesh = *parts[0].mesh;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PartKey& part = parts[i];
        if (i + 4 < parts.size()) prefetch(parts[i + 4].eye_from_object, sizeof(dmat4));
        set.parts.push_back({part.mesh->get(), (*part.mesh)->number(), *part.eye_from_object});
    }
    return set;
}

void KeptGeometry::sweep(std::size_t buckets) {
    const std::size_t count = sets_.bucket_count();
    for (std::size_t i = 0; i < std::min(buckets, count); ++i) {
        next_bucket_ = (next_bucket_ + 1) % count;
        for (auto at = sets_.begin(next_bucket_); at != sets_.end(next_bucket_);) {
            if (!is_stale(*at->second)) {
                ++at;
                continue;
            }
            const std::uint64_t hash = at->first;
            retire(std::move(at->second));
            sets_.erase(hash);
            at = sets_.begin(next_bucket_);
        }
    }
}

void KeptGeometry::end_segment() {
    unlisted_.clear();
    std::size_t used_bytes = 0;
    for (GeometrySet* set : used_) {
        kept_bytes_ -= set->kept_bytes;
        set->kept_bytes = set->bytes();
        kept_bytes_ += set->kept_bytes;
        used_bytes += set->kept_bytes;
    }
    sweep(2 * used_.size() + 8);
    used_.clear();
    while (!spare_.empty() && spare_bytes_ > used_bytes + idle_bytes / 4) take_spare();
}

}  // namespace gw::fast
