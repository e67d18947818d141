#include "gl/draw/report.h"

#include "gl/context/context.h"
#include "gl/draw/machine_state.h"
#include "gl/draw/submit.h"

#include "gw/stages/clip.h"
#include "gw/stages/resolve.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <utility>

namespace gw::gl {

namespace {

/// A primitive as it was given: indices of its vertices, and the one that gives a flat colour.
struct Given {
    std::vector<std::uint32_t> vertices;
    std::size_t provoking = 0;
    bool begins_stipple = true;  ///< of a line
    std::vector<bool> edges;     ///< of a polygon: whether the side from each vertex is an edge
};

std::uint32_t vertex_index(const MeshData& data, std::size_t i) {
    return data.indices.empty() ? std::uint32_t(i) : data.indices[i];
}

std::size_t index_count(const MeshData& data) {
    return data.indices.empty() ? data.positions.size() : data.indices.size();
}

/// Calls `take(first, count)` for each primitive's run of indices.
template <class Take>
void for_each_run(const MeshData& data, Take take) {
    const std::size_t count = index_count(data);
    const auto in_steps = [&](std::size_t step) {
        for (std::size_t i = 0; i + step <= count; i += step) take(i, step);
    };
    switch (data.primitive) {
        case Primitive::Points: return in_steps(1);
        case Primitive::Lines: return in_steps(2);
        case Primitive::Quads: return in_steps(4);
        case Primitive::LineStrip:
            for (std::size_t i = 0; i + 2 <= count; ++i) take(i, std::size_t(2));
            return;
        case Primitive::Polygons: {
            std::size_t first = 0;
            for (const std::uint32_t size : data.polygon_sizes) {
                take(first, std::size_t(size));
                first += size;
            }
            return;
        }
        default: return in_steps(3);
    }
}

/// A vertex in window coordinates.
struct Reported {
    double x = 0, y = 0, z = 0, w = 1;
    vec4 color{0};
    vec4 texcoord{0};
};

void put(Selection& s, double value) {
    if (s.feedback_used < s.feedback_size)
        s.feedback[s.feedback_used++] = float(value);
    else
        s.overflow = true;
}

void put(Selection& s, const Reported& v) {
    const GLenum type = s.feedback_type;
    put(s, v.x);
    put(s, v.y);
    if (type == GL_2D) return;
    put(s, v.z);
    if (type == GL_3D) return;
    if (type == GL_4D_COLOR_TEXTURE) put(s, v.w);
    for (int i = 0; i < 4; ++i) put(s, double(v.color[i]));
    if (type == GL_3D_COLOR) return;
    for (int i = 0; i < 4; ++i) put(s, double(v.texcoord[i]));
}

/// The viewport whose guard band is the view volume: its scale, a power of two, is exact. The machine
/// clips at the guard band only; selection and feedback clip at the volume's sides. [GL11] 2.11
ViewportTransform sides_of_view_volume(const gw::State& state) {
    constexpr double half = (guard_high - guard_low) / 2, center = guard_low + half;
    static_assert(half == 8192);
    ViewportTransform out;
    out.half_width = out.half_height = half;
    out.center_x = out.center_y = center;
    out.zero_to_one = state.clip_control.depth == ClipDepth::ZeroToOne;
    return out;
}

/// The state without colours, for selection: it asks for depths only.
gw::State reported_state(const Context& context) {
    gw::State out = context.translated.state;
    if (context.selection.mode != GL_SELECT) return out;
    out.color_source = ColorSource::PolygonId;
    out.fog.enable = false;
    return out;
}

struct Reporter {
    Context& context;
    const Draw& draw;
    const gw::State state = reported_state(context);
    VertexProgram program = vertex_program(state, draw, context.profile);
    ViewportTransform viewport = resolve(state, context.profile, std::max(1, state.viewport.width),
                                         std::max(1, state.viewport.height))
                                     .viewport;

    void report_given(const Given& given);

private:
    bool is_outlined() const {
        return mode_of(state, true) != gw::PolygonMode::Fill ||
               mode_of(state, false) != gw::PolygonMode::Fill;
    }
    Reported reported(const Vertex& v, bool front) const;
    bool is_front(const std::vector<Vertex>& vertices) const;
    void report_point(const Reported& v);
    void report_line(const Reported& a, const Reported& b, bool first);
    void report_polygon(const std::vector<Reported>& vertices);
    void report_outline(const std::vector<Vertex>& vertices, const Given& given, bool front);
};

Reported Reporter::reported(const Vertex& v, bool front) const {
    const double w = v.clip.w;
    const auto& color = front || !state.lighting.two_side ? v.color : v.back_color;
    const double largest = double((1u << context.profile.color_bits) - 1);
    Reported out{(v.clip.x / w) * viewport.half_width + viewport.center_x,
                 (v.clip.y / w) * viewport.half_height + viewport.center_y,
                 window_depth(v.clip.z / w, state), w};
    for (int i = 0; i < 4; ++i) {
        out.color[i] = float(color[std::size_t(i)] / largest);
        out.texcoord[i] = float(v.texcoord[i]);
    }
    return out;
}

/// [GL11] 3.5.1: the sign of the area on the window.
bool Reporter::is_front(const std::vector<Vertex>& vertices) const {
    double area = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const dvec4 &a = vertices[i].clip, &b = vertices[(i + 1) % vertices.size()].clip;
        area += (a.x / a.w) * (b.y / b.w) - (b.x / b.w) * (a.y / a.w);
    }
    return state.cull.front == Winding::CCW ? area > 0 : area < 0;
}

void Reporter::report_point(const Reported& v) {
    if (context.selection.mode == GL_SELECT) return report_depth(context, v.z);
    put(context.selection, GL_POINT_TOKEN);
    put(context.selection, v);
}

void Reporter::report_line(const Reported& a, const Reported& b, bool first) {
    if (context.selection.mode == GL_SELECT) {
        report_depth(context, a.z);
        return report_depth(context, b.z);
    }
    put(context.selection, first ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
    put(context.selection, a);
    put(context.selection, b);
}

void Reporter::report_polygon(const std::vector<Reported>& vertices) {
    if (context.selection.mode == GL_SELECT) {
        for (const Reported& v : vertices) report_depth(context, v.z);
        return;
    }
    put(context.selection, GL_POLYGON_TOKEN);
    put(context.selection, double(vertices.size()));
    for (const Reported& v : vertices) put(context.selection, v);
}

/// PolygonMode Point and Line: the polygon's edges, each clipped on its own, as the machine draws them.
void Reporter::report_outline(const std::vector<Vertex>& vertices, const Given& given, bool front) {
    const bool is_lines = mode_of(state, front) == gw::PolygonMode::Line;
    bool is_first = true;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (!given.edges[i]) continue;
        std::vector<Vertex> side{vertices[i]};
        if (is_lines) side.push_back(vertices[(i + 1) % vertices.size()]);
        const std::vector<Vertex> left =
            clip(std::move(side), sides_of_view_volume(state)).vertices;
        if (left.empty()) continue;
        const Reported first = reported(left.front(), front);
        if (!is_lines) {
            report_point(first);
            continue;
        }
        report_line(first, reported(left.back(), front), is_first);
        is_first = false;
    }
}

void Reporter::report_given(const Given& given) {
    std::vector<Vertex> vertices;
    vertices.reserve(given.vertices.size());
    for (const std::uint32_t index : given.vertices) vertices.push_back(run_vertex(program, index));
    if (state.shade_model == ShadeModel::Flat) {
        const Vertex provoking = vertices[given.provoking];
        for (Vertex& v : vertices) {
            v.color = provoking.color;
            v.back_color = provoking.back_color;
        }
    }
    const ViewportTransform sides = sides_of_view_volume(state);
    const Clipped clipped =
        is_outlined() ? clip(vertices, sides) : clip(std::move(vertices), sides);
    if (clipped.vertices.empty()) return;
    const bool is_polygon = given.vertices.size() > 2;
    const bool front = !is_polygon || is_front(clipped.vertices);
    if (is_polygon && state.cull.enable &&
        (state.cull.face == Face::FrontAndBack || (state.cull.face == Face::Front) == front))
        return;
    if (is_polygon && mode_of(state, front) != gw::PolygonMode::Fill)
        return report_outline(vertices, given, front);
    std::vector<Reported> out;
    out.reserve(clipped.vertices.size());
    for (const Vertex& v : clipped.vertices) out.push_back(reported(v, front));
    if (out.size() == 1) return report_point(out[0]);
    if (out.size() == 2) return report_line(out[0], out[1], given.begins_stipple);
    report_polygon(out);
}

/// A quad of a strip has its third corner, which gives a flat colour, last (Assembly). It is reported
/// from its first corner. [GL11] 2.6.1
void begin_at_first_corner(Given& quad) {
    if (quad.vertices[1] > quad.vertices[0]) return;
    std::rotate(quad.vertices.begin(), quad.vertices.begin() + 1, quad.vertices.end());
    std::rotate(quad.edges.begin(), quad.edges.begin() + 1, quad.edges.end());
    quad.provoking = 2;
}

}  // namespace

void report(Context& context, const Draw& submitted) {
    Draw draw = submitted;
    if (context.selection.mode == GL_SELECT) {
        draw.map = {};
        draw.more_maps = nullptr;
    } else {
        draw = with_texture_coordinates(std::move(draw));
    }
    Reporter reporter{context, draw};
    const MeshData& data = draw.mesh->data();
    Given given;
    for_each_run(data, [&](std::size_t first, std::size_t count) {
        given.vertices.clear();
        given.edges.clear();
        for (std::size_t i = 0; i < count; ++i) {
            given.vertices.push_back(vertex_index(data, first + i));
            given.edges.push_back(data.edge_flags.empty() ||
                                  data.edge_flags[given.vertices.back()] != 0);
        }
        given.provoking = data.primitive == Primitive::Polygons ? 0 : count - 1;
        if (data.primitive == Primitive::Quads) begin_at_first_corner(given);
        given.begins_stipple = data.primitive != Primitive::LineStrip || first == 0;
        reporter.report_given(given);
    });
}

void report_raster_position(Context& context, GLenum token) {
    if (context.selection.mode != GL_FEEDBACK) return;
    const CurrentState::Raster& raster = context.state.current.raster;
    const dvec4& p = raster.position;
    put(context.selection, double(token));
    put(context.selection, Reported{p.x, p.y, p.z, p.w, raster.color, raster.texcoord});
}

void report_depth(Context& context, double depth) {
    Selection& s = context.selection;
    if (s.mode != GL_SELECT) return;
    s.nearest = s.hit ? std::min(s.nearest, depth) : depth;
    s.farthest = s.hit ? std::max(s.farthest, depth) : depth;
    s.hit = true;
}

}  // namespace gw::gl
