// Parts of images that are replaced between draws. [GL11] 3.8.2
#include "gl/drawable/frame_log.h"

#include "tests/gl/unit/support/window.h"
#include "tests/gw/random.h"

#include <algorithm>

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;

void set_filters(GLint min_filter, GLint mag_filter) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag_filter);
}

void bind(GLuint texture, GLint min_filter = GL_NEAREST, GLint mag_filter = GL_NEAREST) {
    glBindTexture(GL_TEXTURE_2D, texture);
    set_filters(min_filter, mag_filter);
}

/// Images of one colour, of all levels down to 1 x 1.
void set_images(int side, const Color& color) {
    const std::vector<Color> texels(std::size_t(side) * std::size_t(side), color);
    for (int level = 0; side >> level > 0; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, side >> level, side >> level, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, texels.data());
}

void set_part(const Rect& rect, const Color& color, GLint level = 0) {
    const std::vector<Color> texels(rect.area(), color);
    glTexSubImage2D(GL_TEXTURE_2D, level, rect.x, rect.y, rect.width, rect.height, GL_RGBA,
                    GL_UNSIGNED_BYTE, texels.data());
}

/// The bound texture over a rectangle of pixels.
void draw(const Rect& r) {
    glBegin(GL_QUADS);
    const auto corner = [&](int s, int t) {
        glTexCoord2i(s, t);
        glVertex2i(r.x + s * r.width, r.y + t * r.height);
    };
    corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1);
    glEnd();
}

void begin(const Window& window) {
    use_pixel_coordinates(window);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

constexpr Color red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255};

/// An image that changes part by part, or is given as a whole after each part.
class Changing {
public:
    Changing(test::Random& random, int width, int height)
        : random_(random), width_(width), texels_(std::size_t(width * height)) {
        for (Color& texel : texels_) texel = any_color();
    }
    void set_image(GLint level, GLint format) const {
        glTexImage2D(GL_TEXTURE_2D, level, format, width_, height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     texels_.data());
    }
    void set_part(GLint level, GLint format, bool whole) {
        const int x = int(random_.between(0, width_ - 1)),
                  y = int(random_.between(0, height() - 1));
        const int w = int(random_.between(1, width_ - x)),
                  h = int(random_.between(1, height() - y));
        std::vector<Color> part(std::size_t(w * h));
        for (Color& texel : part) texel = any_color();
        for (int row = 0; row < h; ++row)
            std::copy_n(&part[std::size_t(row * w)], w,
                        &texels_[std::size_t((y + row) * width_ + x)]);
        if (whole)
            set_image(level, format);
        else
            glTexSubImage2D(GL_TEXTURE_2D, level, x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE,
                            part.data());
    }

private:
    int height() const { return int(texels_.size()) / width_; }
    Color any_color() {
        return {GLubyte(random_.next()), GLubyte(random_.next()), GLubyte(random_.next()),
                GLubyte(random_.next())};
    }

    test::Random& random_;
    int width_;
    std::vector<Color> texels_;
};

/// The frames of a program that changes a texture between its draws.
std::vector<std::vector<Color>> frames(const Profile& profile, std::uint64_t seed, bool whole) {
    test::Random random(seed);
    const Window window(32, 32, profile);
    begin(window);
    const GLint formats[] = {GL_RGBA,  GL_RGB,      GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                             GL_ALPHA, GL_INTENSITY};
    const GLint mags[] = {GL_NEAREST, GL_LINEAR};
    const GLint mins[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR};
    const GLint format = formats[random.between(0, 5)];
    const int log2_width = int(random.between(0, 5)), log2_height = int(random.between(0, 5));
    std::vector<Changing> levels;
    for (int i = 0; i <= std::max(log2_width, log2_height); ++i) {
        levels.emplace_back(random, std::max(1, 1 << log2_width >> i),
                            std::max(1, 1 << log2_height >> i));
        levels.back().set_image(i, format);
    }
    std::vector<std::vector<Color>> out;
    for (int frame = 0; frame < 8; ++frame) {
        for (auto draws = random.between(1, 3); draws > 0; --draws) {
            set_filters(mins[random.between(0, 3)], mags[random.between(0, 1)]);
            for (auto parts = random.between(0, 3); parts > 0; --parts) {
                const auto level = std::size_t(random.between(0, std::int64_t(levels.size()) - 1));
                levels[level].set_part(GLint(level), format, whole);
            }
            const int size = random.one_in(2) ? 5 : 24;
            draw({int(random.between(0, 8)), int(random.between(0, 8)), size, size});
        }
        out.push_back(window.pixels());
    }
    return out;
}

/// Counts why frames were executed, while it lives.
class Causes {
public:
    Causes() {
        counts() = {};
        set_frame_log(std::make_unique<Counter>());
    }
    ~Causes() { set_frame_log(nullptr); }
    int operator[](Cause cause) const { return counts()[std::size_t(cause)]; }

private:
    static std::array<int, cause_count>& counts() {
        static std::array<int, cause_count> all;
        return all;
    }
    struct Counter final : FrameLog {
        void open(Drawable&) override {}
        void begin_frame(Drawable&) override {}
        void executed(Drawable&, const Execution& e) override { ++counts()[std::size_t(e.cause)]; }
        void end_frame(Drawable&) override {}
        void close(Drawable&) override {}
    };
};

const std::uint16_t* texels_of(const Window& window, std::size_t level = 0) {
    return bound_texture(window.context, two_dimensions).levels[level].texels.data();
}

}  // namespace

TEST(GlTextureParts, HaveTheBitsOfWholeImages) {
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        const Profile profile = seed % 6 == 0 ? vgx() : opengl();
        ASSERT_EQ(frames(profile, seed, false), frames(profile, seed, true));
    }
}

/// Each draw sees the parts before it. 32: the texels are copied; 512: the frame is executed.
TEST(GlTextureParts, DoNotReachEarlierDrawsOfTheFrame) {
    for (const int side : {32, 512}) {
        const Window window;
        begin(window);
        bind(1);
        set_images(side, red);
        const int part = side / 4;
        for (int i = 0; i < 4; ++i) {
            draw({8 * i, 0, 4, 4});
            set_part({part * i, 0, part, part}, green);
            draw({8 * i, 8, 4, 4});
        }
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                EXPECT_EQ(window.pixel(8 * i + k, 0), k < i ? green : red) << side << ' ' << i;
                EXPECT_EQ(window.pixel(8 * i + k, 8), k <= i ? green : red) << side << ' ' << i;
            }
        EXPECT_EQ(window.pixel(1, 9), red) << side;
    }
}

TEST(GlTextureParts, LevelsAreReplacedByThemselves) {
    const Window window;
    begin(window);
    bind(1, GL_NEAREST_MIPMAP_NEAREST);
    set_images(32, red);
    set_part({0, 0, 8, 8}, green, 2);
    set_part({31, 31, 1, 1}, blue);
    draw({0, 0, 8, 8});
    EXPECT_EQ(window.pixel(0, 0), green);
    EXPECT_EQ(window.pixel(7, 7), green);
    glClear(GL_COLOR_BUFFER_BIT);
    draw({0, 0, 32, 32});
    EXPECT_EQ(window.pixel(7, 7), red);
    EXPECT_EQ(window.pixel(31, 31), blue);
}

/// A filter beyond a repeated texture's right side sees its left one.
TEST(GlTextureParts, AtASideReachTheOtherSide) {
    const Window window;
    begin(window);
    bind(1, GL_LINEAR, GL_LINEAR);
    set_images(4, red);
    draw({0, 0, 32, 32});
    EXPECT_EQ(window.pixel(31, 16), red);
    set_part({0, 0, 1, 4}, green);
    draw({0, 0, 32, 32});
    EXPECT_GT(window.pixel(31, 16)[1], 100);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    draw({0, 0, 32, 32});
    EXPECT_EQ(window.pixel(31, 16), red);
}

TEST(GlTextureParts, ADeletedTextureStaysInItsFrame) {
    const Window window;
    begin(window);
    bind(1);
    set_images(512, red);
    draw({0, 0, 8, 8});
    set_part({0, 0, 512, 256}, green);
    draw({8, 0, 8, 8});
    const GLuint name = 1;
    glDeleteTextures(1, &name);
    bind(1);
    set_images(512, blue);
    draw({16, 0, 8, 8});
    EXPECT_EQ(window.pixel(4, 2), red);
    EXPECT_EQ(window.pixel(12, 2), green);
    EXPECT_EQ(window.pixel(12, 6), red);
    EXPECT_EQ(window.pixel(20, 2), blue);
}

TEST(GlTextureParts, ComeFromTheFrameThatDrawsWithTheTexture) {
    for (const int side : {16, 512}) {
        const Window window;
        begin(window);
        bind(1);
        set_images(side, red);
        draw({0, 0, 16, 16});
        glDisable(GL_TEXTURE_2D);
        glColor3ub(0, 255, 0);
        glRecti(0, 0, 4, 4);
        glEnable(GL_TEXTURE_2D);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, side - 4, side - 4, 0, 0, 4, 4);
        draw({16, 16, 16, 16});
        EXPECT_EQ(window.pixel(2, 2), green);
        EXPECT_EQ(window.pixel(31, 31), side == 16 ? green : red);
        draw({0, 0, 16, 16});
        EXPECT_EQ(window.pixel(2, 2), red);
        std::vector<Color> texels(std::size_t(side) * std::size_t(side));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        EXPECT_EQ(texels.back(), green);
        EXPECT_EQ(texels.front(), red);
    }
}

/// No texel is copied if no frame needs the old ones.
TEST(GlTextureParts, AreReplacedInPlace) {
    const Window window;
    begin(window);
    bind(1, GL_LINEAR_MIPMAP_LINEAR);
    set_images(64, red);
    for (int i = 0; i < 3; ++i) {
        draw({0, 0, 8, 8});
        glFinish();
        const std::uint16_t *const first = texels_of(window), *const second = texels_of(window, 1);
        set_part({i, 0, 1, 1}, green);
        EXPECT_EQ(texels_of(window), first);
        draw({0, 0, 8, 8});
        set_part({i, 1, 1, 1}, green);
        EXPECT_NE(texels_of(window), first) << "the frame has its texels";
        EXPECT_EQ(texels_of(window, 1), second) << "the level did not change";
    }
}

/// Many texels that the frame needs are not copied for a few; the frame is executed instead.
TEST(GlTextureParts, OfLargeTexturesEndTheFrame) {
    const Causes causes;
    {
        const Window window;
        begin(window);
        bind(1);
        set_images(256, red);
        draw({0, 0, 8, 8});
        set_part({0, 0, 1, 1}, green);
        EXPECT_EQ(causes[Cause::Texture], 0);
        set_images(512, red);
        set_part({0, 0, 1, 1}, green);
        EXPECT_EQ(causes[Cause::Texture], 0) << "nothing is drawn with it";
        draw({0, 0, 8, 8});
        const std::uint16_t* const texels = texels_of(window);
        set_part({0, 0, 1, 1}, blue);
        EXPECT_EQ(causes[Cause::Texture], 1);
        EXPECT_EQ(texels_of(window), texels);
        set_part({1, 1, 1, 1}, blue);
        EXPECT_EQ(causes[Cause::Texture], 1);
        draw({0, 0, 8, 8});
        set_part({0, 0, 512, 129}, green);
        EXPECT_EQ(causes[Cause::Texture], 1) << "the part is not small";
    }
}

}  // namespace gw::gl
