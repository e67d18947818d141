// The machine's textures that texture objects become.
#include "gl/drawable/frame_log.h"
#include "tests/gl/unit/support/window.h"

namespace gw::gl {

TEST(GlMachineTextures, ParametersMakeNoOther) {
    const Window window;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    TextureObject& object = bound_texture(window.context, two_dimensions);
    const auto made = [&] { return machine_texture(object, 1, opengl()); };
    const TextureRef first = made();
    ASSERT_TRUE(first);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glPushAttrib(GL_TEXTURE_BIT);
    glPopAttrib();
    EXPECT_EQ(made(), first);
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_NE(made(), first);
}

/// [GL11] 3.8.8: a filter without levels needs the first one only. It samples the same texture.
TEST(GlMachineTextures, FiltersWithAndWithoutLevelsShareOne) {
    const Window window;
    TextureObject& object = bound_texture(window.context, two_dimensions);
    const auto made = [&](GLint filter) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        return machine_texture(object, 1, opengl());
    };
    EXPECT_FALSE(made(GL_NEAREST));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const TextureRef one = made(GL_LINEAR);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->levels.size(), 1u);
    EXPECT_FALSE(made(GL_LINEAR_MIPMAP_LINEAR));
    EXPECT_EQ(made(GL_NEAREST), one);

    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const TextureRef both = made(GL_NEAREST);
    ASSERT_TRUE(both);
    EXPECT_EQ(both->levels.size(), 2u);
    EXPECT_EQ(made(GL_NEAREST_MIPMAP_NEAREST), both);
    EXPECT_EQ(made(GL_LINEAR), both);
}

/// A frame keeps the textures that its commands draw with, those too that were replaced since.
TEST(GlMachineTextures, AFrameOfManyIsExecutedInParts) {
    static int full = 0;
    struct Counter final : FrameLog {
        void open(Drawable&) override {}
        void begin_frame(Drawable&) override {}
        void executed(Drawable&, const Execution& e) override { full += e.cause == Cause::Full; }
        void end_frame(Drawable&) override {}
        void close(Drawable&) override {}
    };
    set_frame_log(std::make_unique<Counter>());
    {
        const Window window;
        constexpr int side = 1024;  // 8 MB
        const std::vector<GLubyte> texels(side * side, 255);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        for (int i = 0; i < 70; ++i) {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, side, side, 0, GL_LUMINANCE,
                         GL_UNSIGNED_BYTE, texels.data());
            EXPECT_EQ(full, i / 32) << i;
            glEnable(GL_TEXTURE_2D);
            glRecti(-1, -1, 1, 1);
            glDisable(GL_TEXTURE_2D);
        }
    }
    set_frame_log(nullptr);
}

}  // namespace gw::gl
