// Superposed pictures: where the samples lie, and what their mean is.
#include "gw/error.h"
#include "multipass/antialias.h"
#include "multipass/driver.h"

#include "scenes.h"

#include <gtest/gtest.h>

#include <set>

namespace gw::multipass {
namespace {

constexpr int size = 16;

/// A white square on black; its left edge is at x = 4.25 pixels, its right one at 12.25.
scene::Scene shifted_square() {
    scene::Scene s;
    add_square(s, "white", {.Ka = vec3(0), .Kd = vec3(0), .Ke = vec3(1)}, {0.0625, 0, 0});
    s.camera = scene::Camera{.eye = {0, 0, 5}, .near_plane = 1, .far_plane = 9, .ortho_height = 4};
    return s;
}

Planes drawn(const scene::Scene& s, const Profile& profile, int samples) {
    const auto machine = make_reference(profile, size, size);
    render_samples(*machine, samples, [&](Machine& m) { render(m, s, scene::make_view(s, size, size), {}); });
    return machine->planes();
}

}  // namespace

TEST(SamplePositions, FillTheGridOnce) {
    for (int bits : {1, 2, 3}) {
        const int grid = 1 << bits;
        std::set<std::pair<int, int>> found;
        for (const JitterState& p : sample_positions(grid * grid, bits)) {
            EXPECT_GE(std::min(p.x, p.y), -grid / 2);
            EXPECT_LT(std::max(p.x, p.y), grid / 2);
            found.insert({p.x, p.y});
        }
        EXPECT_EQ(found.size(), static_cast<std::size_t>(grid * grid));
    }
}

TEST(SamplePositions, HaveEveryColumnAndRowAsOftenAsAnyOther) {
    for (int count : {8, 16, 32}) {
        std::map<int, int> columns, rows;
        for (const JitterState& p : sample_positions(count, 3)) {
            ++columns[p.x];
            ++rows[p.y];
        }
        for (int i = -4; i < 4; ++i) {
            EXPECT_EQ(columns[i], count / 8);
            EXPECT_EQ(rows[i], count / 8);
        }
    }
}

TEST(RenderSamples, OfOneIsThePictureAsItIs) {
    const scene::Scene s = shifted_square();
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {});
    EXPECT_EQ(drawn(s, vgx(), 1), machine->planes());
}

TEST(RenderSamples, CountThePositionsThatCoverThePixel) {
    const auto row = drawn(shifted_square(), vgx(), 64).color;
    const auto red = [&](int x) { return row[static_cast<std::size_t>(8 * size + x)][0]; };
    // Pixel 4 (centre 4.5) is covered where 4.25 + j/8 <= 4.5, j = -4 .. 2; pixel 12 where 12.25 + j/8
    // > 12.5, j = 3.
    EXPECT_EQ(red(3), 0);
    EXPECT_EQ(red(4), 223);  // 255 7/8
    EXPECT_EQ(red(5), 255);
    EXPECT_EQ(red(11), 255);
    EXPECT_EQ(red(12), 32);  // 255 1/8
    EXPECT_EQ(red(13), 0);
}

TEST(RenderSamples, KeepAnEvenColourForEveryCountThatFits) {
    EXPECT_EQ(most_samples(vgx()), 128);
    EXPECT_EQ(most_samples(reality()), 2048);
    EXPECT_EQ(most_samples(ideal()), 32768);
    for (int count : {2, 3, 7, 100, 128}) {
        EXPECT_EQ(drawn(shifted_square(), vgx(), count).color[8 * size + 8], (Rgba{255, 255, 255, 255}))
            << count;
    }
}

TEST(RenderSamples, RefuseMoreThanTheAccumulationBufferHolds) {
    EXPECT_THROW(drawn(shifted_square(), vgx(), 129), Error);
    EXPECT_THROW(drawn(shifted_square(), vgx(), 0), Error);
}

}  // namespace gw::multipass
