// Buffer objects: what a call reads from or writes to a buffer is what it reads from memory. [GL15]
// 2.9, GL_ARB_pixel_buffer_object
#include "tests/gl/unit/support/picture.h"

#include <cstring>
#include <limits>
#include <numeric>

namespace gw::gl {
namespace {

constexpr GLenum targets[] = {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER,
                              GL_PIXEL_UNPACK_BUFFER};

const GLvoid* offset(std::size_t bytes) { return reinterpret_cast<const GLvoid*>(bytes); }

/// A new buffer with values, left bound.
template <class T>
GLuint buffer_of(GLenum target, const std::vector<T>& values) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    return name;
}

void expect_error(GLenum error, const char* what) { EXPECT_EQ(glGetError(), error) << what; }

struct ArrayVertex {
    GLubyte color[4];
    GLfloat position[2];
};
const std::vector<ArrayVertex> vertices{{{255, 0, 0, 255}, {2, 3}},
                                        {{0, 255, 0, 255}, {28, 5}},
                                        {{0, 0, 255, 255}, {9, 29}},
                                        {{255, 255, 0, 255}, {30, 30}},
                                        {{0, 255, 255, 255}, {3, 20}}};
const std::vector<GLushort> indices{9, 9, 0, 1, 2, 1, 3, 2, 2, 4, 0};

/// Sets the arrays from an address or an offset on.
void set_arrays(std::size_t base) {
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(ArrayVertex),
                   offset(base + offsetof(ArrayVertex, color)));
    glVertexPointer(2, GL_FLOAT, sizeof(ArrayVertex),
                    offset(base + offsetof(ArrayVertex, position)));
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
}
void set_arrays_in_memory() { set_arrays(reinterpret_cast<std::size_t>(vertices.data())); }
/// 16 other bytes stand before them.
GLuint set_arrays_in_buffer() {
    std::vector<GLubyte> bytes(16 + vertices.size() * sizeof(ArrayVertex), 0xCD);
    std::memcpy(&bytes[16], vertices.data(), vertices.size() * sizeof(ArrayVertex));
    const GLuint name = buffer_of(GL_ARRAY_BUFFER, bytes);
    set_arrays(16);
    glBindBuffer(GL_ARRAY_BUFFER, 0);  // the arrays keep it
    return name;
}

/// Index k of those at an address: of memory, or in a buffer.
const GLvoid* index_at(std::size_t address, std::size_t k) {
    return offset(address + k * sizeof(GLushort));
}

struct DrawCase {
    const char* name;
    void (*draw)(std::size_t indices);
};
constexpr DrawCase draws[] = {
    {"DrawArrays", [](std::size_t) { glDrawArrays(GL_TRIANGLE_STRIP, 1, 4); }},
    {"DrawElements",
     [](std::size_t at) { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, index_at(at, 2)); }},
    {"DrawElements of a strip",
     [](std::size_t at) {
         glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_SHORT, index_at(at, 2));
     }},
    {"DrawRangeElements",
     [](std::size_t at) {
         glDrawRangeElements(GL_TRIANGLES, 0, 4, 9, GL_UNSIGNED_SHORT, index_at(at, 2));
     }},
    {"ArrayElement",
     [](std::size_t) {
         glBegin(GL_TRIANGLES);
         for (const GLint i : {0, 1, 2}) glArrayElement(i);
         glEnd();
     }},
    {"MultiDrawArrays",
     [](std::size_t) {
         const std::array<GLint, 3> first{0, 0, 2};
         const std::array<GLsizei, 3> count{3, 0, 3};
         glMultiDrawArrays(GL_TRIANGLES, first.data(), count.data(), 3);
     }},
    {"MultiDrawElements",
     [](std::size_t at) {
         const std::array<GLsizei, 2> count{3, 6};
         const std::array<const GLvoid*, 2> starts{index_at(at, 2), index_at(at, 5)};
         glMultiDrawElements(GL_TRIANGLES, count.data(), GL_UNSIGNED_SHORT, starts.data(), 2);
     }},
};

}  // namespace

TEST(GlBuffers, ArraysAndIndicesInThemDrawWhatMemoryDraws) {
    for (const DrawCase& c : draws) {
        SCOPED_TRACE(c.name);
        const auto from_memory = [&] {
            set_arrays_in_memory();
            c.draw(reinterpret_cast<std::size_t>(indices.data()));
        };
        expect_same_picture(from_memory, [&] {
            set_arrays_in_buffer();
            buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices);
            c.draw(0);
            expect_error(GL_NO_ERROR, c.name);
        });
        expect_same_picture(from_memory, [&] {  // a list keeps the values
            const GLuint buffer = set_arrays_in_buffer();
            buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices);
            glNewList(1, GL_COMPILE);
            c.draw(0);
            glEndList();
            glDeleteBuffers(1, &buffer);
            glCallList(1);
        });
    }
}

TEST(GlBuffers, InterleavedArraysAndSubDataAndMapsWriteThem) {
    const std::vector<GLfloat> values{2, 3, 0, 28, 5, 0, 9, 29, 0};
    const auto from_memory = [&] {
        glInterleavedArrays(GL_V3F, 0, values.data());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    const auto draw = [] {
        glInterleavedArrays(GL_V3F, 0, nullptr);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    expect_same_picture(from_memory, [&] {
        buffer_of(GL_ARRAY_BUFFER, std::vector<GLfloat>(9));
        glBufferSubData(GL_ARRAY_BUFFER, 0, 12, values.data());
        glBufferSubData(GL_ARRAY_BUFFER, 12, 24, &values[3]);
        draw();
    });
    expect_same_picture(from_memory, [&] {
        buffer_of(GL_ARRAY_BUFFER, std::vector<GLfloat>(9));
        void* const mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
        ASSERT_NE(mapped, nullptr);
        std::memcpy(mapped, values.data(), 36);
        EXPECT_EQ(glUnmapBuffer(GL_ARRAY_BUFFER), GL_TRUE);
        draw();
    });
    const Window window;
    buffer_of(GL_ARRAY_BUFFER, values);
    std::array<GLfloat, 2> read{};
    glGetBufferSubData(GL_ARRAY_BUFFER, 12, 8, read.data());
    EXPECT_EQ(read, (std::array<GLfloat, 2>{28, 5}));
}

TEST(GlBuffers, PixelsAreUnpackedFromThemAndPackedIntoThem) {
    std::vector<GLubyte> pixels(8 + 4 * 8 * 8);
    std::iota(pixels.begin(), pixels.end(), GLubyte(3));
    std::vector<GLubyte> bits(32 * 4);
    std::iota(bits.begin(), bits.end(), GLubyte(77));
    const std::array<GLfloat, 4> map{0, 0.9f, 0.2f, 1};
    const auto draw = [&](const GLubyte* image, const GLubyte* stipple, const GLfloat* table) {
        glRasterPos2i(2, 3);
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, table);
        glPixelTransferi(GL_MAP_COLOR, 1);
        glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, image);
        glPixelTransferi(GL_MAP_COLOR, 0);
        glTexImage2D(GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, image);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        glPolygonStipple(stipple);
        glEnable(GL_POLYGON_STIPPLE);
        glBegin(GL_TRIANGLE_FAN);
        for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            glTexCoord2i(x, y);
            glVertex2i(8 + 24 * x, 12 + 20 * y);
        }
        glEnd();
        glBitmap(16, 8, 0, 0, 0, 0, stipple);
    };
    expect_same_picture([&] { draw(&pixels[8], bits.data(), map.data()); },
                        [&] {
                            const std::size_t size = pixels.size();
                            std::vector<GLubyte> all(pixels);
                            all.insert(all.end(), bits.begin(), bits.end());
                            const auto* const table = reinterpret_cast<const GLubyte*>(map.data());
                            all.insert(all.end(), table, table + sizeof map);
                            buffer_of(GL_PIXEL_UNPACK_BUFFER, all);
                            draw(static_cast<const GLubyte*>(offset(8)),
                                 static_cast<const GLubyte*>(offset(size)),
                                 static_cast<const GLfloat*>(offset(size + bits.size())));
                            expect_error(GL_NO_ERROR, "from a buffer");
                        });
    Window window;
    use_pixel_coordinates(window);
    draw(&pixels[8], bits.data(), map.data());
    const auto read = [&](auto call, std::size_t size) {
        std::vector<GLubyte> in_memory(size, 0xEE), in_buffer(size);
        call(in_memory.data());
        buffer_of(GL_PIXEL_PACK_BUFFER, std::vector<GLubyte>(16 + size, 0xEE));
        call(static_cast<GLubyte*>(const_cast<GLvoid*>(offset(16))));
        glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 16, GLsizeiptr(size), in_buffer.data());
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        expect_error(GL_NO_ERROR, "into a buffer");
        EXPECT_EQ(in_memory, in_buffer);
        EXPECT_NE(in_memory, std::vector<GLubyte>(size, 0xEE));
    };
    read([](GLubyte* at) { glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, at); }, 4096);
    read([](GLubyte* at) { glReadPixels(0, 0, 32, 32, GL_RGB, GL_FLOAT, at); }, 32 * 32 * 12);
    read([](GLubyte* at) { glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, at); }, 256);
    read([](GLubyte* at) { glGetPolygonStipple(at); }, 128);
    read([](GLubyte* at) { glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, reinterpret_cast<GLfloat*>(at)); },
         16);
}

/// A call that does not fit its buffer is an error and changes nothing; no memory is touched.
TEST(GlBuffers, WhatDoesNotFitABufferIsInvalidOperation) {
    Window window;
    use_pixel_coordinates(window);
    glTexImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const std::vector<GLubyte> bytes(1000, 0xFF);
    const auto far = std::numeric_limits<std::size_t>::max() - 15;
    const auto before = picture_of(window);
    const GLuint pixels = buffer_of(GL_PIXEL_UNPACK_BUFFER, bytes);
    for (const std::size_t at : {std::size_t(1000), std::size_t(800), far}) {
        glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, offset(at));
        expect_error(GL_INVALID_OPERATION, "DrawPixels");
        glTexImage2D(GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, offset(at));
        expect_error(GL_INVALID_OPERATION, "TexImage2D");
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 256, static_cast<const GLfloat*>(offset(at)));
        expect_error(GL_INVALID_OPERATION, "PixelMapfv");
        glPolygonStipple(static_cast<const GLubyte*>(offset(at + 100)));
        expect_error(at == far ? GL_NO_ERROR : GL_INVALID_OPERATION, "PolygonStipple");
    }
    GLint width = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 4);
    glDrawPixels(2, 2, GL_RGBA, GL_FLOAT, offset(2));
    expect_error(GL_INVALID_OPERATION, "an offset that is no multiple of the component");
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, pixels);
    glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    expect_error(GL_INVALID_OPERATION, "ReadPixels");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);

    set_arrays_in_buffer();
    glDrawArrays(GL_TRIANGLES, 3, 3);
    expect_error(GL_INVALID_OPERATION, "DrawArrays");
    glDrawArrays(GL_TRIANGLES, std::numeric_limits<GLint>::max() - 3, 3);
    expect_error(GL_INVALID_OPERATION, "DrawArrays");
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, indices.data());
    expect_error(GL_INVALID_OPERATION, "DrawElements");
    const std::array<GLuint, 3> large{0, 1, 0xFFFFFFFF};
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, large.data());
    expect_error(GL_INVALID_OPERATION, "DrawElements");
    buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices);
    glDrawElements(GL_TRIANGLES, 12, GL_UNSIGNED_SHORT, nullptr);
    expect_error(GL_INVALID_OPERATION, "indices");
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, offset(far));
    expect_error(GL_INVALID_OPERATION, "indices");
    EXPECT_EQ(picture_of(window), before);
}

TEST(GlBuffers, MappedOnesAreNotDrawnFrom) {
    Window window;
    use_pixel_coordinates(window);
    const auto before = picture_of(window);
    const GLuint arrays = set_arrays_in_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, arrays);
    const void* const mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    void* pointer = nullptr;
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, mapped);
    EXPECT_EQ(glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY), nullptr);
    expect_error(GL_INVALID_OPERATION, "a second map");
    glBufferSubData(GL_ARRAY_BUFFER, 0, 4, vertices.data());
    expect_error(GL_INVALID_OPERATION, "BufferSubData");
    glDrawArrays(GL_TRIANGLES, 0, 3);
    expect_error(GL_INVALID_OPERATION, "DrawArrays");
    EXPECT_EQ(picture_of(window), before);
    GLint is_mapped = 0;
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED, &is_mapped);
    EXPECT_EQ(is_mapped, GL_TRUE);
    EXPECT_EQ(glUnmapBuffer(GL_ARRAY_BUFFER), GL_TRUE);
    EXPECT_EQ(glUnmapBuffer(GL_ARRAY_BUFFER), GL_FALSE);
    expect_error(GL_INVALID_OPERATION, "a second unmap");
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_NE(picture_of(window), before);
}

TEST(GlBuffers, WrongCallsAreErrors) {
    const Window window;
    for (const GLenum target : targets) {
        GLint value = 0;
        glBufferData(target, 4, nullptr, GL_STATIC_DRAW);
        expect_error(GL_INVALID_OPERATION, "no buffer");
        EXPECT_EQ(glMapBuffer(target, GL_READ_ONLY), nullptr);
        expect_error(GL_INVALID_OPERATION, "no buffer");
        buffer_of(target, std::vector<GLubyte>(8));
        glBufferData(target, -1, nullptr, GL_STATIC_DRAW);
        expect_error(GL_INVALID_VALUE, "a negative size");
        glBufferData(target, std::numeric_limits<GLsizeiptr>::max(), nullptr, GL_STATIC_DRAW);
        expect_error(GL_OUT_OF_MEMORY, "more than there is");
        glBufferData(target, 4, nullptr, GL_RED);
        expect_error(GL_INVALID_ENUM, "usage");
        for (const auto& [at, size] : {std::pair(-1, 4), {0, 9}, {8, 1}, {4, -1}}) {
            glBufferSubData(target, at, size, &value);
            expect_error(GL_INVALID_VALUE, "a part outside");
            glGetBufferSubData(target, at, size, &value);
            expect_error(GL_INVALID_VALUE, "a part outside");
        }
        glMapBuffer(target, GL_RED);
        expect_error(GL_INVALID_ENUM, "access");
        glGetBufferParameteriv(target, GL_BUFFER_SIZE, &value);
        EXPECT_EQ(value, 8);
        glGetBufferParameteriv(target, GL_RED, &value);
        expect_error(GL_INVALID_ENUM, "parameter");
        glBindBuffer(target, 0);
    }
    glBindBuffer(GL_RED, 0);
    expect_error(GL_INVALID_ENUM, "target");
    GLuint name = 0;
    glGenBuffers(-1, &name);
    expect_error(GL_INVALID_VALUE, "a negative number");
    const GLsizei count = 1;
    const GLint first = 0;
    glMultiDrawArrays(GL_TRIANGLES, &first, &count, -1);
    expect_error(GL_INVALID_VALUE, "a negative number");
}

TEST(GlBuffers, SeveralPrimitivesOfWhichOneIsWrongAreNotDrawn) {
    const Window window;
    set_arrays_in_memory();
    const auto before = window.pixels();
    const std::array<GLint, 2> first{0, 0};
    const std::array<GLsizei, 2> count{3, -1};
    glMultiDrawArrays(GL_TRIANGLES, first.data(), count.data(), 2);
    expect_error(GL_INVALID_VALUE, "a negative count");
    const std::array<const GLvoid*, 2> starts{indices.data(), indices.data()};
    glMultiDrawElements(GL_TRIANGLES, count.data(), GL_UNSIGNED_SHORT, starts.data(), 2);
    expect_error(GL_INVALID_VALUE, "a negative count");
    EXPECT_EQ(window.pixels(), before);
}

TEST(GlBuffers, NamesLiveAsTheirObjectsDo) {
    const Window window;
    GLuint name = 0;
    glGenBuffers(1, &name);
    EXPECT_EQ(glIsBuffer(name), GL_FALSE);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    EXPECT_EQ(glIsBuffer(name), GL_TRUE);
    const std::pair<GLenum, GLenum> bindings[] = {
        {GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
        {GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING},
        {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
        {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING}};
    const auto bound = [](GLenum query) {
        GLint value = -1;
        glGetIntegerv(query, &value);
        return GLuint(value);
    };
    for (const auto& [target, query] : bindings) {
        glBindBuffer(target, name);
        EXPECT_EQ(bound(query), name);
    }
    set_arrays(0);
    EXPECT_EQ(bound(GL_VERTEX_ARRAY_BUFFER_BINDING), name);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    for (const auto& [target, query] : bindings) glBindBuffer(target, 0);
    glPopClientAttrib();
    for (const auto& [target, query] : bindings) EXPECT_EQ(bound(query), name);
    glDeleteBuffers(1, &name);
    EXPECT_EQ(glIsBuffer(name), GL_FALSE);
    for (const auto& [target, query] : bindings) EXPECT_EQ(bound(query), 0u);
    EXPECT_EQ(bound(GL_VERTEX_ARRAY_BUFFER_BINDING), 0u);
    glDrawArrays(GL_TRIANGLES, 0, 3);  // the arrays are nowhere
    expect_error(GL_NO_ERROR, "no arrays");
}

TEST(GlBuffers, ContextsShareThem) {
    const Window window;
    const GLuint name = buffer_of(GL_ARRAY_BUFFER, std::vector<GLubyte>{1, 2, 3});
    Context other(opengl(), window.context.shared);
    make_current(&other, nullptr);
    EXPECT_EQ(glIsBuffer(name), GL_TRUE);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name);
    GLubyte second = 0;
    glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 1, 1, &second);
    EXPECT_EQ(second, 2);
    glDeleteBuffers(1, &name);
    make_current(nullptr, nullptr);
}

}  // namespace gw::gl
