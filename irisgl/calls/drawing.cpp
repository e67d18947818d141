// Points, lines, polygons, rectangles.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace gw::irisgl::calls {

namespace {

void begin(Shape shape) {
    Assembly& a = assembly();
    a.is_open = true;
    a.shape = shape;
    a.vertices.clear();
    a.swaps.clear();
}

void set_position(double x, double y, double z) { state().position = {x, y, z, 1}; }

dvec3 position() {
    const dvec4& p = state().position;
    return {p.x, p.y, p.z};
}

std::vector<Vertex> vertices_at(std::span<const dvec4> points) {
    std::vector<Vertex> vertices;
    for (const dvec4& p : points) vertices.push_back(vertex_here(p.x, p.y, p.z, p.w));
    return vertices;
}

/// A polygon whose corners are those of pixels.
void draw_whole_pixels(std::span<const dvec4> corners) {
    assembly().swaps.clear();
    pass(state().double_buffered ? parts_of_unshown_primitive : parts_of_primitive);
    draw_part(Shape::Polygon, vertices_at(corners), true);
}

void draw_points(Shape shape, std::span<const dvec4> points) {
    const std::vector<Vertex> vertices = vertices_at(points);
    assembly().swaps.clear();
    shape == Shape::Polygon ? draw_old_polygon(vertices) : draw_shape(shape, vertices);
}

std::vector<dvec4> points_of(long n, Values values, int dimensions) {
    std::vector<dvec4> out;
    const auto at = [&](std::size_t i) { return double(values[i]); };
    for (std::size_t i = 0; i + std::size_t(dimensions) <= values.size() && long(out.size()) < n;
         i += std::size_t(dimensions))
        out.push_back({at(i), at(i + 1), dimensions > 2 ? at(i + 2) : 0, 1});
    return out;
}

}  // namespace

void bgnpoint() { begin(Shape::Points); }
void bgnline() { begin(Shape::Line); }
void bgnclosedline() { begin(Shape::ClosedLine); }
void bgnpolygon() { begin(Shape::Polygon); }
void bgntmesh() { begin(Shape::Mesh); }
void bgnqstrip() { begin(Shape::Strip); }

void end_primitive() {
    Assembly& a = assembly();
    if (!a.is_open) return;
    a.is_open = false;
    draw_shape(a.shape, a.vertices);
    a.swaps.clear();
}

void swaptmesh() {
    Assembly& a = assembly();
    if (a.is_open && a.shape == Shape::Mesh) a.swaps.push_back(a.vertices.size());
}

void vertex(double x, double y, double z, double w) {
    Assembly& a = assembly();
    state().position = {x, y, z, w};
    if (a.is_open) a.vertices.push_back(vertex_here(x, y, z, w));
}

void point(double x, double y, double z) {
    set_position(x, y, z);
    const dvec4 p{x, y, z, 1};
    draw_points(Shape::Points, {&p, 1});
}

void move(double x, double y, double z) { set_position(x, y, z); }

void relative_move(double x, double y, double z) {
    const dvec3 p = position();
    move(p.x + x, p.y + y, p.z + z);
}

void draw(double x, double y, double z) {
    const dvec4 ends[] = {state().position, {x, y, z, 1}};
    draw_points(Shape::Line, ends);
    set_position(x, y, z);
}

void relative_draw(double x, double y, double z) {
    const dvec3 p = position();
    draw(p.x + x, p.y + y, p.z + z);
}

void polygon_move(double x, double y, double z) {
    assembly().polygon.assign(1, vertex_here(x, y, z));
    set_position(x, y, z);
}

void relative_polygon_move(double x, double y, double z) {
    const dvec3 p = position();
    polygon_move(p.x + x, p.y + y, p.z + z);
}

void polygon_draw(double x, double y, double z) {
    assembly().polygon.push_back(vertex_here(x, y, z));
    set_position(x, y, z);
}

void relative_polygon_draw(double x, double y, double z) {
    const dvec3 p = position();
    polygon_draw(p.x + x, p.y + y, p.z + z);
}

void polygon_close() {
    assembly().swaps.clear();
    draw_old_polygon(assembly().polygon);
    assembly().polygon.clear();
}

void polygon(long n, Values points, int dimensions, bool filled) {
    const std::vector<dvec4> all = points_of(n, points, dimensions);
    if (all.empty()) return;
    draw_points(filled ? Shape::Polygon : Shape::ClosedLine, all);
    state().position = all.front();
}

void shaded_polygon(long n, Values points, int dimensions, Values indices) {
    const std::vector<dvec4> all = points_of(n, points, dimensions);
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < all.size() && i < indices.size(); ++i) {
        vertices.push_back(vertex_here(all[i].x, all[i].y, all[i].z));
        vertices.back().index = double(indices[i]);
    }
    assembly().swaps.clear();
    draw_old_polygon(vertices);
}

void rectangle(double x1, double y1, double x2, double y2, bool filled) {
    std::vector<dvec4> corners{{x1, y1, 0, 1}, {x2, y1, 0, 1}, {x2, y2, 0, 1}, {x1, y2, 0, 1}};
    set_position(x1, y1, 0);
    const bool owns_edges = filled && program().are_polygons_old && !gives_feedback();
    if (owns_edges && own_edge_pixels(corners)) return draw_whole_pixels(corners);
    draw_points(filled ? Shape::Polygon : Shape::ClosedLine, corners);
}

void circle(double x, double y, double radius, bool filled) { arc(x, y, radius, 0, 3600, filled); }

void arc(double x, double y, double radius, double start, double end, bool filled) {
    constexpr int segments = 80;  // of a whole circle
    double sweep = end - start;
    while (sweep <= 0) sweep += 3600;
    sweep = std::min(sweep, 3600.0);
    const bool whole = sweep >= 3600;
    const int count = std::max(1, int(std::ceil(segments * sweep / 3600)));
    std::vector<dvec4> points;
    if (filled && !whole) points.push_back({x, y, 0, 1});
    for (int i = 0; i < count + (whole ? 0 : 1); ++i) {
        const double a = (start + sweep * i / count) / 10;
        points.push_back({x + radius * cos_degrees(a), y + radius * sin_degrees(a), 0, 1});
    }
    draw_points(filled ? Shape::Polygon : whole ? Shape::ClosedLine : Shape::Line, points);
}

}  // namespace gw::irisgl::calls
