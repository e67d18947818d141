// Superposed pictures: where the samples lie, and what their mean is.
#include "multipass/frame/superpose.h"

#include "gw/error.h"
#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
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
    render(*machine, s, scene::make_view(s, size, size), {.samples = samples});
    return machine->planes();
}

std::vector<JitterState> positions(std::size_t count, int bits) {
    std::vector<JitterState> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(jitter_of({i, count}, bits));
    return result;
}

TEST(Jitter, FillsTheGridOnce) {
    for (const int bits : {1, 2, 3}) {
        const int grid = 1 << bits;
        std::set<std::pair<int, int>> found;
        for (const JitterState& p : positions(std::size_t(grid) * std::size_t(grid), bits)) {
            EXPECT_GE(std::min(p.x, p.y), -grid / 2);
            EXPECT_LT(std::max(p.x, p.y), grid / 2);
            found.insert({p.x, p.y});
        }
        EXPECT_EQ(found.size(), std::size_t(grid * grid));
    }
}

TEST(Jitter, HasEveryColumnAndRowAsOftenAsAnyOther) {
    for (const int count : {8, 16, 32}) {
        std::map<int, int> columns, rows;
        for (const JitterState& p : positions(std::size_t(count), 3)) {
            ++columns[p.x];
            ++rows[p.y];
        }
        for (int i = -4; i < 4; ++i) {
            EXPECT_EQ(columns[i], count / 8);
            EXPECT_EQ(rows[i], count / 8);
        }
    }
}

TEST(Spread, HasOnePointInEachStripeForEveryKind) {
    for (const std::size_t count : {1u, 2u, 7u, 16u, 100u})
        for (unsigned kind = 0; kind < 12; ++kind) {
            std::set<int> columns, rows;
            for (std::size_t i = 0; i < count; ++i) {
                const dvec2 p = spread({i, count}, kind);
                EXPECT_TRUE(p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1);
                columns.insert(int(p.x * double(count)));
                rows.insert(int(p.y * double(count)));
            }
            EXPECT_EQ(columns.size(), count);
            const bool power_of_two = (count & (count - 1)) == 0;
            EXPECT_TRUE(!power_of_two || rows.size() == count);
        }
}

TEST(Spread, OrdersItsKindsDifferently) {
    int same = 0;
    for (std::size_t i = 0; i < 64; ++i) same += spread({i, 64}, 1) == spread({i, 64}, 2);
    EXPECT_LT(same, 8);
}

TEST(OnDisc, KeepsAreas) {
    // Of points evenly spread over the square, a quarter falls into half the radius.
    int inner = 0;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 100; ++j) {
            const dvec2 p = on_disc({(i + 0.5) / 100, (j + 0.5) / 100});
            const double r2 = p.x * p.x + p.y * p.y;
            EXPECT_LT(r2, 1);
            inner += r2 < 0.25;
        }
    EXPECT_EQ(inner, 2500);
}

TEST(ViewAt, TurnsTheViewAroundWhatIsInFocus) {
    scene::Scene s = shifted_square();
    s.camera = scene::Camera{
        .eye = {0, 0, 5}, .near_plane = 1, .far_plane = 20, .aperture = 0.5, .focus = 4};
    const scene::View still = scene::make_view(s, size, size);
    const auto place = [](const scene::View& view, double z) {
        const dvec4 clip = view.clip_from_eye * (view.eye_from_world * dvec4(0.5, -0.25, z, 1));
        return dvec2(clip.x / clip.w, clip.y / clip.w);
    };
    dvec2 reach(0);
    for (std::size_t i = 0; i < 8; ++i) {
        const scene::View view = view_at(still, {i, 8});
        const dvec2 sharp = place(view, 1) - place(still, 1),
                    near = place(view, 3) - place(still, 3),
                    far = place(view, -5) - place(still, -5);
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(sharp[axis], 0, 1e-12) << i;
            EXPECT_LE(near[axis] * far[axis], 0) << i;
            reach[axis] = std::max(reach[axis], std::abs(near[axis]));
        }
    }
    EXPECT_GT(reach.x, 0.1);
    EXPECT_GT(reach.y, 0.1);
}

TEST(Superpose, OneIsThePictureAsItIs) {
    const auto machine = make_reference(vgx(), size, size);
    const scene::Scene s = shifted_square();
    Superposition said = render(*machine, s, scene::make_view(s, size, size), {});
    EXPECT_EQ(said.samples, 1);
    for (const PassReport& pass : machine->passes()) EXPECT_NE(pass.name, "return");
}

TEST(Superpose, CountsThePositionsThatCoverThePixel) {
    const auto row = drawn(shifted_square(), vgx(), 64).color;
    const auto red = [&](int x) { return row[std::size_t(8 * size + x)][0]; };
    // Pixel 4 (centre 4.5) is covered where 4.25 + j/8 <= 4.5, j = -4 .. 2; pixel 12 where 12.25 +
    // j/8 > 12.5, j = 3.
    EXPECT_EQ(red(3), 0);
    EXPECT_EQ(red(4), 223);  // 255 7/8
    EXPECT_EQ(red(5), 255);
    EXPECT_EQ(red(11), 255);
    EXPECT_EQ(red(12), 32);  // 255 1/8
    EXPECT_EQ(red(13), 0);
}

TEST(Superpose, KeepsAnEvenColourForEveryCount) {
    EXPECT_EQ(most_pictures(vgx()), 128);
    EXPECT_EQ(most_pictures(reality()), 2048);
    EXPECT_EQ(most_pictures(ideal()), 32768);
    for (const int count : {2, 3, 7, 100, 128, 129, 256})
        EXPECT_EQ(drawn(shifted_square(), vgx(), count).color[8 * size + 8],
                  (Rgba{255, 255, 255, 255}))
            << count;
}

TEST(Superpose, MoreThanTheAccumulationBufferHoldsAreMeansOfGroups) {
    EXPECT_EQ(superposition(vgx(), 128, 0).groups, 1);
    const Superposition two = superposition(vgx(), 129, 0);
    EXPECT_EQ(two.groups, 2);
    EXPECT_EQ(two.samples, 130) << "groups of one size";
    EXPECT_EQ(superposition(vgx(), 256, 0).samples, 256);
    EXPECT_EQ(superposition(reality(), 256, 0).groups, 1);
    EXPECT_EQ(superposition(vgx(), 100, 4).groups, 4) << "32 pictures of 4 images";
    // On the whole grid the means of two groups of 128 are those of one of 64.
    EXPECT_EQ(drawn(shifted_square(), vgx(), 256).color, drawn(shifted_square(), vgx(), 64).color);
    EXPECT_THROW(superposition(vgx(), 128 * 128 + 1, 0), Error);
    EXPECT_THROW(superposition(vgx(), 0, 0), Error);
}

TEST(Superpose, NeverOverflows) {
    for (const int count : {128, 129, 256}) {
        const auto machine = make_reference(vgx(), size, size);
        const scene::Scene s = shifted_square();
        render(*machine, s, scene::make_view(s, size, size), {.samples = count});
        for (const PassReport& pass : machine->passes())
            EXPECT_EQ(pass.counters.accum_overflows, 0u) << pass.name;
    }
}

TEST(TentWeights, AreIntegersThatFallFromTheCentreAndFit) {
    for (const int count : {2, 5, 16, 64, 100, 128}) {
        const std::vector<int> weights = tent_weights(count, 3, 128);
        ASSERT_EQ(weights.size(), std::size_t(count));
        EXPECT_LE(std::accumulate(weights.begin(), weights.end(), 0), 128) << count;
        EXPECT_GE(*std::min_element(weights.begin(), weights.end()), 1);
    }
    const std::vector<int> weights = tent_weights(16, 3, 128);
    const auto from_centre = [](std::size_t k) {
        const JitterState j = jitter_of({k, 16}, 3);
        return std::pair(std::abs(2 * j.x + 1), std::abs(2 * j.y + 1));
    };
    for (std::size_t a = 0; a < 16; ++a)
        for (std::size_t b = 0; b < 16; ++b) {
            const auto [ax, ay] = from_centre(a);
            const auto [bx, by] = from_centre(b);
            EXPECT_TRUE(!(ax <= bx && ay <= by) || weights[a] >= weights[b]);
        }
    EXPECT_GT(*std::max_element(weights.begin(), weights.end()), 4);
    EXPECT_THROW(tent_weights(129, 3, 128), Error);
}

TEST(Superpose, TakesTheWeightedMean) {
    const auto machine = make_reference(vgx(), 1, 1);
    const std::vector<std::uint16_t> values{10, 200, 60};
    const auto draw = [&](const Sample& sample) {
        const std::uint16_t v = values[sample.index];
        CommandList list;
        list.add(SetState{});
        list.add(WritePixels{.rect = {0, 0, 1, 1}, .colors = {Rgba{v, v, v, 255}}});
        machine->execute(list);
    };
    superpose(*machine, 3, 0, draw, {1, 2, 4});
    EXPECT_EQ(machine->planes().color[0][0], 93) << "(10 + 400 + 240) / 7 = 92.86";
    superpose(*machine, 3, 0, draw);
    EXPECT_EQ(machine->planes().color[0][0], 90);
    EXPECT_THROW(superpose(*machine, 200, 0, draw, std::vector<int>(200, 1)), Error);
}

}  // namespace
}  // namespace gw::multipass
