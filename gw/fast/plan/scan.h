// Reads a segment's commands once. Resolves every state once, finds every mesh under one transform
// once, forms groups of the parts that are always drawn one after the other, and geometry sets of
// neighbouring groups. Does not make operations.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "gw/fast/plan/kept_geometry.h"
#include "gw/fast/plan/pointer_table.h"
#include "gw/stages/resolve.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace gw::fast {

/// A state of the segment.
struct ScannedState {
    const State* state;
    Resolved resolved;
    FragmentBytes bytes;
    const GeometryState* geometry;  ///< one for all states that have an equal one
    std::uint64_t geometry_hash = 0;
    /// made by the first draw that needs it
    const std::vector<std::uint32_t>* fog_table = nullptr;
};

/// One mesh under one transform and one geometry state.
struct ScannedPart {
    const Draw* draw;           ///< its first draw
    const ScannedState* state;  ///< of that draw
    std::uint64_t hash;
    std::uint32_t index;
    std::uint32_t vertices;  ///< of its mesh
    bool is_small;           ///< it may share a set
    /// first part of a group; last part of one
    bool begins_group = false, ends_group = false;
    const PartGroup* group = nullptr;
};

/// A command that touches planes.
struct Step {
    const Command* command;
    ScannedState* state;
    std::size_t pass;             ///< in the machine's passes
    ScannedPart* part = nullptr;  ///< of a draw
};

class Scan {
public:
    /// Reads commands up to the next barrier, which is not included, or until the segment is full.
    /// Returns their number. `state` and `passes` follow the commands.
    std::size_t run(std::span<const Command> commands, State& state,
                    std::vector<PassReport>& passes, const Profile& profile,
                    const Surface& surface);
    /// Gives each part its group, and each group its set.
    void form_sets(KeptGeometry& kept);
    /// Call when the sets are made.
    void finish_groups();

    std::span<const Step> steps() const { return steps_; }
    std::span<GeometrySet* const> sets() const { return sets_; }
    /// The colour plane that the steps read and write; none if they need none, or both.
    std::optional<Plane> color_plane() const { return color_plane_; }

private:
    void clear();
    void use_state(const State& state);
    std::uint64_t hash_of_transform(const dmat4& transform);
    void look_ahead(std::span<const Command> commands, std::size_t i);
    ScannedPart& part_of(const Draw& draw, std::uint64_t draw_hash);
    void add_draw(const Command& command, const Draw& draw, std::uint64_t draw_hash);
    void add_step(const Command& command, ScannedPart* part);
    void end_run();
    const GeometryState* share(const GeometryState& geometry, std::uint64_t hash);
    bool begins_set(const ScannedPart& part, std::size_t parts, std::size_t vertices) const;
    bool is_full() const;
    bool fits_color_plane(const Command& command, const State& state);

    static constexpr std::size_t steps_ahead = 4;

    const Profile* profile_ = nullptr;
    Surface surface_;  ///< that is drawn to
    std::vector<PassReport>* passes_ = nullptr;
    State initial_;
    const State* given_ = nullptr;  ///< of the commands: `state_` is this
    ScannedState *state_ = nullptr, *state_before_ = nullptr;
    std::array<std::uint64_t, steps_ahead> hashes_{};  ///< of the next commands, if they are draws
    const dmat4* hashed_ = nullptr;  ///< the last transform; most draws have that of the last draw
    std::uint64_t transform_hash_ = 0;
    std::deque<GeometryState> geometries_;
    PointerTable<const GeometryState> geometry_table_;
    std::deque<ScannedState> states_;
    PointerTable<ScannedState> state_table_;
    std::deque<ScannedPart> parts_;
    PointerTable<ScannedPart> part_table_;
    std::size_t vertices_ = 0;  ///< of the parts' meshes
    std::vector<Step> steps_;
    std::vector<GeometrySet*> sets_;
    std::vector<PartGroup> groups_;
    std::unordered_set<std::uint32_t> read_keys_;
    std::optional<Plane> color_plane_;
};

/// Whether a command reads pixels across tiles, or takes digests: it runs between segments.
bool is_barrier(const Command& command, const std::vector<PassReport>& passes);

}  // namespace gw::fast
