// A geometry set: one mesh under one transform, clipped, culled, snapped and binned once, for every
// draw that shares it (passes, lights, jittered samples). docs/manual.md, "Vertices" to "Window
// coordinates". Does not light, interpolate or make fragments.
#pragma once

#include "gw/counters.h"
#include "gw/mesh.h"
#include "gw/stages/resolve.h"
#include "gw/state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw {
struct Draw;
}

namespace gw::fast {

struct TileGrid;

/// A vertex in the window: sub-pixels and depth units, together in memory.
struct alignas(16) SnappedVertex {
    std::int32_t x = 0, y = 0;
    std::uint32_t z = 0;
};

/// What a geometry set depends on; jitter is not in it.
struct GeometryKey {
    MeshRef mesh;
    dmat4 eye_from_object{1}, projection{1};
    ViewportState viewport;
    DepthRangeState depth_range;
    std::array<ClipPlane, max_clip_planes> clip_planes{};
    CullState cull;
    PolygonMode polygon_mode = PolygonMode::Fill;
    int point_size = 1, line_width = 1;
    bool operator==(const GeometryKey&) const = default;
};
GeometryKey geometry_key(const State& state, const Draw& draw);

/// A primitive ready for tiles: its vertices in the set's arrays (triangles in canonical order),
/// and the primitive of the mesh that it came from.
struct SetupPrimitive {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t ordinal = 0;  ///< of the mesh's primitive
    std::uint32_t polygon = 0;  ///< ordinal of its polygon
    std::uint32_t provoking = 0;
    std::uint8_t front = 1;
    MeshKind kind = MeshKind::Triangles;
};

/// A primitive that clipping changed: its `count` new vertices are at the end of the arrays.
struct ClippedPrimitive {
    std::array<std::uint32_t, 3> vertex{};  ///< of the mesh
    std::uint32_t sides = 3;                ///< 3: triangle, 2: line
    std::uint32_t first = 0, count = 0;     ///< in the set's arrays
};

/// From the least to the largest of several jitters, and none.
struct JitterRange {
    JitterState low, high;
    void include(const JitterState& jitter);
    bool covers(const JitterRange& other) const;
};

struct GeometrySet {
    GeometryKey key;
    Resolved state;  ///< viewport transform
    std::vector<SnappedVertex> at;
    std::vector<double> w;
    std::vector<SetupPrimitive> primitives;
    std::uint32_t triangle_count = 0;  ///< how many of them are triangles: the first ones
    std::vector<ClippedPrimitive> clipped;
    /// Mesh vertices that any primitive uses, any front face, any back face; in order. Made only if
    /// a draw needs values at the vertices.
    bool lists_used = false;
    std::vector<std::uint32_t> used, used_front, used_back;
    Counters counters;  ///< of one draw: vertices to drawn

    JitterRange jitter;                    ///< what the list's draws use
    JitterRange binned;                    ///< what bins are made for
    std::vector<std::uint32_t> bin_start;  ///< per tile, and one past the last
    std::vector<std::uint32_t> bin;        ///< ordinals of `primitives`, in order
    bool made = false;                     ///< all but lists and bins

    std::size_t vertex_count() const { return at.size(); }
    /// Takes everything that was made for the same key.
    void take(GeometrySet& from);
    /// Takes the memory of a set that nobody needs any more.
    void take_memory(GeometrySet& from);
    std::span<const std::uint32_t> tile_bin(std::size_t tile) const {
        return std::span(bin).subspan(bin_start[tile], bin_start[tile + 1] - bin_start[tile]);
    }
};

/// Fills a set that has its key: transform, clipping, culling, snap. If the set is made already,
/// only makes the lists if they are missing.
void make_geometry(GeometrySet& set, const State& state, const Draw& draw, const Profile& profile,
                   int width, int height);

/// Sorts the primitives into tiles, in order, unless the bins cover this jitter. Call when the
/// range of the jitter is known.
void make_bins(GeometrySet& set, const Profile& profile, const TileGrid& grid);

}  // namespace gw::fast
