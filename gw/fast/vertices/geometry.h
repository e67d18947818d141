// A geometry set: meshes that are always drawn one after the other, each under its transform. They
// are clipped, culled, snapped and binned once for all draws that share them (passes, lights,
// jittered samples). docs/manual.md, "Vertices" to "Window coordinates". Does not light,
// interpolate or make fragments.
#pragma once

#include "gw/counters.h"
#include "gw/fast/vertices/unset_vector.h"
#include "gw/mesh.h"
#include "gw/stages/raster/lines.h"
#include "gw/stages/resolve.h"
#include "gw/state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace gw::fast {

struct GeometryScratch;
struct TileGrid;

/// A vertex in the window, in sub-pixels and depth units, adjacent in memory.
struct alignas(16) SnappedVertex {
    std::int32_t x = 0, y = 0;
    std::uint32_t z = 0;
};

/// The part of a state that geometry depends on; jitter is not in it.
struct GeometryState {
    dmat4 projection{1};
    ViewportState viewport;
    DepthRangeState depth_range;
    ClipControlState clip_control;
    std::array<ClipPlane, max_clip_planes> clip_planes{};
    CullState cull;
    PolygonMode polygon_mode = PolygonMode::Fill, back_polygon_mode = PolygonMode::Fill;
    /// outlines of back and front faces keep the slope of their polygon
    std::array<bool, 2> keeps_slopes{};
    int stipple_period = 0;  ///< lines keep the steps before them, modulo this; 0: no
    /// pixels that a primitive may reach beyond its vertices
    int point_margin = 1, line_margin = 1, fill_margin = 0;
    bool line_smooth = false;  ///< stipples advance by length
    LineRule line_rule;        ///< the steps of stippled lines; else not used
    bool operator==(const GeometryState&) const = default;
};
/// Of a resolved state.
GeometryState geometry_state(const State& state, int subpixel_bits);

/// Tiles [x0, x1) x [y0, y1).
struct TileRange {
    std::uint16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    std::size_t count() const { return std::size_t(x1 - x0) * std::size_t(y1 - y0); }
    void include(const TileRange& o) {
        if (o.count() == 0) return;
        if (count() == 0) {
            *this = o;
            return;
        }
        x0 = std::min(x0, o.x0);
        y0 = std::min(y0, o.y0);
        x1 = std::max(x1, o.x1);
        y1 = std::max(y1, o.y1);
    }
};

/// The counts of one draw of a part, as in Counters.
struct PartCounts {
    std::uint32_t vertices = 0, primitives = 0;
    std::uint32_t rejected = 0, clipped = 0, degenerate = 0, culled = 0, drawn = 0;
};

/// One mesh under one transform, and the first index of its results in the set's arrays. The next
/// part's first index ends them.
struct GeometryPart {
    const Mesh* mesh = nullptr;
    std::uint64_t mesh_number = 0;  ///< the machine may outlive `mesh`
    dmat4 eye_from_object{1};
    std::uint32_t vertex = 0, primitive = 0, clipped = 0;
    std::uint32_t used = 0, used_front = 0, used_back = 0;
    PartCounts counts;
    TileRange tiles;  ///< that its primitives touch
};

/// A primitive ready for tiles: its vertices in the set's arrays (triangles in canonical order),
/// its part and its polygon.
struct SetupPrimitive {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t part = 0;
    std::uint32_t polygon = 0;    ///< ordinal in the part's mesh
    std::uint32_t provoking = 0;  ///< in the set's arrays
    std::uint8_t front = 1;
    MeshKind kind = MeshKind::Triangles;
    std::uint16_t stippled = 0;  ///< GeometryState::stipple_period
};

/// A primitive that clipping changed: its `count` new vertices are at `first` in the set's arrays.
struct ClippedPrimitive {
    std::array<std::uint32_t, 3> vertex{};  ///< of the mesh
    std::uint32_t sides = 3;                ///< 3: triangle, 2: line
    std::uint32_t first = 0, count = 0;
};

/// The range of several jitters, zero included.
struct JitterRange {
    JitterState low, high;
    void include(const JitterState& jitter);
    bool covers(const JitterRange& other) const;
};

struct GeometrySet {
    GeometryState state;
    ViewportTransform viewport;
    std::vector<GeometryPart> parts;
    UnsetVector<SnappedVertex> at;
    UnsetVector<double> w;
    std::vector<SetupPrimitive> primitives;
    std::uint32_t triangle_count = 0;  ///< the first ones are triangles
    /// By primitive of an outline: its polygon's offset_slope(), if the state keeps it.
    std::unordered_map<std::uint32_t, double> outline_slope;
    std::vector<ClippedPrimitive> clipped;
    /// The mesh vertices that primitives use, that front faces use, that back faces use; in order,
    /// part by part. Made only if a draw needs values at the vertices.
    bool lists_used = false, lists_made = false;
    std::vector<std::uint32_t> used, used_front, used_back;
    Counters counters;  ///< of one draw of each part: vertices to drawn

    JitterRange jitter;                    ///< of the segment's draws
    JitterRange binned;                    ///< that the bins allow
    TileRange tiles;                       ///< that any primitive touches
    std::vector<std::uint32_t> bin_start;  ///< per tile of `tiles`, and one past the last
    std::vector<std::uint32_t> bin;        ///< ordinals of `primitives`, in order
    bool made = false;                     ///< all but lists and bins
    std::weak_ptr<const Mesh> first_mesh;  ///< of the first part
    std::uint64_t last_segment = 0;        ///< that used it
    std::size_t kept_bytes = 0;            ///< at the end of that segment

    std::size_t vertex_count() const { return at.size(); }
    /// Empties it, but keeps its memory.
    void clear();
    std::size_t bytes() const;
    /// A part's end in an array: the start of the next part.
    std::size_t end_of(std::size_t part, std::uint32_t GeometryPart::*first,
                       std::size_t size) const {
        return part + 1 < parts.size() ? parts[part + 1].*first : size;
    }
    /// Ordinals of the primitives that touch a tile.
    std::span<const std::uint32_t> tile_bin(int column, int row) const {
        if (column < tiles.x0 || column >= tiles.x1 || row < tiles.y0 || row >= tiles.y1) return {};
        const std::size_t i = std::size_t(row - tiles.y0) * std::size_t(tiles.x1 - tiles.x0) +
                              std::size_t(column - tiles.x0);
        return std::span(bin).subspan(bin_start[i], bin_start[i + 1] - bin_start[i]);
    }
};

inline std::size_t primitive_count(const Mesh& mesh) {
    return mesh.triangles().size() + mesh.lines().size() + mesh.points().size();
}

/// Neighbouring parts of a set that every pass draws together.
struct PartGroup {
    GeometrySet* set = nullptr;
    std::uint32_t set_number = 0;  ///< of the segment's sets
    std::uint32_t first_part = 0, parts = 0;
    std::uint32_t first_primitive = 0, end_primitive = 0;
    TileRange tiles;

    /// Finds the primitives and tiles of its parts. Call when the set is made.
    void finish();
    /// Ordinals of its primitives that touch a tile.
    std::span<const std::uint32_t> tile_bin(int column, int row) const;
    /// Counts one draw of each part, from vertices to drawn.
    Counters counters() const;
};

/// Fills a set that has its state and parts: transform, clipping, culling, snap. If the set is
/// already made, makes only its missing lists.
void make_geometry(GeometrySet& set, const Profile& profile, GeometryScratch& scratch);

/// Makes the lists of used vertices of a set that is made but for them. make_geometry() calls it.
void list_used_vertices(GeometrySet& set, GeometryScratch& scratch);

/// Sorts the primitives into tiles, in order, unless the bins cover this jitter. Call when the
/// range of the jitter is known.
void make_bins(GeometrySet& set, const Profile& profile, const TileGrid& grid,
               GeometryScratch& scratch);

}  // namespace gw::fast
