// Lists whose runs are assembled once, under every state that their meshes depend on.
#include "gl/drawable/frame_log.h"
#include "tests/gl/unit/support/picture.h"
#include "tests/gl/unit/support/snapshot.h"

#include <cmath>

namespace gw::gl {
namespace {

/// The values that a list gives: bits of these.
enum Gives : unsigned { Colors = 1, Normals = 2, Texcoords = 4, EdgeFlags = 8 };

/// Two runs of so many vertices.
void runs(GLenum mode, unsigned gives, int count = 24) {
    for (int run = 0; run < 2; ++run) {
        glBegin(mode);
        for (int i = 0; i < count; ++i) {
            const float a = float(i) * 0.9f, r = 3 + float(i) / 2;
            if (gives & Colors) glColor4f(float(i % 3) / 2, float(i % 5) / 4, float(run), 0.75f);
            if (gives & Normals) glNormal3f(std::cos(a), std::sin(a), 0.5f);
            if (gives & Texcoords) glTexCoord2f(float(i) / 7, float(i % 4) / 3);
            if (gives & EdgeFlags) glEdgeFlag(i % 4 != 1);
            glVertex3f(16 + r * std::cos(a + float(run)), 16 + r * std::sin(a), float(i % 7) / 8);
        }
        glEnd();
    }
}

/// 6 x 6 quads, whose neighbours have the same values at their common corners.
void grid(unsigned gives) {
    constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    glBegin(GL_QUADS);
    for (int i = 0; i < 36; ++i)
        for (const auto& corner : corners) {
            const int x = i % 6 + corner[0], y = i / 6 + corner[1];
            if (gives & Colors) glColor4f(float(x % 3) / 2, float(y % 5) / 4, 0.5f, 0.75f);
            if (gives & Normals) glNormal3f(float(x - 3) / 3, float(y - 3) / 3, 0.5f);
            if (gives & Texcoords) glTexCoord2f(float(x) / 4, float(y) / 3);
            if (gives & EdgeFlags) glEdgeFlag((x + y) % 3 != 1);
            glVertex3f(3 + 4 * float(x) + float(y) / 2, 3 + 4 * float(y), float(x * y % 7) / 8);
        }
    glEnd();
}

/// State that is on: bits in this order.
constexpr int state_bits = 9;
void set_state(unsigned on) {
    if (on & 1) {
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
    }
    if (on & 2) glEnable(GL_COLOR_MATERIAL);
    if (on & 4) {
        std::array<GLubyte, 48> image{};
        for (std::size_t i = 0; i < image.size(); ++i) image[i] = GLubyte(i * 53);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, image.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glEnable(GL_TEXTURE_2D);
    }
    if (on & 8) {
        glEnable(GL_TEXTURE_GEN_S);
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    }
    if (on & 16) {
        glEnable(GL_LINE_STIPPLE);
        glLineStipple(2, 0x5F2B);
    }
    if (on & 32) glShadeModel(GL_FLAT);
    if (on & 64) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    if (on & 128) glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    if (on & 256) glEdgeFlag(GL_FALSE);
    glEnable(GL_DEPTH_TEST);
}

struct Outcome {
    Picture picture;
    Snapshot state;
};
/// Draws three times, with other current values and another matrix from the second time on.
template <class Draw>
Outcome drawn_often(unsigned on, Draw draw) {
    const Window window;
    use_pixel_coordinates(window);
    set_state(on);
    glColor3f(0.25f, 1, 0.5f);
    draw();
    glColor3f(1, 0.5f, 0.5f);
    glNormal3f(1, 0, 0.25f);
    glTexCoord2f(0.375f, 0.625f);
    for (int i = 0; i < 2; ++i) {
        glTranslatef(2, -1, 0.125f);
        draw();
    }
    return {picture_of(window), snapshot()};
}

/// Makes a list at the first call, and plays it.
template <class Draw>
auto by_list(Draw draw) {
    return [draw, compiled = false]() mutable {
        if (!compiled) {
            glNewList(1, GL_COMPILE);
            draw();
            glEndList();
            compiled = true;
        }
        glCallList(1);
    };
}

/// Counts the machine's draws.
class DrawLog : public FrameLog {
public:
    explicit DrawLog(int& draws) : draws_(draws) {}
    void open(Drawable&) override {}
    void begin_frame(Drawable&) override {}
    void executed(Drawable&, const Execution& execution) override {
        for (const Command& command : execution.list.commands)
            draws_ += std::holds_alternative<Draw>(command) ? 1 : 0;
    }
    void end_frame(Drawable&) override {}
    void close(Drawable&) override {}

private:
    int& draws_;
};

}  // namespace

TEST(GlSealedLists, DrawWhatImmediateModeDrawsUnderEveryState) {
    unsigned gives = 0;
    for (unsigned on = 0; on < 1u << state_bits; ++on)
        for (GLenum mode = on % 5; mode <= GL_POLYGON; mode += 5) {
            gives = (gives + 7) % 16;
            for (const int count : {24, 6}) {  // small runs, too
                const auto draw = [&] { runs(mode, gives, count); };
                const Outcome immediate = drawn_often(on, draw);
                const Outcome played = drawn_often(on, by_list(draw));
                ASSERT_EQ(immediate.picture, played.picture)
                    << "mode " << mode << ", state " << on << ", gives " << gives;
                ASSERT_EQ(changes(immediate.state, played.state), std::vector<std::string>{})
                    << "mode " << mode << ", state " << on << ", gives " << gives;
            }
        }
}

TEST(GlSealedLists, SmallRunsAreJoinedUnlessTheStateChanges) {
    const auto draws = [](auto change) {
        int count = 0;
        set_frame_log(std::make_unique<DrawLog>(count));
        {
            const Window window;
            glNewList(1, GL_COMPILE);
            runs(GL_TRIANGLES, 0, 3);
            glEndList();
            for (int i = 0; i < 100; ++i) {
                change(i);
                glCallList(1);
            }
            glFinish();
        }
        set_frame_log(nullptr);
        return count;
    };
    EXPECT_EQ(draws([](int) { glTranslatef(0.125f, 0, 0); }), 100);
    EXPECT_EQ(draws([](int i) { glColor3f(float(i) / 100, 1, 0); }), 2);
    EXPECT_EQ(draws([](int i) {
                  if (i == 50) glTranslatef(0.125f, 0, 0);
              }),
              4);
}

TEST(GlSealedLists, ShareTheCornersOfNeighboursUnderEveryState) {
    for (unsigned on = 0; on < 1u << state_bits; ++on) {
        const unsigned gives = on * 7 % 16;
        const Outcome immediate = drawn_often(on, [&] { grid(gives); });
        const Outcome played = drawn_often(on, by_list([&] { grid(gives); }));
        ASSERT_EQ(immediate.picture, played.picture) << "state " << on << ", gives " << gives;
    }
}

TEST(GlSealedLists, OneListServesStatesThatChangeBetweenItsCalls) {
    for (unsigned gives = 0; gives < 16; ++gives) {
        const auto draw = [&](auto play) {
            const Window window;
            use_pixel_coordinates(window);
            play(0u);
            for (unsigned bit = 0; bit < state_bits; ++bit) {
                set_state(1u << bit);
                glTranslatef(bit % 2 == 0 ? 1 : -1, 1, 0.0625f);
                play(bit);
            }
            return picture_of(window);
        };
        const Picture immediate = draw([&](unsigned) { runs(GL_QUAD_STRIP, gives); });
        const Picture played = draw([&](unsigned bit) {
            if (bit == 0) {
                glNewList(1, GL_COMPILE);
                runs(GL_QUAD_STRIP, gives);
                glEndList();
            }
            glCallList(1);
        });
        EXPECT_EQ(immediate, played) << gives;
        EXPECT_NE(immediate, blank());
    }
}

}  // namespace gw::gl
