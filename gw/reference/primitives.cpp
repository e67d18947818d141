#include "gw/reference/primitives.h"

#include "gw/reference/shade.h"
#include "gw/reference/smooth.h"
#include "gw/stages/fan.h"
#include "gw/stages/polygon_offset.h"
#include "gw/stages/raster/lines.h"
#include "gw/stages/raster/points.h"
#include "gw/stages/stipple.h"
#include "gw/stages/texgen.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace gw::reference {
namespace {

/// A draw with its transformed vertices.
struct Drawing {
    const DrawContext& context;
    std::vector<Vertex> vertices;
    TextureUses texture_uses{};

    const State& state() const { return context.state.state; }
    Counters& counters() const { return *context.target.counters; }
    int subpixel_bits() const { return context.profile->subpixel_bits; }
    WindowVertex window(const Vertex& v) const {
        return to_window(v, context.state.viewport, state().depth_range, *context.profile);
    }
};

/// The origin of a primitive, which decides its colour and number.
struct Source {
    std::uint32_t primitive = 0;
    std::uint32_t polygon = 0;
    std::uint32_t provoking = 0;
    bool front = true;
    bool counter_clockwise = true;  ///< of the whole polygon after the snap
    std::int64_t depth_offset = 0;
};

/// What the triangles of one polygon share.
struct PolygonInProgress {
    std::uint64_t stippled = 0;       ///< steps of its outline, or of a strip of lines
    std::vector<SmoothPiece> pieces;  ///< under polygon_smooth: drawn at its end

    void finish() {
        draw_smooth_polygon(pieces);
        *this = {};
    }
};

std::array<std::int64_t, 4> integers(const std::array<double, 4>& c) {
    return {std::int64_t(c[0]), std::int64_t(c[1]), std::int64_t(c[2]), std::int64_t(c[3])};
}

/// R, G, B = the low three bytes of the identifier, whatever color_bits is.
std::array<std::int64_t, 4> id_color(const Drawing& d, std::uint32_t polygon) {
    const Draw& draw = *d.context.draw;
    const std::uint32_t id = (draw.id_base + draw.mesh->polygon_id(polygon)) >> draw.id_shift;
    return {id & 255, (id >> 8) & 255, (id >> 16) & 255,
            max_of_bits(d.context.profile->color_bits)};
}

Corner corner(const Drawing& d, const Vertex& v, const Source& s) {
    Corner out{d.window(v), v.texcoord, {}, {}, v.fog, v.more_texcoords};
    const Vertex& from = d.state().shade_model == ShadeModel::Flat ? d.vertices[s.provoking] : v;
    out.color = integers(s.front ? from.color : from.back_color);
    out.secondary = integers(s.front ? from.secondary : from.back_secondary);
    if (d.state().color_source == ColorSource::PolygonId) out.color = id_color(d, s.polygon);
    return out;
}

Shader shader(const Drawing& d, std::span<const Corner> corners, const PlaneMaker& plane,
              const Source& s) {
    const DrawContext& c = d.context;
    return {c, interpolants(corners, plane, c.state, *c.profile, d.texture_uses), s.primitive,
            s.front, s.depth_offset};
}

JitterState operator+(const JitterState& a, const JitterState& b) { return {a.x + b.x, a.y + b.y}; }

/// Makes the fragments of a primitive. `cover(jitter, sink)` calls the sink with each pixel whose
/// centre the primitive covers under a jitter: the state's own, or one that brings the place of a
/// sample to the centre.
void cover_pixels(const Drawing& d, const Shader& shade, const auto& cover) {
    const JitterState& jitter = d.state().jitter;
    if (!d.state().multisample.enable)
        return cover(jitter, [&](int x, int y) { shade.pixel(x, y); });
    using Place = std::pair<int, int>;  // row and column
    std::map<Place, SampleMask> masks;
    for (int k = 0; k < d.context.state.samples; ++k)
        cover(jitter + sample_shift(d.context.state.samples, k, d.subpixel_bits()),
              [&](int x, int y) {
                  masks[{y, x}] |= SampleMask(1u << k);
              });
    std::set<Place> centers;
    cover(jitter, [&](int x, int y) { centers.insert({y, x}); });
    for (const auto& [at, mask] : masks)
        shade.samples(at.second, at.first, mask, centers.contains(at));
}

std::int64_t offset_of(const Drawing& d, const PlaneEquation& depth) {
    return depth_offset(d.state().polygon_offset, offset_slope(depth.gx, depth.gy),
                        d.context.profile->depth_bits);
}

void fill_piece(const Drawing& d, const std::array<Corner, 3>& corners, const Source& s,
                PolygonInProgress& whole) {
    const std::array<WindowVertex, 3> window{corners[0].window, corners[1].window,
                                             corners[2].window};
    // A piece that the snap turned over lies inside its neighbours and makes no fragments.
    const std::int64_t area = area2(window[0], window[1], window[2]);
    if (area == 0 || (area > 0) != s.counter_clockwise) return;
    const SnappedTriangle t = snapped_triangle(window, d.state().jitter, d.subpixel_bits());
    const auto plane = [&](const std::array<std::int64_t, 3>& a) {
        return plane_through(t, {a[t.source[0]], a[t.source[1]], a[t.source[2]]});
    };
    Shader shade = shader(d, corners, plane, s);
    if (d.state().polygon_offset.enable) shade.depth_offset = offset_of(d, shade.values.depth);
    if (d.state().polygon_smooth) {
        whole.pieces.push_back({t, shade});
        return;
    }
    const auto& stipple = d.state().polygon_stipple.pattern;
    cover_pixels(d, shade, [&](const JitterState& jitter, const PixelSink& pixel) {
        cover_triangle(snapped_triangle(window, jitter, d.subpixel_bits()),
                       d.context.state.draw_box, [&](int x, int y) {
                           if (!stipple || stipple_bit(*stipple, x, y)) pixel(x, y);
                       });
    });
}

/// The steps of a line before the jitter, so that all samples of a strip count alike.
std::uint64_t unjittered_steps(const WindowVertex& a, const WindowVertex& b, const LineRule& rule,
                               bool smooth) {
    if (smooth) return std::uint64_t(smooth_steps(b.x - a.x, b.y - a.y, rule.subpixel_bits));
    return std::uint64_t(line_steps({{a.x, b.x}, {a.y, b.y}}, rule).count);
}

/// A line, clipped on its own, even if it is the edge of a polygon.
/// Its stipple goes on from step `stippled`, to which its own steps are added.
void draw_line(const Drawing& d, const Vertex& a, const Vertex& b, const Source& s, bool counted,
               std::uint64_t& stippled) {
    const Clipped clipped = clip({a, b}, d.context.state.viewport);
    const bool left = !clipped.vertices.empty();
    if (counted && !left) d.counters().rejected += 1;
    if (!left) return;
    if (counted && clipped.cut) d.counters().clipped += 1;
    const std::array<Corner, 2> corners{corner(d, clipped.vertices[0], s),
                                        corner(d, clipped.vertices[1], s)};
    const SnappedLine line =
        snapped_line(corners[0].window, corners[1].window, d.state().jitter, d.subpixel_bits());
    const bool degenerate = line.x[0] == line.x[1] && line.y[0] == line.y[1];
    if (counted) (degenerate ? d.counters().degenerate : d.counters().drawn) += 1;
    if (degenerate) return;
    const auto plane = [&](const std::array<std::int64_t, 3>& v) {
        return plane_along(line, v[0], v[1]);
    };
    Shader shade = shader(d, corners, plane, s);
    const bool smooth = d.state().line_smooth;
    const std::uint64_t before = stippled;
    const LineRule rule = line_rule(d.state(), d.subpixel_bits());
    stippled += unjittered_steps(corners[0].window, corners[1].window, rule, smooth);
    if (smooth) return draw_smooth_line(shade, line, before);
    const LineStippleState& stipple = d.state().line_stipple;
    cover_pixels(d, shade, [&](const JitterState& jitter, const PixelSink& pixel) {
        const SnappedLine l =
            snapped_line(corners[0].window, corners[1].window, jitter, d.subpixel_bits());
        const LineSteps steps = line_steps(l, rule);
        cover_line(l, rule, d.context.state.draw_box, [&](int x, int y) {
            const auto step = std::uint64_t(steps.step_of(l.x_major ? x : y));
            if (stipple.enable && !stipple_bit(stipple, before + step)) return;
            step == 0 && steps.outer_first ? shade.outside_pixel(x, y, 0) : pixel(x, y);
        });
    });
}

/// The texture coordinates of a sprite, in units that replace theirs.
void set_sprites(const Drawing& d, Shader& shade, int size) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (d.texture_uses[unit] != TextureUse::None && is_sprite(d.state(), unit))
            set_sprite(shade.values, unit, size, is_one_dimensional(*d.context.draw, unit));
}

void draw_point(const Drawing& d, std::uint32_t index, const Source& s, bool counted) {
    const Vertex& v = d.vertices[index];
    const bool left = !clip({v}, d.context.state.viewport).vertices.empty();
    if (counted) (left ? d.counters().drawn : d.counters().rejected) += 1;
    if (!left) return;
    const std::array<Corner, 1> corners{corner(d, v, s)};
    const JitterState& j = d.state().jitter;
    const std::int64_t x = corners[0].window.x + j.x, y = corners[0].window.y + j.y;
    const auto plane = [&](const std::array<std::int64_t, 3>& a) {
        PlaneEquation p = plane_constant(a[0], d.subpixel_bits());
        p.x0 = x;
        p.y0 = y;
        return p;
    };
    Shader shade = shader(d, corners, plane, s);
    const float size = point_size_of(d.state(), *d.context.draw, index);
    if (smooths_points(d.state())) return draw_smooth_point(shade, x, y, size);
    if (d.state().point_sprite) set_sprites(d, shade, whole_size(size));
    cover_pixels(d, shade, [&](const JitterState& jitter, const PixelSink& pixel) {
        cover_point(corners[0].window.x + jitter.x, corners[0].window.y + jitter.y,
                    whole_size(size), d.subpixel_bits(), d.context.state.draw_box, pixel);
    });
}

bool is_culled(const CullState& cull, bool front) {
    return cull.enable && (cull.face == Face::FrontAndBack || (cull.face == Face::Front) == front);
}

/// Draws the pieces of a clipped polygon.
void fill(const Drawing& d, const std::vector<Vertex>& polygon, const Fan& fan, const Source& s,
          PolygonInProgress& whole) {
    const auto at = [&](std::size_t k) {
        return corner(d, polygon[(fan.first + k) % polygon.size()], s);
    };
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        fill_piece(d, {at(0), at(k), at(k + 1)}, s, whole);
}

/// PolygonMode Line and Point: draws the sides that are edges of the mesh's polygon, not of the
/// clipped one.
void outline(const Drawing& d, const Triangle& t, const Source& s, PolygonMode mode,
             std::uint64_t& stippled) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(t.edges >> k & 1)) continue;
        const std::uint32_t a = t.vertex[k], b = t.vertex[(k + 1) % 3];
        if (mode == PolygonMode::Line)
            draw_line(d, d.vertices[a], d.vertices[b], s, false, stippled);
        else
            draw_point(d, a, s, false);
    }
}

/// The pieces of a clipped polygon after the snap. The sign of their area is the polygon's facing.
Fan fan(const Drawing& d, const std::vector<Vertex>& polygon) {
    std::vector<SnappedPoint> points;
    for (const Vertex& v : polygon) {
        const WindowVertex w = d.window(v);
        points.push_back({w.x, w.y});
    }
    return fan_of(points);
}

/// The depth plane of the first piece that makes fragments.
PlaneEquation first_depth_plane(const Drawing& d, const std::vector<Vertex>& polygon,
                                const Fan& fan) {
    const auto at = [&](std::size_t k) {
        return d.window(polygon[(fan.first + k) % polygon.size()]);
    };
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const std::array<WindowVertex, 3> v{at(0), at(k), at(k + 1)};
        const std::int64_t area = area2(v[0], v[1], v[2]);
        if (area == 0 || (area > 0) != (fan.area2 > 0)) continue;
        const SnappedTriangle t = snapped_triangle(v, d.state().jitter, d.subpixel_bits());
        return plane_through(t, {v[t.source[0]].z, v[t.source[1]].z, v[t.source[2]].z});
    }
    return {};
}

void draw_triangle(const Drawing& d, const Triangle& t, std::uint32_t ordinal,
                   PolygonInProgress& whole) {
    Counters& count = d.counters();
    const Clipped clipped =
        clip({d.vertices[t.vertex[0]], d.vertices[t.vertex[1]], d.vertices[t.vertex[2]]},
             d.context.state.viewport);
    if (clipped.vertices.empty()) {
        count.rejected += 1;
        return;
    }
    count.clipped += clipped.cut ? 1 : 0;
    const Fan pieces = fan(d, clipped.vertices);
    const bool front = (pieces.area2 > 0) == (d.state().cull.front == Winding::CCW);
    if (pieces.area2 == 0) {
        count.degenerate += 1;
        return;
    }
    if (is_culled(d.state().cull, front)) {
        count.culled += 1;
        return;
    }
    count.drawn += 1;
    Source source{ordinal, t.polygon, t.provoking, front, pieces.area2 > 0};
    const PolygonMode mode = mode_of(d.state(), front);
    if (mode == PolygonMode::Fill) return fill(d, clipped.vertices, pieces, source, whole);
    if (offsets_outline(d.state().polygon_offset, mode))
        source.depth_offset = offset_of(d, first_depth_plane(d, clipped.vertices, pieces));
    outline(d, t, source, mode, whole.stippled);
}

}  // namespace

void draw_mesh(const DrawContext& context) {
    const Mesh& mesh = *context.draw->mesh;
    Drawing d{context, {}};
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (context.texels[unit])
            d.texture_uses[unit] = divides_by_q(texture_of(d.state(), unit), *context.draw, unit)
                                       ? TextureUse::Projective
                                       : TextureUse::Plain;
    const VertexProgram program =
        vertex_program(context.state.state, *context.draw, *context.profile);
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
        d.vertices.push_back(run_vertex(program, i));

    Counters& count = d.counters();
    count.draws += 1;
    count.vertices += mesh.vertex_count();
    count.primitives += mesh.triangles().size() + mesh.lines().size() + mesh.points().size();
    std::uint32_t ordinal = 0;
    PolygonInProgress whole;
    std::uint32_t polygon = 0;
    for (const Triangle& t : mesh.triangles()) {
        if (t.polygon != std::exchange(polygon, t.polygon)) whole.finish();
        draw_triangle(d, t, ordinal++, whole);
    }
    whole.finish();
    std::uint64_t stippled = 0;
    for (const auto& line : mesh.lines()) {
        if (mesh.data().primitive != Primitive::LineStrip) stippled = 0;
        const Source s{ordinal, ordinal, line[1]};
        draw_line(d, d.vertices[line[0]], d.vertices[line[1]], s, true, stippled);
        ++ordinal;
    }
    for (const std::uint32_t v : mesh.points()) {
        draw_point(d, v, {ordinal, ordinal, v}, true);
        ++ordinal;
    }
}

}  // namespace gw::reference
