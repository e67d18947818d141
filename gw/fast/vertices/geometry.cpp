#include "gw/fast/vertices/geometry.h"

#include "gw/fast/vertices/project_parts.h"
#include "gw/stages/area.h"
#include "gw/stages/polygon_offset.h"
#include "gw/stages/raster/lines.h"
#include "gw/stages/stipple.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

namespace gw::fast {
namespace {

std::uint32_t planes_on(const std::array<ClipPlane, max_clip_planes>& user) {
    std::uint32_t planes = all_clip_planes;
    for (std::size_t k = 0; k < user.size(); ++k)
        if (!user[k].enable) planes &= ~(4u << k);
    return planes;
}

struct Builder {
    GeometrySet& set;
    PartProjector projector;
    const Projection& projection = projector.projection;
    const Mesh* mesh = nullptr;
    std::uint32_t part = 0, base = 0;  ///< the part in progress and its first vertex
    GeometryScratch& scratch;
    const GeometryState& state = set.state;
    const Outcode* outcode = nullptr;                     ///< of the part's vertices
    std::uint32_t planes = planes_on(state.clip_planes);  ///< those that can cut
    /// of back, front
    std::array<PolygonMode, 2> mode{state.back_polygon_mode, state.polygon_mode};
    bool filled = mode[0] == PolygonMode::Fill && mode[1] == PolygonMode::Fill;
    std::uint64_t stippled = 0;  ///< steps of the strip or outline in progress
    /// back, front
    std::array<bool, 2> culled{is_culled(state.cull, false), is_culled(state.cull, true)};

    static bool is_culled(const CullState& cull, bool front) {
        return cull.enable &&
               (cull.face == Face::FrontAndBack || (cull.face == Face::Front) == front);
    }

    /// Begins the next part.
    void begin(std::uint32_t ordinal) {
        GeometryPart& p = set.parts[ordinal];
        part = ordinal;
        mesh = p.mesh;
        base = std::uint32_t(set.at.size());
        p.vertex = base;
        p.primitive = std::uint32_t(set.primitives.size());
        p.clipped = std::uint32_t(set.clipped.size());
        projector.add();
        outcode = projector.outcode;
    }

    SnappedPoint point(std::uint32_t v) const { return {set.at[v].x, set.at[v].y}; }
    /// A mesh triangle's vertices in the set's arrays.
    std::array<std::uint32_t, 3> in_set(const std::array<std::uint32_t, 3>& v) const {
        return {base + v[0], base + v[1], base + v[2]};
    }
    std::int64_t area_of(const std::array<std::uint32_t, 3>& v) const {
        return area2(point(v[0]), point(v[1]), point(v[2]));
    }

    /// Whether all corners lie outside the first plane that any corner is outside of. Clipping
    /// would leave nothing.
    static bool all_outside(Outcode all, Outcode any) {
        const Outcode planes = any & all_clip_planes;
        return planes != 0 && (all >> std::countr_zero(planes) & 1) != 0;
    }

    /// Clips and appends the new vertices to the set's arrays. Returns false if nothing is left.
    bool clip(std::array<std::uint32_t, 3> corners, std::uint32_t sides, ClippedPrimitive& out) {
        std::vector<ClipPosition>& vertices = scratch.clipper.vertices;
        vertices.clear();
        Outcode any = 0;
        for (std::uint32_t k = 0; k < sides; ++k) {
            place_position(projection, object_position(mesh->data(), corners[k]),
                           vertices.emplace_back());
            any |= outcode[corners[k]];
        }
        // Planes before the first one that cuts change nothing, nor do disabled planes.
        const bool changed =
            scratch.clipper.clip(projection.viewport, planes & ~((any & (0u - any)) - 1));
        if (vertices.empty()) return false;
        out.first = std::uint32_t(set.at.size());
        out.count = std::uint32_t(vertices.size());
        set.at.resize(out.first + out.count);
        to_window(projection, vertices, &set.at[out.first]);
        for (const ClipPosition& v : vertices) set.w.push_back(v.clip.w);
        set.counters.clipped += changed ? 1 : 0;
        // Member by member: a copy of `out` would wait for its parts to be stored.
        ClippedPrimitive& kept = set.clipped.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) kept.vertex[k] = corners[k];
        kept.sides = sides;
        kept.first = out.first;
        kept.count = out.count;
        return true;
    }

    /// Removes a clipped primitive that is not drawn.
    void drop(const ClippedPrimitive& c) {
        set.clipped.pop_back();
        set.at.resize(c.first);
        set.w.resize(c.first);
    }

    /// Counter-clockwise from the lowest vertex; of equally low ones, from the leftmost. Without
    /// branches, because they would be unpredictable. Precondition: the three points differ.
    [[gnu::always_inline]] std::array<std::uint32_t, 3> canonical(
        const std::array<std::uint32_t, 3>& v, bool clockwise) const {
        const std::array<std::uint32_t, 5> turned{v[0], v[clockwise ? 2 : 1], v[clockwise ? 1 : 2],
                                                  v[0], v[clockwise ? 2 : 1]};
        std::array<std::int64_t, 3> key;
        for (std::size_t k = 0; k < 3; ++k)
            key[k] =
                std::int64_t{set.at[turned[k]].y} * (std::int64_t{1} << 32) + set.at[turned[k]].x;
        const auto less = [&](std::size_t a, std::size_t b) {
            return std::size_t{key[a] < key[b]};
        };
        const std::size_t first = (less(1, 0) & less(1, 2)) + 2 * (less(2, 0) & less(2, 1));
        return {turned[first], turned[first + 1], turned[first + 2]};
    }

    void push_piece(const std::array<std::uint32_t, 3>& v, SetupPrimitive p,
                    bool counter_clockwise) {
        const std::int64_t area = area_of(v);
        if (area == 0 || (area > 0) != counter_clockwise) return;
        p.vertex = canonical(v, area < 0);
        set.primitives.push_back(p);
    }

    /// The fan of a whole triangle, or of the polygon that clipping left.
    Fan fan(const Triangle& t, const ClippedPrimitive& piece) {
        if (piece.count == 0) return {area_of(in_set(t.vertex)), 0};
        scratch.fan_corners.clear();
        for (std::uint32_t k = 0; k < piece.count; ++k)
            scratch.fan_corners.push_back(point(piece.first + k));
        return fan_of(scratch.fan_corners);
    }

    void push_pieces(const Triangle& t, const ClippedPrimitive& piece, const Fan& pieces,
                     const SetupPrimitive& p) {
        if (piece.count == 0) return push_piece(in_set(t.vertex), p, pieces.area2 > 0);
        const auto at = [&](std::size_t k) {
            return piece.first + std::uint32_t((pieces.first + k) % piece.count);
        };
        for (std::uint32_t k = 1; k + 1 < piece.count; ++k)
            push_piece({at(0), at(k), at(k + 1)}, p, pieces.area2 > 0);
    }

    /// A triangle that no plane touches.
    void push_whole(const Triangle& t) {
        const std::array<std::uint32_t, 3> v = in_set(t.vertex);
        const std::int64_t area = area_of(v);
        const bool front = (area > 0) == (state.cull.front == Winding::CCW);
        if (area == 0 || culled[front]) {
            std::uint64_t& count = area == 0 ? set.counters.degenerate : set.counters.culled;
            count += 1;
            return;
        }
        set.counters.drawn += 1;
        set.primitives.push_back({canonical(v, area < 0), part, t.polygon, base + t.provoking,
                                  std::uint8_t(front), MeshKind::Triangles});
    }

    void push_triangle(const Triangle& t) {
        const Outcode a = outcode[t.vertex[0]], b = outcode[t.vertex[1]], c = outcode[t.vertex[2]];
        const Outcode any = a | b | c;
        if (any == 0 && filled) return push_whole(t);
        ClippedPrimitive piece{t.vertex, 3, 0, 0};
        if (any != 0 &&
            ((any & not_finite) != 0 || all_outside(a & b & c, any) || !clip(t.vertex, 3, piece))) {
            set.counters.rejected += 1;
            return;
        }
        const Fan pieces = fan(t, piece);
        const bool front = (pieces.area2 > 0) == (state.cull.front == Winding::CCW);
        const bool drawn = pieces.area2 != 0 && !culled[front];
        std::uint64_t& count = pieces.area2 == 0 ? set.counters.degenerate
                               : drawn           ? set.counters.drawn
                                                 : set.counters.culled;
        count += 1;
        const bool outlined = mode[front] != PolygonMode::Fill;
        const double slope =
            drawn && outlined && state.keeps_slopes[front] ? slope_of(t, piece, pieces) : 0;
        if (piece.count != 0 && (!drawn || outlined)) drop(piece);
        if (!drawn) return;
        const SetupPrimitive p{
            {}, part, t.polygon, base + t.provoking, std::uint8_t(front), MeshKind::Triangles};
        if (!outlined) return push_pieces(t, piece, pieces, p);
        const std::size_t first = set.primitives.size();
        push_outline(t, p, mode[front]);
        if (!state.keeps_slopes[front]) return;
        for (std::size_t i = first; i < set.primitives.size(); ++i)
            set.outline_slope.emplace(std::uint32_t(i), slope);
    }

    /// offset_slope() of the first piece that would make fragments.
    double slope_of(const Triangle& t, const ClippedPrimitive& piece, const Fan& pieces) const {
        const std::uint32_t n = piece.count == 0 ? 3 : piece.count;
        const auto at = [&](std::uint32_t k) -> const SnappedVertex& {
            if (piece.count == 0) return set.at[base + t.vertex[k]];
            return set.at[piece.first + (std::uint32_t(pieces.first) + k) % n];
        };
        for (std::uint32_t k = 1; k + 1 < n; ++k) {
            const SnappedVertex &a = at(0), &b = at(k), &c = at(k + 1);
            const std::int64_t area = area2({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
            if (area == 0 || (area > 0) != (pieces.area2 > 0)) continue;
            return offset_slope(gradient_of(b, c, a, area, &SnappedVertex::y),
                                gradient_of(c, b, a, area, &SnappedVertex::x));
        }
        return 0;
    }
    /// (db dc' - dc db') 2^(16 + s) / area, exactly rounded: a gradient of the depth, up to sign.
    int128 gradient_of(const SnappedVertex& b, const SnappedVertex& c, const SnappedVertex& a,
                       std::int64_t area, std::int32_t SnappedVertex::*axis) const {
        const auto z = [&](const SnappedVertex& v) { return int128{v.z} - a.z; };
        const auto d = [&](const SnappedVertex& v) { return int128{v.*axis} - a.*axis; };
        const int128 num =
            (z(b) * d(c) - z(c) * d(b)) * (int128{1} << (16 + projection.profile.subpixel_bits));
        return divide_round_even(area < 0 ? -num : num, area < 0 ? -area : area);
    }

    void push_outline(const Triangle& t, const SetupPrimitive& p, PolygonMode outline) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(t.edges >> k & 1)) continue;
            if (outline == PolygonMode::Line)
                push_line(t.vertex[k], t.vertex[(k + 1) % 3], p, false);
            else
                push_point(t.vertex[k], p, false);
        }
    }

    void push_line(std::uint32_t a, std::uint32_t b, SetupPrimitive p, bool counted) {
        const Counters before = set.counters;
        ClippedPrimitive piece{};
        p.kind = MeshKind::Lines;
        p.vertex = {base + a, base + b, base + b};
        const Outcode any = outcode[a] | outcode[b];
        bool left = (any & not_finite) == 0;
        if (left && any != 0) {
            left = clip({a, b, b}, 2, piece);
            if (left) p.vertex = {piece.first, piece.first + 1, piece.first + 1};
        }
        const bool degenerate = left && set.at[p.vertex[0]].x == set.at[p.vertex[1]].x &&
                                set.at[p.vertex[0]].y == set.at[p.vertex[1]].y;
        if (degenerate && piece.count != 0) drop(piece);
        if (left && !degenerate) push_stippled(p);
        if (!counted) {
            set.counters = before;
            return;
        }
        std::uint64_t& count = !left        ? set.counters.rejected
                               : degenerate ? set.counters.degenerate
                                            : set.counters.drawn;
        count += 1;
    }

    /// Adds a line and counts its steps.
    void push_stippled(SetupPrimitive p) {
        if (state.stipple_period != 0) {
            const auto period = std::uint64_t(state.stipple_period);
            const SnappedVertex &a = set.at[p.vertex[0]], &b = set.at[p.vertex[1]];
            const LineRule& rule = state.line_rule;
            p.stippled = std::uint16_t(stippled % period);
            const std::int64_t steps = state.line_smooth
                                           ? smooth_steps(b.x - a.x, b.y - a.y, rule.subpixel_bits)
                                           : line_steps({{a.x, b.x}, {a.y, b.y}}, rule).count;
            stippled += std::uint64_t(steps);
        }
        set.primitives.push_back(p);
    }

    void push_point(std::uint32_t v, SetupPrimitive p, bool counted) {
        const bool left = outcode[v] == 0;
        std::uint64_t& count = left ? set.counters.drawn : set.counters.rejected;
        if (counted) count += 1;
        p.kind = MeshKind::Points;
        p.vertex = {base + v, base + v, base + v};
        if (left) set.primitives.push_back(p);
    }
};

void push_primitives(Builder& b) {
    const Mesh& mesh = *b.mesh;
    std::uint32_t polygon = 0;
    b.stippled = 0;
    for (const Triangle& t : mesh.triangles()) {
        if (t.polygon != std::exchange(polygon, t.polygon)) b.stippled = 0;
        b.push_triangle(t);
    }
    std::uint32_t ordinal = 0;
    for (const auto& line : mesh.lines()) {
        if (mesh.data().primitive != Primitive::LineStrip) b.stippled = 0;
        b.push_line(line[0], line[1], {{}, b.part, ordinal++, b.base + line[1]}, true);
    }
    for (const std::uint32_t v : mesh.points())
        b.push_point(v, {{}, b.part, ordinal++, b.base + v}, true);
    Counters& c = b.set.counters;
    c.draws += 1;
    c.vertices += mesh.vertex_count();
    c.primitives += primitive_count(mesh);
}

PartCounts difference(const Counters& after, const Counters& before) {
    const auto of = [&](std::uint64_t Counters::*count) {
        return std::uint32_t(after.*count - before.*count);
    };
    return {of(&Counters::vertices), of(&Counters::primitives), of(&Counters::rejected),
            of(&Counters::clipped),  of(&Counters::degenerate), of(&Counters::culled),
            of(&Counters::drawn)};
}

void build(GeometrySet& set, const Profile& profile, GeometryScratch& scratch) {
    const Projection projection{
        dmat4(1), dmat4(1), set.viewport, set.state.depth_range, set.state.clip_planes, profile};
    Builder b{.set = set, .projector = {set, projection, scratch}, .scratch = scratch};
    std::size_t primitives = 0;
    for (const GeometryPart& part : set.parts) primitives += primitive_count(*part.mesh);
    set.primitives.reserve(primitives);
    for (std::uint32_t i = 0; i < set.parts.size(); ++i) {
        const Counters before = set.counters;
        b.begin(i);
        push_primitives(b);
        set.parts[i].counts = difference(set.counters, before);
    }
    const bool triangles =
        !set.primitives.empty() && b.filled && set.primitives.front().kind == MeshKind::Triangles;
    set.triangle_count = triangles ? std::uint32_t(set.primitives.size()) : 0;
}

}  // namespace

void make_geometry(GeometrySet& set, const Profile& profile, GeometryScratch& scratch) {
    if (!set.made) build(set, profile, scratch);
    set.made = true;
    if (!set.lists_used || set.lists_made) return;
    set.lists_made = true;
    list_used_vertices(set, scratch);
}

}  // namespace gw::fast
