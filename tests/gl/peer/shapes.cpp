// Shapes of every primitive mode, given by Begin and End, by lists and by vertex arrays.
#include "tests/gl/peer/steps.h"

#include <cmath>

namespace gw::gl_peer {

namespace {

struct Corner {
    std::array<GLfloat, 4> color{1, 1, 1, 1};
    std::array<GLfloat, 3> normal{0, 0, 1};
    std::array<GLfloat, 3> position{};
    std::array<GLfloat, 2> texcoord{};
    GLboolean edge = GL_TRUE;
};

struct Shape {
    GLenum mode = GL_POINTS;
    std::vector<Corner> corners;
};

/// A multiple of 1/64: implementations agree on it in every arithmetic.
GLfloat fraction(Random& random, int low, int high) {
    return GLfloat(random.between(64 * low, 64 * high)) / 64;
}

/// Not on the planes in front and behind, where rounding decides.
GLfloat some_depth(Random& random) { return GLfloat(random.between(-63, 63)) / 64; }

/// Colours and depths inside 0 .. 1 that are affine in x and y, so that it does not matter how a
/// polygon is cut.
struct Affine {
    explicit Affine(Random& random) {
        for (auto& row : rows)
            row = {GLfloat(random.real(0.4, 0.6)), GLfloat(random.real(-0.11, 0.11)),
                   GLfloat(random.real(-0.11, 0.11))};
    }
    std::array<std::array<GLfloat, 3>, 5> rows;  ///< red, green, blue, alpha, depth
    GLfloat at(std::size_t i, GLfloat x, GLfloat y) const {
        return rows[i][0] + rows[i][1] * x + rows[i][2] * y;
    }
};

/// No pixel's centre is on a side between texels, where rounding decides: of a texture of 16 texels it
/// is an odd multiple of 1/96 and 1/80 texel away.
constexpr GLfloat s_of_x = 65.0f / 32, t_of_y = 33.0f / 32;
static_assert(window_width == 48 && window_height == 40);

Corner corner_at(Random& random, const Affine* affine, GLfloat x, GLfloat y) {
    Corner out;
    out.position = {x, y, affine ? affine->at(4, x, y) - 0.5f : some_depth(random)};
    out.color = some_color(random);
    if (affine)
        for (std::size_t i = 0; i < 4; ++i) out.color[i] = affine->at(i, x, y);
    out.texcoord = {affine ? s_of_x * x : fraction(random, -1, 2),
                    affine ? t_of_y * y : fraction(random, -1, 2)};
    out.normal = {affine ? 0.36f : GLfloat(random.real(-1, 1)),
                  affine ? 0.48f : GLfloat(random.real(-1, 1)), affine ? 0.8f : 1.0f};
    out.edge = random.chance(75) ? GL_TRUE : GL_FALSE;
    return out;
}

/// Corners of a convex polygon, counter-clockwise or clockwise.
void add_convex(std::vector<Corner>& out, Random& random, const Affine& affine, int count) {
    const double x = random.real(-0.8, 0.8), y = random.real(-0.8, 0.8);
    const double a = random.real(0.2, 0.9), b = random.real(0.2, 0.9), turn = random.real(0, 6);
    const int sign = (random.chance(40) ? -1 : 1);
    for (int i = 0; i < count; ++i) {
        const double angle = turn + sign * 2 * M_PI * i / count;
        out.push_back(corner_at(random, &affine, GLfloat(x + a * std::cos(angle)),
                                GLfloat(y + b * std::sin(angle))));
    }
}

void add_quad_strip(std::vector<Corner>& out, Random& random, const Affine& affine, int pairs) {
    const double slope = random.real(-0.5, 0.5), height = random.real(0.2, 0.9);
    const double step = random.real(0.2, 0.5);
    for (int i = 0; i < pairs; ++i)
        for (int side = 0; side < 2; ++side)
            out.push_back(corner_at(random, &affine, GLfloat(-0.9 + step * i),
                                    GLfloat(slope * i * step + side * height - 0.4)));
}

/// Unless it may be uneven, a shape looks the same however it is cut into triangles. What overlaps is
/// not on one plane: rounding would decide what is in front.
Shape some_shape(Random& random, bool may_be_uneven) {
    constexpr GLenum uneven[] = {GL_POINTS,    GL_LINES,          GL_LINE_STRIP,  GL_LINE_LOOP,
                                 GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
    Shape out;
    out.mode = may_be_uneven ? uneven[random.below(7)] : GLenum(random.below(GL_POLYGON + 1));
    const Affine affine(random);
    const int n = random.between(0, 4);
    if (out.mode == GL_QUADS)
        for (int i = 0; i < n; ++i) add_convex(out.corners, random, Affine(random), 4);
    else if (out.mode == GL_QUAD_STRIP)  // enough: Mesa's lists draw a quad of three vertices
        add_quad_strip(out.corners, random, affine, n + 2);
    else if (out.mode == GL_POLYGON)
        add_convex(out.corners, random, affine, n + 3);
    else
        for (int i = 0; i < 3 + 2 * n; ++i) {  // enough: Mesa's lists draw strips of two vertices
            const auto x = GLfloat(random.real(-1.1, 1.1)), y = GLfloat(random.real(-1.1, 1.1));
            out.corners.push_back(corner_at(random, may_be_uneven ? nullptr : &affine, x, y));
            out.corners.back().position[2] = some_depth(random);
        }
    // Left over: too few for the last primitive.
    for (int i = random.chance(10) ? 1 : 0; i > 0 && out.mode != GL_POLYGON; --i)
        out.corners.push_back(corner_at(random, &affine, 0.1f, 0.2f));
    return out;
}

/// Which values corners give; the others are the current ones.
struct Given {
    bool color, normal, texcoord, edge;
};

void give(const Gl& gl, const Corner& c, const Given& given) {
    if (given.color) gl.Color4fv(c.color.data());
    if (given.normal) gl.Normal3fv(c.normal.data());
    if (given.texcoord) gl.TexCoord2fv(c.texcoord.data());
    if (given.edge) gl.EdgeFlag(c.edge);
    gl.Vertex3fv(c.position.data());
}

void by_calls(const Gl& gl, const Shape& shape, const Given& given) {
    gl.Begin(shape.mode);
    for (const Corner& c : shape.corners) give(gl, c, given);
    gl.End();
}

void set_array(const Gl& gl, GLenum name, bool enable) {
    enable ? gl.EnableClientState(name) : gl.DisableClientState(name);
}

void use_arrays(const Gl& gl, const Shape& shape, const Given& given) {
    constexpr GLsizei stride = sizeof(Corner);
    const Corner& first = shape.corners.front();
    gl.VertexPointer(3, GL_FLOAT, stride, first.position.data());
    gl.ColorPointer(4, GL_FLOAT, stride, first.color.data());
    gl.NormalPointer(GL_FLOAT, stride, first.normal.data());
    gl.TexCoordPointer(2, GL_FLOAT, stride, first.texcoord.data());
    gl.EdgeFlagPointer(stride, &first.edge);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    set_array(gl, GL_COLOR_ARRAY, given.color);
    set_array(gl, GL_NORMAL_ARRAY, given.normal);
    set_array(gl, GL_TEXTURE_COORD_ARRAY, given.texcoord);
    set_array(gl, GL_EDGE_FLAG_ARRAY, given.edge);
}

void by_arrays(const Gl& gl, const Shape& shape, const Given& given, Random& random) {
    if (shape.corners.empty()) return;
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    use_arrays(gl, shape, given);
    const auto count = GLsizei(shape.corners.size());
    std::vector<GLushort> indices;
    for (GLsizei i = 0; i < count; ++i) indices.push_back(GLushort(i));
    switch (random.below(3)) {
        case 0: gl.DrawArrays(shape.mode, 0, count); break;
        case 1: gl.DrawElements(shape.mode, count, GL_UNSIGNED_SHORT, indices.data()); break;
        case 2:
            gl.Begin(shape.mode);
            for (GLsizei i = 0; i < count; ++i) gl.ArrayElement(i);
            gl.End();
    }
    gl.PopClientAttrib();
}

void emit(const Gl& gl, const Shape& shape, Random& random) {
    // Without edge flags: Mesa keeps those of one shape for the next.
    const Given given{random.chance(80), random.chance(80), random.chance(80), false};
    const int way = random.below(5);
    if (way == 0) return by_arrays(gl, shape, given, random);
    if (way > 2) return by_calls(gl, shape, given);
    const GLenum mode = way == 1 ? GL_COMPILE : GL_COMPILE_AND_EXECUTE;
    gl.NewList(7, mode);
    random.chance(70) ? by_calls(gl, shape, given) : by_arrays(gl, shape, given, random);
    gl.EndList();
    if (mode == GL_COMPILE) gl.CallList(7);
    gl.DeleteLists(7, 1);
}

void set_current(const Gl& gl, Random& random) {
    gl.Color4fv(some_color(random).data());
    gl.Normal3f(0, 0.6f, 0.8f);
    constexpr GLfloat off_edges = 1.0f / 128;  // of texels, where rounding decides
    const GLfloat u = fraction(random, 0, 1) + off_edges;
    gl.TexCoord2f(u, fraction(random, 0, 1) + off_edges);
    gl.EdgeFlag(GL_TRUE);
}

void draw_shapes(const Gl& gl, Random& random, Results& out, bool may_be_uneven) {
    emit_shapes(gl, random, may_be_uneven);
    look(gl, out);
}

/// Not 0: Mesa's highlights are too dark then, if the light is attenuated.
void shine(const Gl& gl) {
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        GLfloat shininess = 0;
        gl.GetMaterialfv(face, GL_SHININESS, &shininess);
        if (shininess == 0) gl.Materialf(face, GL_SHININESS, 1);
    }
}

struct Control {
    std::array<GLfloat, 4 * 4 * 4> values{};
};

Control some_points(Random& random, int components) {
    Control out;
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < components; ++k)
            out.values[std::size_t(components * i + k)] =
                k == 0   ? GLfloat(i % 4) / 2 - 0.75f + GLfloat(random.real(-0.1, 0.1))
                : k == 1 ? GLfloat(i / 4) / 2 - 0.75f + GLfloat(random.real(-0.1, 0.1))
                         : GLfloat(random.real(0.1, 0.9));
    return out;
}

}  // namespace

std::array<GLfloat, 4> some_color(Random& random) {
    std::array<GLfloat, 4> out;
    for (GLfloat& channel : out) channel = GLfloat(random.between(0, 255)) / 255;
    return out;
}

void look(const Gl& gl, Results& out) {
    out.values.push_back({"error", {double(gl.GetError())}});
    out.pictures.push_back(picture_of(gl));
}

void emit_shapes(const Gl& gl, Random& random, bool may_be_uneven) {
    for (int i = random.between(1, 3); i > 0; --i) {
        set_current(gl, random);  // arrays leave them undefined
        emit(gl, some_shape(random, may_be_uneven), random);
    }
}

void draw_shape(const Gl& gl, Random& random, Results& out) {
    draw_shapes(gl, random, out, random.chance(40));
}

/// Far from the window's sides, which clip no points here, and add no lines to polygons. The order of
/// a polygon's edges is open, so wide ones have one colour.
void draw_inner_shape(const Gl& gl, Random& random, Results& out) {
    std::array<GLint, 2> modes{};
    std::array<GLfloat, 2> sizes{};
    gl.GetIntegerv(GL_POLYGON_MODE, modes.data());
    gl.GetFloatv(GL_POINT_SIZE, &sizes[0]);
    gl.GetFloatv(GL_LINE_WIDTH, &sizes[1]);
    const bool has_edges = modes[0] != GL_FILL || modes[1] != GL_FILL;
    if (has_edges && sizes != std::array<GLfloat, 2>{1, 1}) gl.ShadeModel(GL_FLAT);
    gl.PushMatrix();
    gl.Scalef(0.6f, 0.6f, 1);
    draw_shapes(gl, random, out, true);
    gl.PopMatrix();
}

void draw_textured_shape(const Gl& gl, Random& random, Results& out) {
    use_one_texture(gl);
    draw_shape(gl, random, out);
}

void draw_lit_shape(const Gl& gl, Random& random, Results& out) {
    gl.Enable(GL_LIGHTING);
    shine(gl);
    gl.Enable(GL_NORMALIZE);  // highlights of longer normals end at 1 here
    draw_shapes(gl, random, out, true);
    // OpenGL leaves colours, and so materials, open after DrawArrays. Mesa's materials follow when asked.
    std::array<GLfloat, 4> color{1, 0.5f, 0.25f, 1};
    gl.Color4fv(color.data());
    gl.GetFloatv(GL_CURRENT_COLOR, color.data());
    gl.Disable(GL_LIGHTING);
}

/// A curve or a surface, by evaluators.
void draw_surface(const Gl& gl, Random& random, Results& out) {
    const Control points = some_points(random, 3), colors = some_points(random, 4);
    const int n = random.between(2, 8);
    gl.PushAttrib(GL_EVAL_BIT | GL_CURRENT_BIT);
    if (random.chance(40)) {
        gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points.values.data());
        gl.Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 4, colors.values.data());
        gl.Enable(GL_MAP1_VERTEX_3);
        if (random.chance(50)) gl.Enable(GL_MAP1_COLOR_4);
        gl.MapGrid1f(n, 0, 1);
        gl.EvalMesh1(random.chance(50) ? GL_LINE : GL_POINT, 0, n);
    } else {
        gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, points.values.data());
        gl.Enable(GL_MAP2_VERTEX_3);
        if (random.chance(50)) gl.Enable(GL_AUTO_NORMAL);
        gl.MapGrid2f(n, 0, 1, n, 0, 1);
        gl.EvalMesh2(random.pick<GLenum>({GL_FILL, GL_LINE, GL_POINT}), 0, n, 0, n);
    }
    gl.PopAttrib();
    look(gl, out);
}

void accumulate(const Gl& gl, Random& random, Results& out) {
    const int pictures = random.between(1, 64);
    const GLfloat share = 1 / GLfloat(pictures);
    gl.Accum(GL_LOAD, 0.5f);
    emit_shapes(gl, random, false);
    for (int i = 0; i < pictures; ++i) gl.Accum(GL_ACCUM, 0.5f * share);
    if (random.chance(30)) gl.Accum(GL_ADD, GLfloat(random.real(-0.2, 0.2)));
    if (random.chance(30)) gl.Accum(GL_MULT, GLfloat(random.real(0.5, 1)));
    gl.Accum(GL_RETURN, 1);
    out.color_bound = 2;  // each side is within 1 of the exact mean
    look(gl, out);
}

}  // namespace gw::gl_peer
