// Vertex arrays give what immediate mode gives. [GL11] 2.8
#include "tests/gl/unit/support/picture.h"
#include "tests/gl/unit/support/snapshot.h"

#include "gl/entry/entry_points.h"

#include <cstring>
#include <limits>

namespace gw::gl {
namespace {

/// The bytes of elements of `size` components of type T, `stride` bytes apart (0: packed).
template <class T>
std::vector<GLubyte> elements(const std::vector<std::vector<double>>& values, std::size_t stride) {
    const std::size_t size = values[0].size() * sizeof(T);
    const std::size_t step = stride != 0 ? stride : size;
    std::vector<GLubyte> out(step * values.size(), 0xCD);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t k = 0; k < values[i].size(); ++k) {
            const T value = static_cast<T>(values[i][k]);
            std::memcpy(&out[step * i + k * sizeof(T)], &value, sizeof value);
        }
    return out;
}

/// Positions of two triangles with 2 to 4 components; whole numbers.
std::vector<std::vector<double>> positions(int size) {
    std::vector<std::vector<double>> out{{2, 3, 0, 1},   {28, 5, 0, 1},  {9, 29, 0, 1},
                                         {20, 50, 0, 2}, {60, 60, 0, 2}, {4, 60, 0, 2}};
    for (auto& v : out) v.resize(std::size_t(size));
    return out;
}
void send(const std::vector<double>& v) {
    if (v.size() == 2) glVertex2d(v[0], v[1]);
    if (v.size() == 3) glVertex3d(v[0], v[1], v[2]);
    if (v.size() == 4) glVertex4d(v[0], v[1], v[2], v[3]);
}

template <class T>
void expect_positions(GLenum type) {
    for (int size = 2; size <= 4; ++size)
        for (const std::size_t stride : {std::size_t(0), sizeof(T) * 4, sizeof(T) * 5 + 3}) {
            const auto values = positions(size);
            const auto memory = elements<T>(values, stride);
            expect_same_picture(
                [&] {
                    glBegin(GL_TRIANGLES);
                    for (const auto& v : values) send(v);
                    glEnd();
                },
                [&] {
                    glVertexPointer(size, type, GLsizei(stride), memory.data());
                    glEnableClientState(GL_VERTEX_ARRAY);
                    glDrawArrays(GL_TRIANGLES, 0, 6);
                });
        }
}

/// The current value after ArrayElement(1) equals that of immediate mode.
template <class Immediate, class Pointer>
void expect_current(GLenum name, GLenum array, Immediate immediate, Pointer pointer) {
    const Window window;
    std::array<double, 4> expected{}, got{};
    immediate();
    glGetDoublev(name, expected.data());
    glPushAttrib(GL_CURRENT_BIT);
    glColor4f(0, 0, 0, 0);
    glNormal3f(0, 0, 0);
    glTexCoord4f(9, 9, 9, 9);
    pointer();
    glEnableClientState(array);
    glArrayElement(1);
    glGetDoublev(name, got.data());
    EXPECT_EQ(got, expected);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

template <class T, class Three, class Four>
void expect_colors(GLenum type, Three three, Four four) {
    const T low = std::numeric_limits<T>::lowest(), high = std::numeric_limits<T>::max();
    const bool is_float = std::is_floating_point_v<T>;
    const T a = is_float ? T(0.25) : low, b = is_float ? T(0.5) : high, c = T(high / 3 * !is_float);
    const std::array<T, 12> memory{c, c, c, c, c, a, b, c, b, a, c, b};
    expect_current(
        GL_CURRENT_COLOR, GL_COLOR_ARRAY, [&] { three(memory[5], memory[6], memory[7]); },
        [&] { glColorPointer(3, type, 5 * sizeof(T), memory.data()); });
    expect_current(
        GL_CURRENT_COLOR, GL_COLOR_ARRAY, [&] { four(memory[4], memory[5], memory[6], memory[7]); },
        [&] { glColorPointer(4, type, 0, memory.data()); });
}

template <class T, class Normal>
void expect_normals(GLenum type, Normal normal) {
    const std::array<T, 8> memory{1, 2, 3, 100, -5, 17, 0, 0};
    expect_current(
        GL_CURRENT_NORMAL, GL_NORMAL_ARRAY, [&] { normal(T(100), T(-5), T(17)); },
        [&] { glNormalPointer(type, 0, memory.data()); });
}

template <class T>
void expect_texcoords(GLenum type) {
    const std::array<T, 8> memory{1, 2, 3, 4, 5, 6, 7, 8};
    for (int size = 1; size <= 4; ++size) {
        std::array<double, 4> v{0, 0, 0, 1};
        for (int k = 0; k < size; ++k) v[std::size_t(k)] = double(memory[std::size_t(4 + k)]);
        expect_current(
            GL_CURRENT_TEXTURE_COORDS, GL_TEXTURE_COORD_ARRAY, [&] { glTexCoord4dv(v.data()); },
            [&] { glTexCoordPointer(size, type, 4 * sizeof(T), memory.data()); });
    }
}

template <class Index>
void expect_elements(GLenum type) {
    const auto values = positions(2);
    const auto memory = elements<float>(values, 0);
    const std::vector<Index> indices{5, 0, 3, 3, 1, 4, 2, 0, 1};
    expect_same_picture(
        [&] {
            glBegin(GL_TRIANGLE_STRIP);
            for (const Index i : indices) send(values[i]);
            glEnd();
        },
        [&] {
            glVertexPointer(2, GL_FLOAT, 0, memory.data());
            glEnableClientState(GL_VERTEX_ARRAY);
            glDrawElements(GL_TRIANGLE_STRIP, GLsizei(indices.size()), type, indices.data());
        });
}

}  // namespace

TEST(GlArrays, PositionsOfEveryTypeSizeAndStride) {
    expect_positions<GLshort>(GL_SHORT);
    expect_positions<GLint>(GL_INT);
    expect_positions<GLfloat>(GL_FLOAT);
    expect_positions<GLdouble>(GL_DOUBLE);
}

TEST(GlArrays, ColorsOfEveryTypeAndSize) {
    expect_colors<GLbyte>(GL_BYTE, glColor3b, glColor4b);
    expect_colors<GLubyte>(GL_UNSIGNED_BYTE, glColor3ub, glColor4ub);
    expect_colors<GLshort>(GL_SHORT, glColor3s, glColor4s);
    expect_colors<GLushort>(GL_UNSIGNED_SHORT, glColor3us, glColor4us);
    expect_colors<GLint>(GL_INT, glColor3i, glColor4i);
    expect_colors<GLuint>(GL_UNSIGNED_INT, glColor3ui, glColor4ui);
    expect_colors<GLfloat>(GL_FLOAT, glColor3f, glColor4f);
    expect_colors<GLdouble>(GL_DOUBLE, glColor3d, glColor4d);
}

TEST(GlArrays, NormalsOfEveryType) {
    expect_normals<GLbyte>(GL_BYTE, glNormal3b);
    expect_normals<GLshort>(GL_SHORT, glNormal3s);
    expect_normals<GLint>(GL_INT, glNormal3i);
    expect_normals<GLfloat>(GL_FLOAT, glNormal3f);
    expect_normals<GLdouble>(GL_DOUBLE, glNormal3d);
}

TEST(GlArrays, TextureCoordinatesOfEveryTypeAndSize) {
    expect_texcoords<GLshort>(GL_SHORT);
    expect_texcoords<GLint>(GL_INT);
    expect_texcoords<GLfloat>(GL_FLOAT);
    expect_texcoords<GLdouble>(GL_DOUBLE);
}

TEST(GlArrays, IndicesOfEveryType) {
    expect_elements<GLubyte>(GL_UNSIGNED_BYTE);
    expect_elements<GLushort>(GL_UNSIGNED_SHORT);
    expect_elements<GLuint>(GL_UNSIGNED_INT);
}

TEST(GlArrays, ArrayElementInsideBegin) {
    const auto values = positions(3);
    const auto memory = elements<double>(values, 0);
    expect_same_picture(
        [&] {
            glBegin(GL_LINE_LOOP);
            for (const int i : {4, 2, 0}) send(values[std::size_t(i)]);
            glEnd();
        },
        [&] {
            glVertexPointer(3, GL_DOUBLE, 0, memory.data());
            glEnableClientState(GL_VERTEX_ARRAY);
            glBegin(GL_LINE_LOOP);
            for (const int i : {4, 2, 0}) glArrayElement(i);
            glEnd();
        });
}

TEST(GlArrays, WithoutAVertexArrayNothingIsDrawn) {
    const std::array<float, 9> colors{1, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_EQ(drawn([&] {
                  glColorPointer(3, GL_FLOAT, 0, colors.data());
                  glEnableClientState(GL_COLOR_ARRAY);
                  glDrawArrays(GL_TRIANGLES, 0, 3);
                  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
              }),
              blank());
}

TEST(GlArrays, InterleavedFormatsSetWhatTheTableSays) {
    const Window window;
    struct Format {
        GLenum name;
        int texcoord, color, vertex;  ///< sizes
        bool normal;
        int stride;
    };
    // [GL11] table 2.5, with f = 4 and c = 4 bytes.
    constexpr Format formats[] = {{GL_V2F, 0, 0, 2, false, 8},
                                  {GL_V3F, 0, 0, 3, false, 12},
                                  {GL_C4UB_V2F, 0, 4, 2, false, 12},
                                  {GL_C4UB_V3F, 0, 4, 3, false, 16},
                                  {GL_C3F_V3F, 0, 3, 3, false, 24},
                                  {GL_N3F_V3F, 0, 0, 3, true, 24},
                                  {GL_C4F_N3F_V3F, 0, 4, 3, true, 40},
                                  {GL_T2F_V3F, 2, 0, 3, false, 20},
                                  {GL_T4F_V4F, 4, 0, 4, false, 32},
                                  {GL_T2F_C4UB_V3F, 2, 4, 3, false, 24},
                                  {GL_T2F_C3F_V3F, 2, 3, 3, false, 32},
                                  {GL_T2F_N3F_V3F, 2, 0, 3, true, 32},
                                  {GL_T2F_C4F_N3F_V3F, 2, 4, 3, true, 48},
                                  {GL_T4F_C4F_N3F_V4F, 4, 4, 4, true, 60}};
    const GLubyte memory[64] = {};
    for (const Format& f : formats) {
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
        glEnableClientState(GL_INDEX_ARRAY);
        glInterleavedArrays(f.name, 0, memory);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        EXPECT_FALSE(glIsEnabled(GL_EDGE_FLAG_ARRAY));
        EXPECT_FALSE(glIsEnabled(GL_INDEX_ARRAY));
        EXPECT_EQ(glIsEnabled(GL_TEXTURE_COORD_ARRAY), f.texcoord > 0);
        EXPECT_EQ(glIsEnabled(GL_COLOR_ARRAY), f.color > 0);
        EXPECT_EQ(glIsEnabled(GL_NORMAL_ARRAY), f.normal);
        EXPECT_TRUE(glIsEnabled(GL_VERTEX_ARRAY));
        GLint value = 0;
        glGetIntegerv(GL_VERTEX_ARRAY_STRIDE, &value);
        EXPECT_EQ(value, f.stride) << f.name;
        glGetIntegerv(GL_VERTEX_ARRAY_SIZE, &value);
        EXPECT_EQ(value, f.vertex);
        GLvoid* pointer = nullptr;
        glGetPointerv(GL_VERTEX_ARRAY_POINTER, &pointer);
        EXPECT_EQ(static_cast<GLubyte*>(pointer) - memory, f.stride - 4 * f.vertex);
    }
    glInterleavedArrays(GL_RGBA, 0, memory);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glInterleavedArrays(GL_V2F, -1, memory);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

/// [GL11] 2.8 leaves them open. Programs count on what other implementations do.
TEST(GlArrays, ADrawLeavesTheCurrentValuesAlone) {
    const Window window;
    const std::array<GLfloat, 12> memory{0, 1, 0, 0, 1, 0, 1, 0, 0, 0.5f, 0.5f, 0};
    const std::array<GLubyte, 2> indices{0, 1};
    glVertexPointer(2, GL_FLOAT, 0, memory.data());
    glNormalPointer(GL_FLOAT, 0, memory.data());
    glColorPointer(4, GL_FLOAT, 0, memory.data());
    glTexCoordPointer(2, GL_FLOAT, 0, memory.data());
    for (const GLenum array :
         {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
        glEnableClientState(array);
    const auto values = [] {
        std::array<GLfloat, 12> out{};
        glGetFloatv(GL_CURRENT_NORMAL, out.data());
        glGetFloatv(GL_CURRENT_COLOR, out.data() + 3);
        glGetFloatv(GL_CURRENT_TEXTURE_COORDS, out.data() + 7);
        return out;
    };
    const auto initial = values();
    glDrawArrays(GL_LINES, 0, 2);
    EXPECT_EQ(values(), initial);
    glDrawElements(GL_LINES, 2, GL_UNSIGNED_BYTE, indices.data());
    EXPECT_EQ(values(), initial);
    const std::array<GLubyte, 4> shared{0, 1, 1, 0};
    glDrawElements(GL_LINES, 4, GL_UNSIGNED_BYTE, shared.data());
    EXPECT_EQ(values(), initial);
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glDrawArrays(GL_LINES, 0, 2);
    glEndList();
    EXPECT_EQ(values(), initial);
    glCallList(1);
    EXPECT_EQ(values(), initial);
    glBegin(GL_LINES);
    glArrayElement(1);
    glEnd();
    EXPECT_NE(values(), initial);
}

TEST(GlArrays, ARangeOfElementsDrawsAsElements) {
    const std::array<GLfloat, 8> corners{2, 3, 28, 5, 9, 29, 30, 30};
    const std::array<GLushort, 6> indices{0, 1, 2, 1, 3, 2};
    const auto with_corners = [&](const auto& draw) {
        return [&] {
            glVertexPointer(2, GL_FLOAT, 0, corners.data());
            glEnableClientState(GL_VERTEX_ARRAY);
            draw();
        };
    };
    const auto elements = [&] { glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, &indices[0]); };
    const auto range = [&] {
        glDrawRangeElements(GL_TRIANGLES, 0, 3, 6, GL_UNSIGNED_SHORT, &indices[0]);
    };
    expect_same_picture(with_corners(elements), with_corners(range));
}

/// GL_EXT_compiled_vertex_array: a promise of the program's, which the pictures do not show.
TEST(GlArrays, LockedOnesDrawAsOthers) {
    const auto lock =
        reinterpret_cast<void(GLAPIENTRY*)(GLint, GLsizei)>(find_entry_point("glLockArraysEXT"));
    const auto unlock =
        reinterpret_cast<void(GLAPIENTRY*)()>(find_entry_point("glUnlockArraysEXT"));
    ASSERT_TRUE(lock != nullptr && unlock != nullptr);
    const auto locked = [] {
        std::array<GLint, 2> out{};
        glGetIntegerv(GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, &out[0]);
        glGetIntegerv(GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, &out[1]);
        return out;
    };
    const auto bytes = elements<GLfloat>(positions(2), 0);
    const auto draw = [&] {
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_FLOAT, 0, bytes.data());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    expect_same_picture(
        [&] {
            lock(1, 5);
            EXPECT_EQ(locked(), (std::array{1, 5}));
            draw();
            unlock();
            EXPECT_EQ(locked(), (std::array{0, 0}));
        },
        draw);

    const Window window;
    unlock();
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    for (const auto& [first, count] : {std::pair{-1, 3}, {0, 0}, {0, -2}}) {
        lock(first, count);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE)) << first << ' ' << count;
    }
    lock(0, 3);
    lock(0, 6);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(locked(), (std::array{0, 3}));
}

TEST(GlArrays, WrongArgumentsAreErrors) {
    const Window window;
    const auto expect = [](GLenum error) { EXPECT_EQ(glGetError(), error); };
    for (const int size : {1, 5})
        glVertexPointer(size, GL_FLOAT, 0, nullptr), expect(GL_INVALID_VALUE);
    for (const int size : {2, 5})
        glColorPointer(size, GL_FLOAT, 0, nullptr), expect(GL_INVALID_VALUE);
    for (const int size : {0, 5})
        glTexCoordPointer(size, GL_FLOAT, 0, nullptr), expect(GL_INVALID_VALUE);
    glVertexPointer(2, GL_UNSIGNED_BYTE, 0, nullptr), expect(GL_INVALID_ENUM);
    glNormalPointer(GL_UNSIGNED_SHORT, 0, nullptr), expect(GL_INVALID_ENUM);
    glIndexPointer(GL_BYTE, 0, nullptr), expect(GL_INVALID_ENUM);
    glEdgeFlagPointer(-1, nullptr), expect(GL_INVALID_VALUE);
    glDrawArrays(GL_POLYGON + 1, 0, 3), expect(GL_INVALID_ENUM);
    glDrawArrays(GL_POINTS, 0, -1), expect(GL_INVALID_VALUE);
    glDrawElements(GL_POINTS, -1, GL_UNSIGNED_INT, nullptr), expect(GL_INVALID_VALUE);
    glDrawElements(GL_POINTS, 1, GL_INT, nullptr), expect(GL_INVALID_ENUM);
    glDrawRangeElements(GL_POINTS, 2, 1, 0, GL_UNSIGNED_INT, nullptr), expect(GL_INVALID_VALUE);
    glEnableClientState(GL_BLEND), expect(GL_INVALID_ENUM);
}

}  // namespace gw::gl
