// Steps that give numbers: feedback, selection, queries.
#include "tests/gl/peer/steps.h"

#include <algorithm>
#include <cstdio>

namespace gw::gl_peer {

namespace {

/// How many numbers a vertex has.
std::size_t vertex_size(GLenum type) {
    switch (type) {
        case GL_2D: return 2;
        case GL_3D: return 3;
        case GL_3D_COLOR: return 7;
        case GL_3D_COLOR_TEXTURE: return 11;
    }
    return 12;
}

/// Points and lines; and the set of all polygons' vertices, since implementations may cut polygons
/// into triangles. A line's two tokens count as one: Mesa does not reset the stipple of GL_LINES.
void sort_feedback(const std::vector<GLfloat>& buffer, GLenum type, Results& out) {
    const std::size_t size = vertex_size(type);
    Values lines{"points and lines", {}, 0.01}, vertices{"vertices of polygons", {}, 0.01, size};
    const auto take = [&](Values& to, std::size_t at, std::size_t count) {
        for (std::size_t i = at; i < std::min(at + count, buffer.size()); ++i)
            to.values.push_back(double(buffer[i]));
        return at + count;
    };
    for (std::size_t at = 0; at < buffer.size();) {
        switch (const auto token = GLenum(buffer[at++])) {
            case GL_POLYGON_TOKEN:
                at = take(vertices, at + 1, size * std::size_t(buffer[at]));
                break;
            case GL_LINE_TOKEN:
            case GL_LINE_RESET_TOKEN: at = take(lines, at, 2 * size); break;
            case GL_PASS_THROUGH_TOKEN: at = take(lines, at, 1); break;
            case GL_POINT_TOKEN: at = take(lines, at, size); break;
            default: out.values.push_back({"wrong token", {double(token)}}); return;
        }
    }
    out.values.push_back(std::move(lines));
    out.values.push_back(std::move(vertices));
}

/// Mesa offsets the depths of feedback and selection, and leaves flat shading out.
void leave_out_of_answers(const Gl& gl) {
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.ShadeModel(GL_SMOOTH);
}

}  // namespace

void feed_back(const Gl& gl, Random& random, Results& out) {
    std::vector<GLfloat> buffer(4096);
    const GLenum type = GL_2D + GLenum(random.below(5));
    leave_out_of_answers(gl);
    gl.FeedbackBuffer(GLsizei(buffer.size()), type, buffer.data());
    gl.RenderMode(GL_FEEDBACK);
    gl.PassThrough(17);
    emit_shapes(gl, random, true);
    const GLint count = gl.RenderMode(GL_RENDER);
    buffer.resize(std::min(buffer.size(), std::size_t(std::max(count, 0))));
    sort_feedback(buffer, type, out);
    out.values.push_back({"error", {double(gl.GetError())}});
}

void select(const Gl& gl, Random& random, Results& out) {
    // Mesa wants memory, but changes the mode without it too.
    std::vector<GLuint> buffer(random.chance(85) ? 256 : std::size_t(random.between(1, 11)));
    leave_out_of_answers(gl);
    gl.DepthRange(0.125, 0.875);  // of depth 1, Mesa makes the word 0
    gl.SelectBuffer(GLsizei(buffer.size()), buffer.data());
    gl.RenderMode(GL_SELECT);
    gl.InitNames();
    int depth = 0;  // Mesa ends a record at calls that are errors
    for (GLuint name = 0; name < 4; ++name) {
        const bool pushes = depth == 0 || random.chance(60);
        pushes ? gl.PushName(name) : gl.LoadName(name);
        depth += pushes ? 1 : 0;
        emit_shapes(gl, random, true);
        if (!random.chance(40)) continue;
        gl.PopName();
        --depth;
    }
    const GLint hits = gl.RenderMode(GL_RENDER);
    out.values.push_back({"hits", {double(hits)}});
    Values records{"records", {}, 1e-4};
    std::size_t at = 0;
    for (GLint hit = 0; hit < hits && at + 3 <= buffer.size(); ++hit) {
        const std::size_t names = buffer[at];
        records.values.push_back(double(names));
        for (std::size_t i = 1; i < 3; ++i)  // depths as numbers of 0 .. 1
            records.values.push_back(double(buffer[at + i]) / 4294967295.0);
        for (std::size_t i = 3; i < 3 + names && at + i < buffer.size(); ++i)
            records.values.push_back(double(buffer[at + i]));
        at += 3 + names;
    }
    out.values.push_back(std::move(records));
    out.values.push_back({"error", {double(gl.GetError())}});
}

namespace {

struct Variable {
    GLenum name;
    int count;
};
constexpr Variable variables[] = {{GL_CURRENT_COLOR, 4},
                                  {GL_CURRENT_NORMAL, 3},
                                  {GL_CURRENT_TEXTURE_COORDS, 4},
                                  {GL_CURRENT_RASTER_POSITION_VALID, 1},
                                  {GL_EDGE_FLAG, 1},
                                  {GL_POINT_SIZE, 1},
                                  {GL_LINE_WIDTH, 1},
                                  {GL_LINE_STIPPLE_PATTERN, 1},
                                  {GL_LINE_STIPPLE_REPEAT, 1},
                                  {GL_POLYGON_MODE, 2},
                                  {GL_CULL_FACE, 1},
                                  {GL_CULL_FACE_MODE, 1},
                                  {GL_FRONT_FACE, 1},
                                  {GL_LIGHTING, 1},
                                  {GL_LIGHT_MODEL_LOCAL_VIEWER, 1},
                                  {GL_LIGHT_MODEL_TWO_SIDE, 1},
                                  {GL_LIGHT_MODEL_AMBIENT, 4},
                                  {GL_SHADE_MODEL, 1},
                                  {GL_COLOR_MATERIAL_FACE, 1},
                                  {GL_COLOR_MATERIAL_PARAMETER, 1},
                                  {GL_COLOR_MATERIAL, 1},
                                  {GL_FOG, 1},
                                  {GL_FOG_DENSITY, 1},
                                  {GL_FOG_START, 1},
                                  {GL_FOG_END, 1},
                                  {GL_FOG_MODE, 1},
                                  {GL_FOG_COLOR, 4},
                                  {GL_DEPTH_RANGE, 2},
                                  {GL_DEPTH_TEST, 1},
                                  {GL_DEPTH_WRITEMASK, 1},
                                  {GL_DEPTH_CLEAR_VALUE, 1},
                                  {GL_DEPTH_FUNC, 1},
                                  {GL_STENCIL_TEST, 1},
                                  {GL_STENCIL_CLEAR_VALUE, 1},
                                  {GL_STENCIL_FUNC, 1},
                                  {GL_STENCIL_VALUE_MASK, 1},
                                  {GL_STENCIL_FAIL, 1},
                                  {GL_STENCIL_PASS_DEPTH_FAIL, 1},
                                  {GL_STENCIL_PASS_DEPTH_PASS, 1},
                                  {GL_STENCIL_REF, 1},
                                  {GL_STENCIL_WRITEMASK, 1},
                                  {GL_MATRIX_MODE, 1},
                                  {GL_NORMALIZE, 1},
                                  {GL_VIEWPORT, 4},
                                  {GL_MODELVIEW_STACK_DEPTH, 1},
                                  {GL_PROJECTION_STACK_DEPTH, 1},
                                  {GL_TEXTURE_STACK_DEPTH, 1},
                                  {GL_MODELVIEW_MATRIX, 16},
                                  {GL_PROJECTION_MATRIX, 16},
                                  {GL_TEXTURE_MATRIX, 16},
                                  {GL_ATTRIB_STACK_DEPTH, 1},
                                  {GL_ALPHA_TEST, 1},
                                  {GL_ALPHA_TEST_FUNC, 1},
                                  {GL_ALPHA_TEST_REF, 1},
                                  {GL_BLEND_DST, 1},
                                  {GL_BLEND_SRC, 1},
                                  {GL_BLEND, 1},
                                  {GL_LOGIC_OP_MODE, 1},
                                  {GL_COLOR_LOGIC_OP, 1},
                                  {GL_SCISSOR_BOX, 4},
                                  {GL_SCISSOR_TEST, 1},
                                  {GL_COLOR_CLEAR_VALUE, 4},
                                  {GL_COLOR_WRITEMASK, 4},
                                  {GL_MAP_COLOR, 1},
                                  {GL_MAP_STENCIL, 1},
                                  {GL_INDEX_SHIFT, 1},
                                  {GL_INDEX_OFFSET, 1},
                                  {GL_RED_SCALE, 1},
                                  {GL_RED_BIAS, 1},
                                  {GL_ZOOM_X, 1},
                                  {GL_ZOOM_Y, 1},
                                  {GL_UNPACK_ALIGNMENT, 1},
                                  {GL_UNPACK_ROW_LENGTH, 1},
                                  {GL_PACK_SKIP_PIXELS, 1},
                                  {GL_TEXTURE_1D, 1},
                                  {GL_TEXTURE_2D, 1},
                                  {GL_TEXTURE_BINDING_1D, 1},
                                  {GL_TEXTURE_BINDING_2D, 1},
                                  {GL_TEXTURE_GEN_S, 1},
                                  {GL_TEXTURE_GEN_T, 1},
                                  {GL_AUTO_NORMAL, 1},
                                  {GL_POLYGON_OFFSET_FACTOR, 1},
                                  {GL_POLYGON_OFFSET_UNITS, 1},
                                  {GL_LIST_BASE, 1},
                                  {GL_PIXEL_MAP_I_TO_R_SIZE, 1}};

std::string hexadecimal(GLenum name) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%x", name);
    return text.data();
}

void ask_lights(const Gl& gl, Results& out) {
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
        for (GLenum name = GL_AMBIENT; name <= GL_QUADRATIC_ATTENUATION; ++name) {
            std::array<GLfloat, 4> v{};
            gl.GetLightfv(light, name, v.data());
            out.values.push_back({"light " + hexadecimal(name), {v.begin(), v.end()}, 1e-4});
        }
    for (const GLenum face : {GL_FRONT, GL_BACK})
        for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
            std::array<GLfloat, 4> v{};
            gl.GetMaterialfv(face, name, v.data());
            out.values.push_back({"material " + hexadecimal(name), {v.begin(), v.end()}, 1e-5});
        }
}

void ask_textures(const Gl& gl, Results& out) {
    for (const GLenum coord : {GL_S, GL_T})
        for (const GLenum name : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE}) {
            std::array<GLfloat, 4> v{};
            gl.GetTexGenfv(coord, name, v.data());
            out.values.push_back({"generation " + hexadecimal(name), {v.begin(), v.end()}, 1e-4});
        }
    for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D})
        for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_BORDER_COLOR,
                                  GL_TEXTURE_PRIORITY}) {
            std::array<GLfloat, 4> v{};
            gl.GetTexParameterfv(target, name, v.data());
            out.values.push_back({"parameter " + hexadecimal(name), {v.begin(), v.end()}, 1e-5});
        }
}

}  // namespace

void ask(const Gl& gl, Random&, Results& out) {
    for (const auto& [name, count] : variables) {
        std::array<GLdouble, 16> v{};
        gl.GetDoublev(name, v.data());
        // Of the masks, the bits of the buffer count.
        if (name == GL_STENCIL_VALUE_MASK || name == GL_STENCIL_WRITEMASK)
            v[0] = double(std::uint64_t(v[0]) & 255);
        out.values.push_back(
            {"variable " + hexadecimal(name), {v.begin(), v.begin() + count}, 1e-5});
    }
    for (GLenum plane = GL_CLIP_PLANE0; plane <= GL_CLIP_PLANE5; ++plane) {
        std::array<GLdouble, 4> v{};
        gl.GetClipPlane(plane, v.data());
        out.values.push_back({"plane", {v.begin(), v.end()}, 1e-4});
    }
    GLboolean valid = GL_FALSE;
    gl.GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    if (valid) {
        for (const GLenum name : {GL_CURRENT_RASTER_POSITION, GL_CURRENT_RASTER_COLOR,
                                  GL_CURRENT_RASTER_TEXTURE_COORDS}) {
            std::array<GLfloat, 4> v{};
            gl.GetFloatv(name, v.data());
            out.values.push_back({"raster " + hexadecimal(name), {v.begin(), v.end()}, 0.005});
        }
    }
    ask_lights(gl, out);
    ask_textures(gl, out);
    out.values.push_back({"error", {double(gl.GetError())}});
}

}  // namespace gw::gl_peer
