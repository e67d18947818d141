// Windows with samples. GLX_ARB_multisample, [GL15] 3.2.1, 4.1.3, 4.2
#include "gl/record/restored_planes.h"
#include "tests/gl/unit/framebuffers/framebuffer.h"

#include <random>

namespace gw::gl {

namespace {

struct SampledWindow : Window {
    explicit SampledWindow(int samples = 4, Buffers buffers = Buffers::Single)
        : Window(8, 8, opengl(), buffers, samples) {
        glClear(GL_ACCUM_BUFFER_BIT);
        use_pixel_coordinates(*this);
    }
};

/// Half of the samples of the pixels of column 2, and all of columns 3 to 5.
void draw_half() { glRectf(2.5f, 0, 6, 8); }

constexpr Bytes black{0, 0, 0, 0}, half{128, 128, 128, 128}, white{255, 255, 255, 255};

}  // namespace

TEST(WindowSamples, SmoothEdgesUnlessTheyAreOff) {
    for (const int samples : {2, 4, 8}) {
        const SampledWindow window(samples);
        EXPECT_EQ(integer(GL_SAMPLES), samples);
        EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 1);
        draw_half();
        EXPECT_EQ(pixel_at(1, 1), black);
        EXPECT_EQ(pixel_at(2, 1), half) << samples;
        EXPECT_EQ(pixel_at(3, 1), white);
        clear_to(0, 0, 0, 0);
        glDisable(GL_MULTISAMPLE);
        glRectf(2.25f, 0, 6, 8);
        EXPECT_EQ(pixel_at(2, 1), white) << samples;
        EXPECT_GL_ERROR(GL_NO_ERROR);
    }
    const Window window;
    EXPECT_EQ(integer(GL_SAMPLES), 0);
}

/// Samples outlive a read: two halves make a whole, and what is behind shows in the other half.
TEST(WindowSamples, GoOnAfterTheyWereRead) {
    const SampledWindow window;
    glEnable(GL_DEPTH_TEST);
    draw_half();
    EXPECT_EQ(pixel_at(2, 1), half);
    EXPECT_NEAR(depth_at(3, 1), 0.5, 1e-6);
    EXPECT_EQ(depth_at(0, 1), 1.0f);
    glTranslatef(0, 0, -0.5f);
    glColor3f(1, 0, 0);
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(pixel_at(2, 1), (Bytes{255, 128, 128, 255}));
    EXPECT_EQ(pixel_at(3, 1), white);
}

TEST(WindowSamples, TheBackBufferIsShownAtASwap) {
    SampledWindow window(4, Buffers::Double);
    draw_half();
    EXPECT_EQ(pixel_at(2, 1), half) << "back";
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(pixel_at(2, 1), black);
    finish_frame(window.context);
    window.drawable.swap();
    EXPECT_EQ(pixel_at(2, 1), half);
    glReadBuffer(GL_BACK);
    EXPECT_EQ(pixel_at(2, 1), half) << "a copy";
    glRectf(0, 0, 2.5f, 8);  // the other samples
    EXPECT_EQ(pixel_at(2, 1), white);
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(pixel_at(2, 1), half);
}

TEST(WindowSamples, FrontAndBackKeepTheirOwnColours) {
    SampledWindow window(4, Buffers::Double);
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawBuffer(GL_FRONT);
    draw_half();
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(pixel_at(2, 1), half);
    glReadBuffer(GL_BACK);
    EXPECT_EQ(pixel_at(2, 1), (Bytes{0, 0, 255, 255}));
    glDrawBuffer(GL_FRONT_AND_BACK);
    glColor3f(1, 0, 0);
    glRectf(0, 0, 1, 8);
    EXPECT_EQ(pixel_at(0, 1), (Bytes{255, 0, 0, 255}));
    EXPECT_EQ(pixel_at(7, 1), (Bytes{0, 0, 255, 255}));
    glDrawBuffer(GL_NONE);
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(pixel_at(7, 1), (Bytes{0, 0, 255, 255}));
    glDrawBuffer(GL_FRONT);
    draw_half();
    finish_frame(window.context);
    window.drawable.swap();  // what was in front is the back buffer now, or a copy of the new front
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(pixel_at(7, 1), (Bytes{0, 0, 255, 255}));
    EXPECT_EQ(pixel_at(0, 1), (Bytes{255, 0, 0, 255}));
    glDrawBuffer(GL_BACK);
    glReadBuffer(GL_BACK);
    glRectf(3, 0, 4, 8);
    EXPECT_EQ(pixel_at(7, 1), (Bytes{0, 0, 255, 255}));
    EXPECT_EQ(pixel_at(3, 1), (Bytes{255, 0, 0, 255}));
}

TEST(WindowSamples, AreAccumulatedAsTheirMeans) {
    const SampledWindow window;
    draw_half();
    glAccum(GL_LOAD, 0.5f);
    clear_to(0, 0, 0, 0);
    glAccum(GL_ACCUM, 1);
    glAccum(GL_RETURN, 2);
    EXPECT_EQ(pixel_at(2, 1), half);
    glRectf(0, 0, 2.5f, 8);  // the other two of four samples
    EXPECT_EQ(pixel_at(2, 1)[0], 192);
    glClear(GL_ACCUM_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(pixel_at(3, 1), black);
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST(WindowSamples, AreCopiedAsTheirMeans) {
    const SampledWindow window;
    draw_half();
    glRasterPos2i(0, 4);
    glCopyPixels(2, 0, 2, 1, GL_COLOR);
    EXPECT_EQ(pixel_at(0, 4), half);
    EXPECT_EQ(pixel_at(1, 4), white);
    new_texture(GL_RGBA, 2, 2);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 0, 2, 2);
    std::array<Bytes, 4> texels{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(texels, (std::array{black, half, black, half}));
    glRectf(0.5f, 0, 1, 2);  // what no read has brought up to date
    glBlitFramebuffer(0, 0, 2, 2, 6, 6, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_EQ(pixel_at(6, 6), half);
    EXPECT_EQ(pixel_at(7, 6), black);
    glBlitFramebuffer(2, 0, 4, 2, 4, 4, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST(WindowSamples, GoToObjectsAndComeBack) {
    const SampledWindow window;
    draw_half();
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    clear_to(0, 0, 0, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    const auto object = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, object);
    EXPECT_EQ(pixel_at(2, 1), half);
    EXPECT_EQ(integer(GL_SAMPLES), 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    clear_to(0, 0, 0, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    EXPECT_EQ(pixel_at(2, 1), half);
    EXPECT_EQ(pixel_at(1, 1), black);
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST(WindowSamples, AreCountedByQueries) {
    const SampledWindow window;
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    draw_half();
    pixel_at(0, 0);
    draw_half();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(1, GL_QUERY_RESULT, &count);
    EXPECT_EQ(count, 2u * (8 * (2 + 3 * 4)));
}

TEST(WindowSamples, FollowANewSize) {
    SampledWindow window;
    draw_half();
    glFinish();
    window.drawable.resize(5, 4);
    draw_half();
    EXPECT_EQ(pixel_at(2, 1), half);
    EXPECT_EQ(pixel_at(1, 1), black);
}

/// After an error of the machine, nobody knows which surfaces it has.
TEST(WindowSamples, GoOnAfterAnError) {
    WindowSamples samples(8, 8, 4);
    CommandList before, after;
    before.add(BeginPass{"before"});
    samples.prepare(gw::Clear{.planes = mask_of(Plane::Color)}, gw::State(), before);
    const auto machine = make_reference(opengl(), 8, 8);
    machine->execute(before);
    samples.forget();
    const gw::Clear clear{.planes = mask_of(Plane::Color), .color = {1, 1, 1, 1}};
    samples.prepare(clear, gw::State(), after);
    after.add(clear);
    samples.resolve(surface_planes, gw::State(), after);
    machine->execute(after);
    EXPECT_EQ(machine->planes().color[0], (Rgba{255, 255, 255, 255}));
}

/// At most 2^26 samples in all.
TEST(WindowSamples, OfManyPixelsAreFewer) {
    EXPECT_EQ(fitting_samples(4096, 4096, 4), 4);
    EXPECT_EQ(fitting_samples(4096, 4096, 8), 4);
    EXPECT_EQ(fitting_samples(8192, 8192, 2), 0);
    testing::internal::CaptureStderr();
    const Drawable large(opengl(), 4096, 4096, "large", Buffers::Single, 8);
    EXPECT_EQ(
        testing::internal::GetCapturedStderr(),
        "gw: warning: large: 4096 x 4096 pixels have 4 samples, not 8; the machine has at most "
        "67108864 in all\n");
    EXPECT_EQ(large.samples(), 4);
}

namespace {

/// Draws as many random things as `count`, in 8 x 8 pixels. What it draws follows from the seed.
void draw_random(unsigned seed, int count) {
    std::mt19937 random(seed);
    const auto real = [&](float low, float high) {
        return low + (high - low) * float(random() % 64) / 64;
    };
    for (int i = 0; i < count; ++i) {
        switch (random() % 8) {
            case 0: glColor4f(real(0, 1), real(0, 1), real(0, 1), real(0, 1)); break;
            case 1: (random() % 3 ? glEnable : glDisable)(GL_MULTISAMPLE); break;
            case 2: (random() % 2 ? glEnable : glDisable)(GL_DEPTH_TEST); break;
            case 3:
                (random() % 2 ? glEnable : glDisable)(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                break;
            case 4: (random() % 3 ? glDisable : glEnable)(GL_SAMPLE_ALPHA_TO_COVERAGE); break;
            case 5:
                (random() % 2 ? glEnable : glDisable)(GL_SCISSOR_TEST);
                glScissor(int(random() % 4), int(random() % 4), 5, 5);
                break;
            case 6:
                if (random() % 4 == 0)
                    glClear(random() % 2 ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
                break;
            case 7: break;
        }
        glBegin(random() % 4 ? GL_TRIANGLES : random() % 2 ? GL_LINES : GL_POINTS);
        for (int corner = 0; corner < 6; ++corner)
            glVertex3f(real(-1, 9), real(-1, 9), real(-1, 1));
        glEnd();
    }
}

}  // namespace

/// Against objects with samples, whose code is another one.
TEST(WindowSamples, AreThoseOfAnObject) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const int samples = 2 << seed % 3;
        const SampledWindow window(samples, seed % 2 ? Buffers::Double : Buffers::Single);
        for (unsigned part = 0; part < 3; ++part) {
            draw_random(3 * seed + part, 5);
            pixel_at(1, 1);
        }
        const auto drawn = window.pixels();
        std::array<GLfloat, 64> depths{};
        glReadPixels(0, 0, 8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());

        const Window other(8, 8);
        use_pixel_coordinates(other);
        new_framebuffer();
        GLuint names[2] = {};
        glGenRenderbuffers(2, names);
        glBindRenderbuffer(GL_RENDERBUFFER, names[0]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, 8, 8);
        attach_renderbuffer(names[0]);
        glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, 8, 8);
        attach_renderbuffer(names[1], GL_DEPTH_ATTACHMENT);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (unsigned part = 0; part < 3; ++part) draw_random(3 * seed + part, 5);
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                          GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        ASSERT_EQ(drawn, other.pixels()) << seed;
        std::array<GLfloat, 64> wanted{};
        glReadPixels(0, 0, 8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, wanted.data());
        ASSERT_EQ(depths, wanted) << seed;
    }
}

/// A recording that begins in the middle: with one value for all samples of a pixel.
TEST(WindowSamples, AreRestoredAsTheirMeans) {
    SampledWindow window(4, Buffers::Double);
    draw_half();
    glFinish();
    finish_frame(window.context);
    window.drawable.swap();
    const CommandList samples = window.drawable.resolve_samples();
    CommandList list = restoring_list(window.drawable.planes(), opengl(), "before frame 1",
                                      *window.drawable.state());
    list.append(samples);
    list.add(Read{.rect = {0, 0, 1, 1}});  // the window is in use, as it was
    list.add(UseSurface{WindowSamples::surface});
    list.add(SetState{gw::State()});
    list.add(gw::Clear{.planes = mask_of(Plane::Depth)});
    list.add(UseSurface{0});
    list.add(Blit{.from_surface = WindowSamples::surface,
                  .planes = mask_of(Plane::Color) | mask_of(Plane::Depth),
                  .source = {0, 0, 8, 8},
                  .target = {0, 0, 8, 8}});
    const auto machine = make_reference(opengl(), 8, 8);
    machine->execute(list);
    EXPECT_EQ(machine->planes().color, window.drawable.planes().back);
    EXPECT_EQ(machine->planes().color[2], (Rgba{128, 128, 128, 128}));
    EXPECT_EQ(machine->planes().depth[0], 0xFFFFFFu);
}

}  // namespace gw::gl
