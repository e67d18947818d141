// Texture coordinates of all units, from calls, arrays, buffers, lists and generation. [GL13] 2.7, 2.8,
// 2.10.4
#include "tests/gl/unit/support/picture.h"
#include "tests/gl/unit/support/window.h"
#include "tests/gl/unit/textures/row_texture.h"

#include <algorithm>
#include <cstddef>

namespace gw::gl {
namespace {

using Coordinates = std::array<GLdouble, 4>;

/// Vertices of separate triangles, with coordinates of units 0, 1 and 3.
struct Corner {
    float position[2], first[2], second[2], fourth[4];
};
std::vector<Corner> corners() {
    std::vector<Corner> out;
    for (int i = 0; i < 48; ++i) {
        const float x = float(i / 3 % 4) * 8, y = float(i / 12) * 8;
        const float dx = i % 3 == 1 ? 8.0f : 0.0f, dy = i % 3 == 2 ? 8.0f : 0.0f;
        const float u = float(i) / 48, q = i % 2 == 0 ? 1.0f : 2.0f;
        out.push_back({{x + dx, y + dy}, {u, 0}, {1 - u, 0.5f}, {u * 3 * q, 0, 0, q}});
    }
    return out;
}
void use_rows_of_texels() {
    std::vector<Pixel> rainbow(8);
    for (std::size_t i = 0; i < rainbow.size(); ++i)
        rainbow[i] = {GLubyte(30 * i), GLubyte(255 - 20 * i), GLubyte(90 + 20 * i), 255};
    use_texture_of(GL_TEXTURE0, rainbow);
    std::reverse(rainbow.begin(), rainbow.end());
    use_texture_of(GL_TEXTURE1, rainbow, GL_ADD);
    std::rotate(rainbow.begin(), rainbow.begin() + 3, rainbow.end());
    use_texture_of(GL_TEXTURE3, rainbow);
}
void send(const Corner& c) {
    glTexCoord2fv(c.first);
    glMultiTexCoord2fv(GL_TEXTURE1, c.second);
    glMultiTexCoord4fv(GL_TEXTURE3, c.fourth);
    glVertex2fv(c.position);
}
void draw_by_calls() {
    use_rows_of_texels();
    glBegin(GL_TRIANGLES);
    for (const Corner& c : corners()) send(c);
    glEnd();
}
/// `base`: where the corners are; null: in the bound buffer.
void set_arrays(const Corner* base) {
    const auto at = [&](std::size_t offset) {
        return reinterpret_cast<const void*>(reinterpret_cast<std::size_t>(base) + offset);
    };
    glVertexPointer(2, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, position)));
    glEnableClientState(GL_VERTEX_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, first)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glClientActiveTexture(GL_TEXTURE3);
    glTexCoordPointer(4, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, fourth)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glClientActiveTexture(GL_TEXTURE1);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, second)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
}

}  // namespace

TEST(GlUnitCoordinates, CallsAndArraysGiveTheSameCoordinates) {
    const std::vector<Corner> all = corners();
    expect_same_picture(draw_by_calls, [&] {
        use_rows_of_texels();
        set_arrays(all.data());
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(all.size()));
    });
    expect_same_picture(draw_by_calls, [&] {
        use_rows_of_texels();
        set_arrays(all.data());
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < int(all.size()); ++i) glArrayElement(i);
        glEnd();
    });
}

TEST(GlUnitCoordinates, SharedVerticesHaveThem) {
    const std::vector<Corner> all = corners();
    std::vector<GLushort> indices;
    for (int i = 0; i < 48; ++i) indices.insert(indices.end(), 2, GLushort(i));  // shared
    const auto draw = [&](bool by_elements) {
        use_rows_of_texels();
        set_arrays(all.data());
        if (by_elements) return glDrawElements(GL_LINES, 96, GL_UNSIGNED_SHORT, indices.data());
        glBegin(GL_LINES);
        for (const GLushort i : indices) glArrayElement(i);
        glEnd();
    };
    std::rotate(indices.begin(), indices.begin() + 1, indices.end());
    expect_same_picture([&] { draw(true); }, [&] { draw(false); });
}

TEST(GlUnitCoordinates, BuffersGiveThem) {
    const std::vector<Corner> all = corners();
    expect_same_picture(draw_by_calls, [&] {
        use_rows_of_texels();
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(all.size() * sizeof(Corner)), all.data(),
                     GL_STATIC_DRAW);
        set_arrays(nullptr);
        GLint name = 0;
        glGetIntegerv(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, &name);
        EXPECT_EQ(GLuint(name), buffer);
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(all.size()));
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        // The last coordinates of unit 3 do not end in the buffer.
        glDrawArrays(GL_TRIANGLES, 1, GLsizei(all.size()));
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    });
}

TEST(GlUnitCoordinates, ListsKeepThem) {
    for (const int count : {6, 48})  // played, and as a mesh
        expect_same_picture(
            [&] {
                use_rows_of_texels();
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < count; ++i) send(corners()[std::size_t(i)]);
                glEnd();
                glRecti(20, 20, 28, 28);
            },
            [&] {
                use_rows_of_texels();
                glNewList(1, GL_COMPILE);
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < count; ++i) send(corners()[std::size_t(i)]);
                glEnd();
                glEndList();
                glMultiTexCoord2f(GL_TEXTURE1, 0.3f, 0);
                glCallList(1);
                const Corner last = corners()[std::size_t(count - 1)];
                glActiveTexture(GL_TEXTURE3);
                Coordinates current{};
                glGetDoublev(GL_CURRENT_TEXTURE_COORDS, current.data());
                EXPECT_EQ(current,
                          (Coordinates{double(last.fourth[0]), 0, 0, double(last.fourth[3])}));
                glRecti(20, 20, 28, 28);
            });
}

TEST(GlUnitCoordinates, ListsTakeTheCurrentCoordinatesOfUnitsThatTheyDoNotGive) {
    const auto draw = [](bool by_list) {
        use_rows_of_texels();
        glMultiTexCoord2f(GL_TEXTURE1, 0.1f, 0);
        if (by_list) glNewList(1, GL_COMPILE);
        glBegin(GL_TRIANGLES);
        for (const Corner& c : corners()) {
            glMultiTexCoord4fv(GL_TEXTURE3, c.fourth);
            glVertex2fv(c.position);
        }
        glEnd();
        if (!by_list) return;
        glEndList();
        glMultiTexCoord2f(GL_TEXTURE1, 0.1f, 0);
        glCallList(1);
    };
    expect_same_picture([&] { draw(false); }, [&] { draw(true); });
}

TEST(GlUnitCoordinates, GenerateAndTransformCoordinatesOnTheirOwn) {
    expect_same_picture(
        [] {
            use_rows_of_texels();
            glBegin(GL_TRIANGLES);
            for (const Corner& c : corners()) {
                glMultiTexCoord2f(GL_TEXTURE0, c.first[0], 0);
                glMultiTexCoord2f(GL_TEXTURE1, c.position[0] / 32 + 0.25f, 0);
                glMultiTexCoord2f(GL_TEXTURE3, c.position[1] / 16, 0);
                glVertex2fv(c.position);
            }
            glEnd();
        },
        [] {
            use_rows_of_texels();
            constexpr GLfloat by_x[] = {1.0f / 32, 0, 0, 0}, by_y[] = {0, 1.0f / 32, 0, 0};
            constexpr GLfloat none[] = {0, 0, 0, 0};
            for (const auto& [unit, plane] :
                 {std::pair(GL_TEXTURE1, by_x), std::pair(GL_TEXTURE3, by_y)}) {
                glActiveTexture(GLenum(unit));
                for (const GLenum coordinate : {GL_S, GL_T}) {
                    glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
                    glTexGenfv(coordinate, GL_OBJECT_PLANE, coordinate == GL_S ? plane : none);
                }
                glEnable(GL_TEXTURE_GEN_S);
                glEnable(GL_TEXTURE_GEN_T);
            }
            glMatrixMode(GL_TEXTURE);
            glScalef(2, 1, 1);  // of unit 3
            glActiveTexture(GL_TEXTURE1);
            glTranslatef(0.25f, 0, 0);
            glActiveTexture(GL_TEXTURE0);
            glMatrixMode(GL_MODELVIEW);
            glBegin(GL_TRIANGLES);
            for (const Corner& c : corners()) {
                glTexCoord2f(c.first[0], 0);
                glVertex2fv(c.position);
            }
            glEnd();
        });
}

}  // namespace gw::gl
