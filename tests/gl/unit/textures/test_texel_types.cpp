// Texels of every format and type without pixel transfer. [GL11] 3.6.4, 3.8.1
#include "tests/gl/unit/support/window.h"

#include <limits>
#include <random>

namespace gw::gl {

TEST(GlTextures, TexelsWithoutTransferAreThoseOfATransferThatChangesNothing) {
    const Window window;
    constexpr int side = 256;  // every number of 16 bits, in a format of one component
    std::vector<std::uint32_t> noise(side * side * 4);
    std::mt19937 random(1991);
    for (std::uint32_t& word : noise) word = random();
    std::vector<GLushort> numbers(side * side * 4);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = GLushort(i);
    std::vector<GLfloat> floats(side * side * 4);
    for (GLfloat& v : floats) v = GLfloat(random() % 65536) / 32768 - 0.5f;
    floats[0] = std::numeric_limits<GLfloat>::quiet_NaN();
    floats[1] = std::numeric_limits<GLfloat>::infinity();
    floats[2] = 0.5f / 65535;  // between two numbers
    const auto memory = [&](GLenum type) -> const void* {
        if (type == GL_UNSIGNED_SHORT || type == GL_SHORT) return numbers.data();
        return type == GL_FLOAT ? static_cast<const void*>(floats.data()) : noise.data();
    };
    const auto texels = [&](GLenum format, GLenum type, GLfloat alpha_bias) {
        glPixelTransferf(GL_ALPHA_BIAS, alpha_bias);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, side, side, 0, format, type, memory(type));
        std::vector<GLushort> out(side * side * 4);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, out.data());
        return out;
    };
    for (const GLenum type : {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT,
                              GL_UNSIGNED_INT, GL_FLOAT})
        for (const GLenum format : {GL_RGBA, GL_BGRA, GL_ABGR_EXT, GL_RGB, GL_BGR, GL_LUMINANCE,
                                    GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RED})
            EXPECT_TRUE(texels(format, type, 0) == texels(format, type, 1e-30f))
                << std::hex << format << " " << type;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace gw::gl
