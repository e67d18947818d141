// Geometry sets that outlive their segment, because the same geometry is drawn again. The lists of
// a frame draw it (depth and winners, then the passes; an item buffer), and so do frames of one
// view. Does not keep meshes alive.
#pragma once

#include "gw/fast/vertices/geometry.h"

#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace gw::fast {

/// A part that a segment needs.
struct PartKey {
    const MeshRef* mesh = nullptr;
    const dmat4* eye_from_object = nullptr;
};

/// A set is dropped with its first mesh, and after four segments that did not use it. It is also
/// dropped if the sets that the current segment does not use take more than 64 MB.
class KeptGeometry {
public:
    static constexpr std::uint64_t kept_segments = 4;
    static constexpr std::size_t idle_bytes = std::size_t{64} << 20;

    void begin_segment();
    /// The set made for this state and these parts, in order; null: none. `hash` is their hash.
    GeometrySet* find(std::uint64_t hash, const GeometryState& state,
                      std::span<const PartKey> parts);
    /// A new set. Call it after all find() calls of the segment: it may take the memory of a set
    /// that the segment does not use.
    GeometrySet& make(std::uint64_t hash, const GeometryState& state,
                      std::span<const PartKey> parts);
    void end_segment();

    std::size_t size() const { return sets_.size(); }

private:
    using SetRef = std::unique_ptr<GeometrySet>;

    bool is_idle(const GeometrySet& set) const { return set.last_segment != segment_; }
    bool is_stale(const GeometrySet& set) const;
    SetRef take_spare();
    void retire(SetRef set);
    void retire_if_many_idle();
    void sweep(std::size_t buckets);

    std::unordered_map<std::uint64_t, SetRef> sets_;  ///< by hash
    std::vector<SetRef> unlisted_;                  ///< of this segment; another set has their hash
    std::vector<GeometrySet*> used_;                ///< by this segment, of those in sets_
    std::vector<SetRef> spare_;                     ///< empty, with their memory
    std::size_t kept_bytes_ = 0, spare_bytes_ = 0;  ///< of sets_, as of the last segment; of spare_
    bool has_made_ = false;                         ///< in this segment
    std::size_t next_bucket_ = 0;
    std::uint64_t segment_ = 0;
};

}  // namespace gw::fast
