// Textures of three dimensions and cubes. [GL12] 3.8.1, 3.8.2, [GL13] 2.10.4, 3.8
#include "tests/gl/unit/support/window.h"

#include <algorithm>

namespace gw::gl {
namespace {

using Pixel = std::array<GLubyte, 4>;

void expect_error(GLenum error, const char* what) { EXPECT_EQ(glGetError(), error) << what; }

void use_nearest_of(GLenum target) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(target);
}

std::vector<GLubyte> some_bytes(int count) {
    std::vector<GLubyte> out;
    for (int i = 0; i < count; ++i) out.push_back(GLubyte(i * 37 + i / 7));
    return out;
}

std::vector<GLubyte> bytes_of_volume(std::size_t count, GLint level = 0) {
    std::vector<GLubyte> out(count);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_3D, level, GL_RGB, GL_UNSIGNED_BYTE, out.data());
    return out;
}

GLint value_of_level(GLenum target, GLenum name, GLint level = 0) {
    GLint value = -1;
    glGetTexLevelParameteriv(target, level, name, &value);
    return value;
}

/// The pixel of a look-up at s, t, r.
Pixel looked_up(const Window& window, GLfloat s, GLfloat t, GLfloat r) {
    glTexCoord3f(s, t, r);
    glRectf(-1, -1, 1, 1);
    return window.pixel(1, 1);
}

constexpr GLenum first_face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
constexpr Pixel face_colors[6] = {{250, 0, 0, 255}, {0, 250, 0, 255},  {0, 0, 250, 255},
                                  {90, 9, 9, 255},  {9, 90, 200, 255}, {70, 60, 50, 255}};
void set_face(int face, int side = 2, GLint format = GL_RGBA, GLint level = 0) {
    const std::vector<Pixel> texels(std::size_t(side * side), face_colors[face]);
    glTexImage2D(first_face + GLenum(face), level, format, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
}
void use_cube() {
    for (int face = 0; face < 6; ++face) set_face(face);
    use_nearest_of(GL_TEXTURE_CUBE_MAP);
}

}  // namespace

TEST(GlVolumes, ComeBackFromTheirMemory) {
    const Window window;
    const std::vector<GLubyte> bytes = some_bytes(3 * 3 * 2 * 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB8, 3, 2, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    expect_error(GL_NO_ERROR, "TexImage3D");
    EXPECT_EQ(bytes_of_volume(bytes.size()), bytes);
    EXPECT_EQ(value_of_level(GL_TEXTURE_3D, GL_TEXTURE_WIDTH), 3);
    EXPECT_EQ(value_of_level(GL_TEXTURE_3D, GL_TEXTURE_HEIGHT), 2);
    EXPECT_EQ(value_of_level(GL_TEXTURE_3D, GL_TEXTURE_DEPTH), 4);
}

TEST(GlVolumes, AreLaidOutByImageHeightAndSkippedImages) {
    const Window window;
    // 2 x 2 x 2 texels: images of 5 rows of 3 pixels, one image, one row and one pixel skipped.
    const std::vector<GLubyte> memory = some_bytes(3 * 3 * 5 * 3);
    std::vector<GLubyte> expected;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int i = 0; i < 6; ++i)
                expected.push_back(memory[std::size_t(((z + 1) * 5 + y + 1) * 9 + 3 + i)]);
    const auto lay_out = [](GLenum rows, GLenum images, GLenum skip_images, GLenum skip_rows,
                            GLenum skip_pixels, bool on) {
        glPixelStorei(rows, on ? 3 : 0);
        glPixelStorei(images, on ? 5 : 0);
        for (const GLenum skip : {skip_images, skip_rows, skip_pixels}) glPixelStorei(skip, on);
    };
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    lay_out(GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES,
            GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, true);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 2, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, memory.data());
    EXPECT_EQ(bytes_of_volume(24), expected);
    lay_out(GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_SKIP_ROWS,
            GL_PACK_SKIP_PIXELS, true);
    std::vector<GLubyte> packed(memory.size(), 7);
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RGB, GL_UNSIGNED_BYTE, packed.data());
    std::vector<GLubyte> wanted(memory.size(), 7);
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            std::copy_n(&memory[std::size_t(((z + 1) * 5 + y + 1) * 9 + 3)], 6,
                        &wanted[std::size_t(((z + 1) * 5 + y + 1) * 9 + 3)]);
    EXPECT_EQ(packed, wanted);
    expect_error(GL_NO_ERROR, "layouts");
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, -1);
    expect_error(GL_INVALID_VALUE, "image height -1");
}

TEST(GlVolumes, ArePartlyReplacedAndCopied) {
    const Window window(8, 8);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<GLubyte> bytes = some_bytes(3 * 4 * 4 * 4);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 4, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    const std::vector<GLubyte> part = some_bytes(3 * 2 * 3 * 2);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 1, 0, 2, 2, 3, 2, GL_RGB, GL_UNSIGNED_BYTE, part.data());
    const auto at = [](int x, int y, int z) { return std::size_t(3 * (x + 4 * (y + 4 * z))); };
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 3; ++y)
            std::copy_n(&part[std::size_t(6 * (y + 3 * z))], 6, &bytes[at(1, y, 2 + z)]);
    EXPECT_EQ(bytes_of_volume(bytes.size()), bytes);
    glColor3ub(9, 8, 7);
    glRectf(-1, -1, 1, 1);
    glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 2, 1, 1, 0, 0, 2, 2);
    for (int y = 1; y < 3; ++y)
        for (int x = 2; x < 4; ++x) std::ranges::copy(std::array{9, 8, 7}, &bytes[at(x, y, 1)]);
    EXPECT_EQ(bytes_of_volume(bytes.size()), bytes);
    expect_error(GL_NO_ERROR, "parts");
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 3, 2, 3, 2, GL_RGB, GL_UNSIGNED_BYTE, part.data());
    expect_error(GL_INVALID_VALUE, "two slices from the last on");
    glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 4, 0, 0, 1, 1);
    expect_error(GL_INVALID_VALUE, "slice 4");
    glTexSubImage3D(GL_TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, part.data());
    expect_error(GL_INVALID_ENUM, "two dimensions");
    glTexSubImage3D(GL_TEXTURE_3D, 1, 0, 0, 0, 1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, part.data());
    expect_error(GL_INVALID_OPERATION, "no level 1");
}

TEST(GlVolumes, AreLookedUpByR) {
    const Window window(4, 4);
    std::vector<Pixel> slices;
    for (int z = 0; z < 4; ++z) slices.push_back({GLubyte(60 * z), GLubyte(255 - z), 7, 255});
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, slices.data());
    use_nearest_of(GL_TEXTURE_3D);
    const auto expect = [&](GLenum wrap, GLfloat r, const Pixel& expected) {
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GLint(wrap));
        EXPECT_EQ(looked_up(window, 0.5f, 0.5f, r), expected) << wrap << " at " << r;
    };
    for (int z = 0; z < 4; ++z) expect(GL_REPEAT, (float(z) + 0.5f) / 4, slices[std::size_t(z)]);
    expect(GL_REPEAT, 1.125f, slices[0]);
    expect(GL_MIRRORED_REPEAT, 1.125f, slices[3]);
    expect(GL_CLAMP_TO_EDGE, -2, slices[0]);
    constexpr GLfloat border[] = {1, 0, 1, 1};
    glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, border);
    expect(GL_CLAMP_TO_BORDER, 1.5f, {255, 0, 255, 255});
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_MODULATE);
    expect_error(GL_INVALID_ENUM, "a wrap that is none");
    GLint wrap = 0;
    glGetTexParameteriv(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, &wrap);
    EXPECT_EQ(wrap, GL_CLAMP_TO_BORDER);
}

TEST(GlVolumes, HaveLevelsHalvedInDepth) {
    const Window window(4, 4);
    std::vector<Pixel> texels(8 * 4 * 2, Pixel{100, 0, 0, 255});
    std::fill(texels.begin() + 32, texels.end(), Pixel{200, 0, 0, 255});
    glTexParameteri(GL_TEXTURE_3D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 8, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    for (int level = 1; level < 4; ++level) {
        EXPECT_EQ(value_of_level(GL_TEXTURE_3D, GL_TEXTURE_WIDTH, level), 8 >> level);
        EXPECT_EQ(value_of_level(GL_TEXTURE_3D, GL_TEXTURE_DEPTH, level), 1);
        EXPECT_EQ(bytes_of_volume(24, level)[0], 150);
    }
    use_nearest_of(GL_TEXTURE_3D);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    EXPECT_EQ(looked_up(window, 0, 0, 0.25f)[0], 100);  // magnified
    glTexImage3D(GL_TEXTURE_3D, 2, GL_RGB, 2, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(looked_up(window, 0, 0, 0.25f), (Pixel{255, 255, 255, 255})) << "not complete";
}

TEST(GlVolumes, HaveTheErrorsOfTheSpecification) {
    const Window window;
    const auto image = [](GLenum target, GLint level, GLint format, GLsizei width, GLsizei height,
                          GLsizei depth, GLint border = 0) {
        glTexImage3D(target, level, format, width, height, depth, border, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
    };
    GLint largest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
    EXPECT_GE(largest, 16);
    image(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 1);
    expect_error(GL_INVALID_ENUM, "two dimensions");
    glTexImage2D(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    expect_error(GL_INVALID_ENUM, "three dimensions by TexImage2D");
    image(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, -1);
    expect_error(GL_INVALID_VALUE, "depth -1");
    image(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, largest + 1);
    expect_error(GL_INVALID_VALUE, "too deep");
    image(GL_TEXTURE_3D, -1, GL_RGBA, 1, 1, 1);
    expect_error(GL_INVALID_VALUE, "level -1");
    image(GL_TEXTURE_3D, 0, GL_RGBA, 3, 3, 3, 2);
    expect_error(GL_INVALID_VALUE, "border 2");
    image(GL_TEXTURE_3D, 0, 0x1234, 1, 1, 1);
    expect_error(GL_INVALID_VALUE, "no format");
    image(GL_PROXY_TEXTURE_3D, 0, GL_RGBA, 4, 4, largest + 1);
    EXPECT_EQ(value_of_level(GL_PROXY_TEXTURE_3D, GL_TEXTURE_WIDTH), 0);
    image(GL_PROXY_TEXTURE_3D, 0, GL_RGBA, 4, 2, 8);
    EXPECT_EQ(value_of_level(GL_PROXY_TEXTURE_3D, GL_TEXTURE_DEPTH), 8);
    glCopyTexSubImage3D(GL_PROXY_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 1, 1);
    expect_error(GL_INVALID_ENUM, "a copy to a proxy");
    glCompressedTexImage3D(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 1, 0, 8,
                           nullptr);
    expect_error(GL_INVALID_ENUM, "blocks of three dimensions");
}

TEST(GlCubes, AreLookedUpByTheLargestCoordinate) {
    const Window window(4, 4);
    use_cube();
    expect_error(GL_NO_ERROR, "a cube");
    for (int face = 0; face < 6; ++face) {
        float direction[3] = {0.25f, -0.5f, 0.375f};
        direction[face / 2] = face % 2 == 0 ? 2.0f : -2.0f;
        EXPECT_EQ(looked_up(window, direction[0], direction[1], direction[2]), face_colors[face]);
    }
    // Texel (1, 0) of +x: s_c = -z, t_c = -y. [GL13] table 3.19
    constexpr Pixel other{1, 2, 3, 255};
    glTexSubImage2D(first_face, 0, 1, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, other.data());
    EXPECT_EQ(looked_up(window, 1, 0.5f, -0.5f), other);
    EXPECT_EQ(looked_up(window, 1, 0.5f, 0.5f), face_colors[0]);
    EXPECT_EQ(looked_up(window, 1, -0.5f, -0.5f), face_colors[0]);
}

TEST(GlCubes, AreOffUntilTheyHaveSixEqualFaces) {
    const Window window(4, 4);
    constexpr Pixel white{255, 255, 255, 255};
    for (int face = 0; face < 6; ++face) {
        use_nearest_of(GL_TEXTURE_CUBE_MAP);
        EXPECT_EQ(looked_up(window, 1, 0, 0), white) << face << " faces";
        set_face(face);
    }
    EXPECT_EQ(looked_up(window, 1, 0, 0), face_colors[0]);
    set_face(3, 4);
    EXPECT_EQ(looked_up(window, 1, 0, 0), white) << "another size";
    set_face(3, 2, GL_RGB);
    EXPECT_EQ(looked_up(window, 1, 0, 0), white) << "another format";
    set_face(3);
    EXPECT_EQ(looked_up(window, 1, 0, 0), face_colors[0]);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    EXPECT_EQ(looked_up(window, 1, 0, 0), white) << "no level 1";
    for (int face = 0; face < 6; ++face) set_face(face, 1, GL_RGBA, 1);
    EXPECT_EQ(looked_up(window, 1, 0, 0), face_colors[0]);
}

TEST(GlCubes, ComeBeforeThreeTwoAndOneDimensions) {
    const Window window(4, 4);
    constexpr Pixel colors[] = {{1, 1, 1, 255}, {2, 2, 2, 255}, {3, 3, 3, 255}};
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors[0].data());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors[1].data());
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 colors[2].data());
    for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D})
        use_nearest_of(target);
    use_cube();
    EXPECT_EQ(looked_up(window, 1, 0, 0), face_colors[0]);
    glDisable(GL_TEXTURE_CUBE_MAP);
    EXPECT_EQ(looked_up(window, 1, 0, 0), colors[2]);
    glDisable(GL_TEXTURE_3D);
    EXPECT_EQ(looked_up(window, 1, 0, 0), colors[1]);
    glDisable(GL_TEXTURE_2D);
    EXPECT_EQ(looked_up(window, 1, 0, 0), colors[0]);
}

TEST(GlCubes, HaveTheErrorsOfTheSpecification) {
    const Window window;
    const auto image = [](GLenum target, GLsizei width, GLsizei height) {
        glTexImage2D(target, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    };
    for (int face = 0; face < 6; ++face) {
        image(first_face + GLenum(face), 4, 2);
        expect_error(GL_INVALID_VALUE, "no square");
    }
    image(GL_TEXTURE_CUBE_MAP, 4, 4);
    expect_error(GL_INVALID_ENUM, "an image of all faces");
    image(first_face + 7, 4, 4);
    expect_error(GL_INVALID_ENUM, "no face");
    glBindTexture(first_face, 1);
    expect_error(GL_INVALID_ENUM, "a face is bound");
    glEnable(first_face);
    expect_error(GL_INVALID_ENUM, "a face is enabled");
    glTexParameteri(first_face, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    expect_error(GL_INVALID_ENUM, "a face's parameter");
    EXPECT_EQ(value_of_level(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WIDTH), -1);
    expect_error(GL_INVALID_ENUM, "a level of all faces");
    image(GL_PROXY_TEXTURE_CUBE_MAP, 8, 8);
    EXPECT_EQ(value_of_level(GL_PROXY_TEXTURE_CUBE_MAP, GL_TEXTURE_WIDTH), 8);
    GLint largest = 0;
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    EXPECT_GE(largest, 16);
    image(GL_PROXY_TEXTURE_CUBE_MAP, 2 * largest, 2 * largest);
    EXPECT_EQ(value_of_level(GL_PROXY_TEXTURE_CUBE_MAP, GL_TEXTURE_WIDTH), 0);
    expect_error(GL_NO_ERROR, "proxies");
    glTexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    expect_error(GL_INVALID_ENUM, "reflections of q");
    glBindTexture(GL_TEXTURE_CUBE_MAP, 5);
    glBindTexture(GL_TEXTURE_2D, 5);
    expect_error(GL_INVALID_OPERATION, "a cube as two dimensions");
}

TEST(GlCubes, FacesAreCopiedAndMakeTheirLevels) {
    const Window window(4, 4);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_TRUE);
    for (int face = 0; face < 6; ++face) {
        glColor4ubv(face_colors[face].data());
        glRectf(-1, -1, 1, 1);
        glCopyTexImage2D(first_face + GLenum(face), 0, GL_RGBA, 0, 0, 4, 4, 0);
    }
    expect_error(GL_NO_ERROR, "copies");
    for (int face = 0; face < 6; ++face) {
        Pixel texel{};
        glGetTexImage(first_face + GLenum(face), 2, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
        EXPECT_EQ(texel, face_colors[face]);
    }
    use_nearest_of(GL_TEXTURE_CUBE_MAP);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    EXPECT_EQ(looked_up(window, 0, 0, -3), face_colors[5]);
    glColor3ub(1, 2, 3);
    glDisable(GL_TEXTURE_CUBE_MAP);
    glRectf(-1, -1, 1, 1);
    glEnable(GL_TEXTURE_CUBE_MAP);
    glCopyTexSubImage2D(first_face + 5, 0, 0, 0, 0, 0, 4, 4);
    EXPECT_EQ(looked_up(window, 0, 0, -3), (Pixel{1, 2, 3, 255}));
}

TEST(GlCubes, ReflectAndTakeNormals) {
    const Window window(4, 4);
    use_cube();
    for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);
        glEnable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
    }
    for (int face = 0; face < 6; ++face) {
        float normal[3] = {0.1f, 0.2f, -0.1f};
        normal[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
        glNormal3fv(normal);
        glRectf(-1, -1, 1, 1);
        EXPECT_EQ(window.pixel(1, 1), face_colors[face]);
    }
    // The eye looks along -z at a mirror that leans by 45 degrees: it sees +x.
    for (const GLenum coordinate : {GL_S, GL_T, GL_R})
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    glNormal3f(1, 0, 1);
    glTranslatef(0, 0, -100);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1, 1, -1, 1, 50, 200);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(window.pixel(1, 1), face_colors[0]);
    glNormal3f(0, 0, 1);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(window.pixel(1, 1), face_colors[4]) << "back to the eye";
}

TEST(GlCubes, SeamlessFiltersReachOverTheirEdges) {
    const Window window(4, 4);
    use_cube();
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, filter, GL_LINEAR);
    const auto red = [&] { return int(looked_up(window, 1, 0, 0.984375f)[0]); };
    EXPECT_EQ(red(), 250);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS));
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    // 2 texels: s = 1/128, so 1/64 - 1/2 texels: weights 31/64 and 33/64 of +z (9) and +x (250).
    EXPECT_EQ(red(), (250 * 33 + 9 * 31 + 32) / 64);
}

}  // namespace gw::gl
