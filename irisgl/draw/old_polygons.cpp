// Polygons of commands older than bgnpolygon: polf, pclos, circf ... own the pixels of their edges.
#include "irisgl/draw/apply.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::irisgl {

namespace {

/// Twice the area on the screen, positive if counter-clockwise; none if a vertex is behind the eye.
std::optional<double> area_of(std::span<const Vertex> vertices) {
    double area = 0;
    auto last = window_from_object(vertices.back().p);
    for (const Vertex& v : vertices) {
        const auto at = window_from_object(v.p);
        if (!at || !last) return std::nullopt;
        area += last->x * at->y - at->x * last->y;
        last = at;
    }
    return area;
}

bool is_culled(std::span<const Vertex> vertices) {
    const State& s = state();
    if (!s.backface && !s.frontface) return false;
    const auto area = area_of(vertices);
    return !area || (s.backface && *area <= 0) || (s.frontface && *area >= 0);
}

bool are_in_middles_of_pixels(std::span<const Vertex> vertices) {
    if (!state().subpixel) return true;
    const auto is_middle = [](double v) { return std::abs(v - std::floor(v) - 0.5) < 1e-3; };
    return std::ranges::all_of(vertices, [&](const Vertex& v) {
        const auto at = window_from_object(v.p);
        return at && is_middle(at->x) && is_middle(at->y);
    });
}

/// Drawn twice, a pixel would differ; beside other depths an edge would show through.
bool may_be_drawn_twice() {
    const State& s = state();
    return s.polygon_mode == PYM_FILL && s.now.pattern == 0 && !s.depth_test && !s.draws_depth &&
           !s.smooth.polygons && !glIsEnabled(GL_BLEND) && !glIsEnabled(GL_COLOR_LOGIC_OP) &&
           !glIsEnabled(GL_STENCIL_TEST) && !gives_feedback() && !picks();
}

}  // namespace

void draw_old_polygon(std::span<const Vertex> vertices) {
    draw_shape(Shape::Polygon, vertices);
    if (vertices.size() < 3 || !program().are_polygons_old || !may_be_drawn_twice() ||
        !are_in_middles_of_pixels(vertices) || is_culled(vertices))
        return;
    std::vector<Vertex> edges(vertices.begin(), vertices.end());
    if (state().now.shade_model == FLAT)
        for (Vertex& v : edges) {
            v.index = edges.back().index;
            v.rgb = edges.back().rgb;
        }
    glLineWidth(1);
    glDisable(GL_LINE_STIPPLE);
    glDisable(GL_LINE_SMOOTH);
    draw_part(Shape::ClosedLine, edges);
    apply_lines();
}

}  // namespace gw::irisgl
