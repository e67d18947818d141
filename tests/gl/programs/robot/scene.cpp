#include "tests/gl/programs/robot/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace robot {

namespace {

void expect_complete(const char* what) {
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail(what);
}

GLuint attached_renderbuffer(GLenum format, GLenum point, int samples, const Options& o) {
    GLuint name = 0;
    gl.GenRenderbuffers(1, &name);
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    if (samples > 0)
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, o.width, o.height);
    else
        gl.RenderbufferStorage(GL_RENDERBUFFER, format, o.width, o.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
    return name;
}

GLuint picture_framebuffer(int samples, const Options& options) {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    attached_renderbuffer(GL_RGBA8, GL_COLOR_ATTACHMENT0, samples, options);
    const bool has_floats = has_extension("GL_ARB_depth_buffer_float");
    attached_renderbuffer(has_floats ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8,
                          GL_DEPTH_STENCIL_ATTACHMENT, samples, options);
    expect_complete("framebuffer");
    GLint given = 0;
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
    if (given < samples) fail("GL_RENDERBUFFER_SAMPLES");
    return name;
}

void make_framebuffers(Scene& s) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &most);
    s.framebuffer = picture_framebuffer(std::min(s.options.samples, int(most)), s.options);
    s.resolved = picture_framebuffer(0, s.options);
    gl.GenFramebuffers(1, &s.shadow_framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, s.shadow_framebuffer);
    gl.GenTextures(1, &s.shadow_texture);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, s.shadow_texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, s.options.shadow, s.options.shadow, 0,
                  GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q})
        gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, s.shadow_texture,
                            0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    expect_complete("shadow framebuffer");
    gl.ActiveTexture(GL_TEXTURE0);
}

std::vector<GLubyte> checkers(int size, int field, GLubyte tint) {
    std::vector<GLubyte> out;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool light = (x / field + y / field) % 2 == 0;
            out.insert(out.end(), {GLubyte(light ? 200 : 90), GLubyte(light ? 190 : 110),
                                   GLubyte(tint + y * 100 / size)});
        }
    return out;
}

void filter_linearly(GLenum target, GLint wrap) {
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_R, wrap);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.GenerateMipmap(target);
}

void make_textures(Scene& s) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.GenTextures(1, &s.floor_texture);
    gl.BindTexture(GL_TEXTURE_2D, s.floor_texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 300, 300, 0, GL_RGB, GL_UNSIGNED_BYTE,
                  checkers(300, 150, 100).data());
    filter_linearly(GL_TEXTURE_2D, GL_REPEAT);
    gl.GenTextures(1, &s.sky_texture);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, s.sky_texture);
    for (GLenum face = 0; face < 6; ++face)
        gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, s.options.sky,
                      s.options.sky, 0, GL_RGB, GL_UNSIGNED_BYTE,
                      checkers(s.options.sky, s.options.sky / 4, GLubyte(20 * face)).data());
    filter_linearly(GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
    if (has_extension("GL_ARB_seamless_cube_map")) gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void floor_quads() {
    constexpr int count = 200;
    const auto at = [](int i) { return 40.0 * i / count - 20; };
    gl.Begin(GL_QUADS);
    gl.Normal3f(0, 0, 1);
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            gl.Vertex3d(at(x), at(y), 0);
            gl.Vertex3d(at(x + 1), at(y), 0);
            gl.Vertex3d(at(x + 1), at(y + 1), 0);
            gl.Vertex3d(at(x), at(y + 1), 0);
        }
    gl.End();
}

/// Of radius 1, with its poles on z.
void sphere_quads(int slices, int stacks) {
    const auto vertex = [&](int i, int j) {
        const double longitude = 6.283185307179586 * i / slices;
        const double latitude = 3.141592653589793 * (double(j) / stacks - 0.5);
        const auto x = float(std::cos(longitude) * std::cos(latitude)),
                   y = float(std::sin(longitude) * std::cos(latitude)),
                   z = float(std::sin(latitude));
        gl.Normal3f(x, y, z);
        gl.TexCoord2f(float(i) / float(slices), float(j) / float(stacks));
        gl.Vertex3f(x, y, z);
    };
    gl.Begin(GL_QUADS);
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            vertex(i, j);
            vertex(i + 1, j);
            vertex(i + 1, j + 1);
            vertex(i, j + 1);
        }
    gl.End();
}

/// A tube around the scene; its top is `top`.
void tube(float radius, float bottom, float top, bool fades) {
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 32; ++i)
        for (int corner = 0; corner < 4; ++corner) {
            const bool upper = corner >= 2;
            const double angle = 6.283185307179586 * (i + (corner == 1 || corner == 2)) / 32;
            if (fades) gl.Color4f(0.8f, 0.85f, 0.9f, upper ? 0.0f : 1.0f);
            gl.Vertex3f(radius * float(std::cos(angle)), radius * float(std::sin(angle)),
                        upper ? top : bottom);
        }
    gl.End();
}

template <class Draw>
void compile(GLuint list, Draw draw) {
    gl.NewList(list, GL_COMPILE);
    draw();
    gl.EndList();
}

void make_lists(Scene& s) {
    s.lists = gl.GenLists(list_count);
    if (s.lists == 0) fail("glGenLists");
    compile(s.lists + floor_list, floor_quads);
    compile(s.lists + sphere_list, [] { sphere_quads(28, 16); });
    compile(s.lists + sky_list, [] { tube(18, -15, 15, false); });
    compile(s.lists + haze_list, [] { tube(17, -0.5f, 3, true); });
}

/// A wavy cloth: positions, normals, texture coordinates, indices.
void make_skin(Scene& s) {
    constexpr int side = 24;
    std::vector<GLfloat> positions, normals, coordinates;
    std::vector<GLuint> indices;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = 6.0 * x / (side - 1), slope = -0.18 * std::sin(u);
            const double length = std::sqrt(1 + slope * slope);
            positions.insert(positions.end(), {float(u / 3 - 1), float(y) / 12 - 1,
                                               float(1.5 + 0.18 * std::cos(u) / 2)});
            normals.insert(normals.end(), {float(-slope / length), 0, float(1 / length)});
            coordinates.insert(coordinates.end(), {float(x) / side, float(y) / side});
            const auto at = GLuint(y * side + x);
            if (x + 1 < side && y + 1 < side)
                indices.insert(indices.end(),
                               {at, at + 1, at + side + 1, at, at + side + 1, at + side});
        }
    s.skin_indices = int(indices.size());
    gl.GenBuffers(4, s.skin.data());
    const auto store = [&](GLenum target, GLuint name, const auto& values, GLenum usage) {
        gl.BindBuffer(target, name);
        gl.BufferData(target, GLsizeiptr(values.size() * sizeof(values[0])), values.data(), usage);
    };
    store(GL_ARRAY_BUFFER, s.skin[0], positions, GL_STREAM_DRAW);
    store(GL_ARRAY_BUFFER, s.skin[1], normals, GL_STREAM_DRAW);
    store(GL_ARRAY_BUFFER, s.skin[2], coordinates, GL_STATIC_DRAW);
    store(GL_ELEMENT_ARRAY_BUFFER, s.skin[3], indices, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

}  // namespace

void open_scene(Scene& s, const std::string& door) {
    open_door(door);
    load_functions();
    s.zero_to_one = gl.ClipControl != nullptr && has_extension("GL_ARB_clip_control");
    const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE && status != GL_FRAMEBUFFER_UNDEFINED)
        fail("Default framebuffer is not complete");
    make_framebuffers(s);
    make_textures(s);
    make_lists(s);
    make_skin(s);
}

void draw_skin(const Scene& s) {
    gl.BindBuffer(GL_ARRAY_BUFFER, s.skin[0]);
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.BindBuffer(GL_ARRAY_BUFFER, s.skin[1]);
    gl.NormalPointer(GL_FLOAT, 0, nullptr);
    gl.BindBuffer(GL_ARRAY_BUFFER, s.skin[2]);
    gl.TexCoordPointer(2, GL_FLOAT, 0, nullptr);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.skin[3]);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
        gl.EnableClientState(array);
    gl.DrawElements(GL_TRIANGLES, s.skin_indices, GL_UNSIGNED_INT, nullptr);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
        gl.DisableClientState(array);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

}  // namespace robot
