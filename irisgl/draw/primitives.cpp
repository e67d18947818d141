#include "irisgl/draw/primitives.h"

#include "irisgl/draw/apply.h"
#include "irisgl/draw/picking.h"
#include "irisgl/state/program.h"

#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gw::irisgl {

Assembly& assembly() {
    static Assembly& one = *new Assembly;
    return one;
}

PlaneState& planes_now() {
    State& s = state();
    return s.now.planes[plane_of(s.draw_mode)];
}

bool draws_indices() { return state().draw_mode != NORMALDRAW || !state().rgb_mode; }

Vertex vertex_here(double x, double y, double z, double w) {
    const State& s = state();
    const PlaneState& p = planes_now();
    return {.p = {x, y, z, w},
            .index = p.index,
            .rgb = p.rgb,
            .normal = s.normal,
            .texture = s.texture_coordinate,
            .is_lit = s.is_lit && s.bound.is_lit()};
}

void gl_index_color(unsigned index) {
    const int bits = current_window().profile().color_bits;
    const IndexColor code{std::min(bits, 8)};
    const float most = float((1 << bits) - 1);
    glColor4f(float(code.low(index)) / most, float(code.high(index)) / most, 0, 1);
}

namespace {

constexpr GLenum gl_shapes[] = {GL_POINTS,         GL_LINE_STRIP, GL_LINE_LOOP, GL_POLYGON,
                                GL_TRIANGLE_STRIP, GL_TRIANGLES,  GL_QUAD_STRIP};

unsigned byte_of(float v) { return unsigned(std::floor(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f)); }

unsigned rounded(double index) {
    return unsigned(std::clamp(std::floor(index + 0.5), 0.0, double(index_mask)));
}

/// Depth cueing: colours by the vertices' depths.
void cue(std::vector<Vertex>& vertices) {
    const DepthCue& cue = state().cue;
    const double near = depth_of_range(cue.near), far = depth_of_range(cue.far);
    for (Vertex& v : vertices) {
        const auto at = window_from_object(v.p);
        const double z = at ? at->z : 0;
        double t = far != near ? (z - near) / (far - near) : 0;
        t = std::clamp(t, 0.0, 1.0);
        // The near end has the high index.
        v.index = double(cue.high) + t * (double(cue.low) - double(cue.high));
        for (int i = 0; i < 3; ++i) {
            const float low = cue.rgb[std::size_t(i)], high = cue.rgb[std::size_t(i) + 3];
            v.rgb[i] = (high + float(t) * (low - high)) / 255;
        }
        v.is_lit = false;
    }
}

void flatten(Shape shape, std::vector<Vertex>& vertices) {
    if (shape == Shape::Points) return;
    if (shape == Shape::Polygon)
        for (Vertex& v : vertices) {
            v.index = vertices.back().index;
            v.rgb = vertices.back().rgb;
        }
}

bool is_uniform(std::span<const Vertex> vertices) {
    return std::all_of(vertices.begin(), vertices.end(), [&](const Vertex& v) {
        return rounded(v.index) == rounded(vertices[0].index);
    });
}

struct Emission {
    bool indices = false, texture = false, lit = false, mixed = false;
    bool is_number = false;  ///< feedback: the index is a coordinate
};

void emit_color(const Vertex& v, const Emission& e) {
    if (e.is_number) return glTexCoord1d(v.index);
    if (e.indices) {
        if (!e.texture)
            gl_index_color(rounded(v.index));
        else
            glTexCoord1d((std::clamp(v.index, 0.0, double(index_mask)) + 0.5) / 4096);
        return;
    }
    if (e.lit) {
        if (e.mixed) emit_material(v.is_lit, v.rgb);
        glNormal3f(v.normal.x, v.normal.y, v.normal.z);
    }
    glColor4f(v.rgb.x, v.rgb.y, v.rgb.z, v.rgb.w);
    if (state().textured) glTexCoord4f(v.texture.x, v.texture.y, v.texture.z, v.texture.w);
}

void emit(GLenum mode, std::span<const Vertex> vertices, const Emission& e) {
    glBegin(mode);
    for (const Vertex& v : vertices) {
        emit_color(v, e);
        glVertex4d(v.p.x, v.p.y, v.p.z, v.p.w);
    }
    glEnd();
}

/// A line of one pixel has both its ends, unless subpixel is on.
bool adds_last_point(Shape shape) {
    const State& s = state();
    return shape == Shape::Line && !gives_feedback() && s.now.line_width == 1 &&
           s.now.linestyle == 0 && !s.smooth.lines && !s.subpixel;
}

void emit_shape(Shape shape, std::span<const Vertex> vertices, const Emission& e) {
    emit(gl_shapes[std::size_t(shape)], vertices, e);
    if (adds_last_point(shape)) emit(GL_POINTS, vertices.last(1), e);
}

std::vector<Vertex> unswapped(std::span<const Vertex> in, const std::vector<std::size_t>& swaps) {
    std::vector<Vertex> out;
    std::size_t swap = 0;
    const Vertex* older = nullptr;
    const Vertex* newer = nullptr;
    for (std::size_t i = 0; i < in.size(); ++i) {
        while (swap < swaps.size() && swaps[swap] == i) {
            std::swap(older, newer);
            ++swap;
        }
        if (older != nullptr && newer != nullptr) out.insert(out.end(), {*older, *newer, in[i]});
        older = newer;
        newer = &in[i];
    }
    return out;
}

void draw_indices(Shape shape, std::span<const Vertex> vertices) {
    if (gives_feedback()) {
        glDisable(GL_LIGHTING);
        return emit_shape(shape, vertices, {.indices = true, .is_number = true});
    }
    if (planes_now().writemask > 0xFF && state().compares_color && state().depth_test)
        warn("zsource: colours above 255 are compared by parts: their low 8 and high 4 bits");
    const bool texture = shape != Shape::Points && !is_uniform(vertices) && bind_index_texture();
    glDisable(GL_LIGHTING);
    use_index_texture(texture);
    emit_shape(shape, vertices, {.indices = true, .texture = texture});
    use_index_texture(false);
}

void draw_rgb(Shape shape, std::span<const Vertex> vertices) {
    const auto lit =
        std::count_if(vertices.begin(), vertices.end(), [](const Vertex& v) { return v.is_lit; });
    const bool colored = state().bound.color_mode != LMC_COLOR && state().bound.is_lit();
    const Emission e{.lit = lit > 0 || colored,
                     .mixed = lit > 0 && std::size_t(lit) < vertices.size() && !colored};
    (e.lit ? glEnable : glDisable)(GL_LIGHTING);
    emit_shape(shape, vertices, e);
    if (e.mixed) emit_material(true, {});
}

/// zdraw: the colour also becomes the depth, as a number of 24 bits.
void draw_into_depths(Shape shape, std::span<const Vertex> vertices) {
    const Vertex& first = vertices.front();
    if (!std::all_of(vertices.begin(), vertices.end(), [&](const Vertex& v) {
            return v.rgb == first.rgb && v.index == first.index && !v.is_lit;
        }))
        return warn(
            "zdraw: what has several colours, or light, is not drawn into the Z-buffer; expected "
            "one colour");
    std::uint32_t number = rounded(first.index);
    for (int i = 0; i < 3 && !draws_indices(); ++i)
        number = (i == 0 ? 0 : number) | byte_of(first.rgb[i]) << 8 * i;
    const double depth = depth_of(std::int32_t(number << 8) >> 8);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glDepthRange(depth, depth);
    emit_shape(shape, vertices, {});
    apply_depth();
    apply_color_mask();
}

bool is_area(Shape shape) {
    return shape != Shape::Points && shape != Shape::Line && shape != Shape::ClosedLine;
}

/// Until `draw` has returned, vertices are in the window's own coordinates, -1 .. 1.
template <class Draw>
void draw_on_window(const Draw& draw) {
    const Window& w = current_window();
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glViewport(0, 0, w.width(), w.height());
    draw();
    const Bounds& view = state().viewport;
    glViewport(view.left, view.bottom, view.width(), view.height());
}

/// False: no line, or not smooth, or not of indices.
bool draw_smooth_line(Shape shape, std::span<const Vertex> vertices) {
    const State& s = state();
    if (!s.smooth.lines || !draws_indices() || gives_feedback() || picks()) return false;
    if (shape != Shape::Line && shape != Shape::ClosedLine) return false;
    const auto pixels = smooth_pixels(vertices, shape == Shape::ClosedLine);
    if (pixels.empty()) return true;
    glDisable(GL_POINT_SMOOTH);
    glPointSize(1);
    draw_on_window([&] { draw_indices(Shape::Points, pixels); });
    apply_lines();
    return true;
}

void draw_colors(Shape shape, std::span<const Vertex> vertices) {
    draws_indices() ? draw_indices(shape, vertices) : draw_rgb(shape, vertices);
}

void draw_with_state(Shape shape, std::span<const Vertex> vertices, const Bounds& pixels,
                     std::optional<std::span<const Vertex>> hollow = {}) {
    const auto draw = [&] { draw_colors(shape, vertices); };
    track(pixels);
    if (draw_smooth_line(shape, vertices)) return;
    if (hollow && is_area(shape))
        draw_hollow(shape, vertices, *hollow, draw_colors);
    else
        is_area(shape) ? draw_in_pattern(pixels, draw) : draw();
    if (state().draws_depth && state().draw_mode == NORMALDRAW && !gives_feedback() && !picks())
        draw_into_depths(shape, vertices);
}

}  // namespace

void draw_shape(Shape shape, std::span<const Vertex> given) {
    if (given.empty()) return;
    pass(state().double_buffered ? parts_of_unshown_primitive : parts_of_primitive);
    draw_part(shape, given);
}

void draw_part(Shape shape, std::span<const Vertex> given, bool is_placed) {
    std::vector<Vertex> vertices(given.begin(), given.end());
    const State& s = state();
    if (shape == Shape::Mesh && !assembly().swaps.empty()) {
        vertices = unswapped(vertices, assembly().swaps);
        shape = Shape::Triangles;
        if (vertices.empty()) return;
    }
    if (s.cue.on) cue(vertices);
    if (draws_indices() && s.bound.is_lit()) light_indices(vertices);
    if (s.now.shade_model == FLAT) flatten(shape, vertices);
    if (!s.subpixel && !is_placed && !gives_feedback() && !picks())
        snap_to_pixels(vertices, is_area(shape));
    std::optional<std::vector<Vertex>> outline;
    if (draws_hollow()) outline = shape == Shape::Polygon ? vertices : std::vector<Vertex>();
    if (shape == Shape::Polygon && s.concave && vertices.size() > 3) {
        vertices = tessellated(vertices);
        shape = Shape::Triangles;
    }
    load_matrices();
    const bool needs_bounds = s.box.is_tracked || s.now.pattern != 0;
    draw_with_state(shape, vertices, needs_bounds ? pixels_around(vertices) : Bounds{},
                    outline ? std::optional<std::span<const Vertex>>(*outline) : std::nullopt);
}

void fill_pixels(const Bounds& p, double depth) {
    const Window& w = current_window();
    const auto x = [&](int pixel) { return 2.0 * pixel / w.width() - 1; };
    const auto y = [&](int pixel) { return 2.0 * pixel / w.height() - 1; };
    Vertex v = vertex_here(0, 0, 0);
    v.is_lit = false;
    std::vector<Vertex> corners(4, v);
    corners[0].p = {x(p.left), y(p.bottom), depth, 1};
    corners[1].p = {x(p.right + 1), y(p.bottom), depth, 1};
    corners[2].p = {x(p.right + 1), y(p.top + 1), depth, 1};
    corners[3].p = {x(p.left), y(p.top + 1), depth, 1};
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_CULL_FACE);
    draw_on_window([&] { draw_with_state(Shape::Polygon, corners, p); });
    apply_polygons();
}

}  // namespace gw::irisgl
