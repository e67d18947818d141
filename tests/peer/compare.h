// Scenes on the machine's sub-pixel grid, and where two planes may be compared.
#pragma once

#include "gw/command_list.h"
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/peer/peer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace gw::test {

inline constexpr int size = 64;  ///< of every window here, pixels
inline constexpr int grid = 8;   ///< units a pixel: the VGX's

/// Corners on the grid, a little beyond the window.
inline GridTriangle random_triangle(Random& random) {
    GridTriangle t;
    for (GridPoint& p : t)
        p = {random.between(-4 * grid, (size + 4) * grid),
             random.between(-4 * grid, (size + 4) * grid)};
    return t;
}

/// Object coordinates are pixels and depths in units of 2^-24.
inline State window_state() {
    State s;
    s.projection[0][0] = s.projection[1][1] = 2.0 / size;
    s.projection[2][2] = 2.0 / 16777215;
    s.projection[3] = {-1, -1, -1, 1};
    return s;
}

inline MeshData mesh_of(const GridTriangle& t, const std::array<std::int64_t, 3>& depth,
                        std::vector<vec4> colors) {
    MeshData data;
    for (std::size_t i = 0; i < 3; ++i)
        data.positions.push_back({float(t[i].x) / grid, float(t[i].y) / grid, float(depth[i])});
    data.colors = std::move(colors);
    return data;
}

inline vec4 random_color(Random& random) {
    const auto channel = [&] { return float(random.between(0, 255)) / 255; };
    const float r = channel(), g = channel(), b = channel();
    return {r, g, b, channel()};
}

inline void add(CommandList& list, const State& state, Command command) {
    list.add(SetState{state});
    list.add(std::move(command));
}

/// Whether a side passes the pixel's centre within one unit of the grid.
inline bool near_side(const GridTriangle& t, int x, int y) {
    const GridPoint p{x * grid + grid / 2, y * grid + grid / 2};
    for (std::size_t i = 0; i < 3; ++i) {
        const GridPoint &a = t[i], &b = t[(i + 1) % 3];
        const double dx = double(b.x - a.x), dy = double(b.y - a.y), length2 = dx * dx + dy * dy;
        const double along =
            length2 > 0 ? (double(p.x - a.x) * dx + double(p.y - a.y) * dy) / length2 : 0;
        const double k = std::clamp(along, 0.0, 1.0);
        if (std::hypot(double(p.x - a.x) - k * dx, double(p.y - a.y) - k * dy) <= 1) return true;
    }
    return false;
}
inline bool near_side(const std::vector<GridTriangle>& triangles, int x, int y) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const GridTriangle& t) { return near_side(t, x, y); });
}

/// Calls each(x, y, index) for every pixel.
inline void for_pixels(const auto& each) {
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) each(x, y, std::size_t(y) * size + std::size_t(x));
}

/// The largest difference of a channel.
inline int difference(const Rgba& a, const Rgba& b) {
    int worst = 0;
    for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::abs(int(a[c]) - int(b[c])));
    return worst;
}

/// How often which difference was seen.
struct Tally {
    long compared = 0, different = 0;
    double worst = 0;
    void add(double d) {
        ++compared;
        different += d != 0;
        worst = std::max(worst, d);
    }
};

/// One line of docs/manual/differences.md's table.
inline void report(const std::string& driver, const char* what, const Tally& t) {
    std::printf("%-9s %-44s compared %8ld  different %7ld  largest %.6g\n", driver.c_str(), what,
                t.compared, t.different, t.worst);
}

class Driver : public testing::TestWithParam<const char*> {
public:
    Answers play(const std::vector<CommandList>& lists, const Profile& profile = vgx()) const {
        Answers answers = gw::test::play(GetParam(), lists, size, size, profile);
        EXPECT_NE(answers.renderer.find(GetParam()), std::string::npos) << answers.renderer;
        return answers;
    }
};

/// Colours of all pixels.
inline Tally compare_colors(const std::vector<Planes>& a, const std::vector<Planes>& b) {
    Tally tally;
    for (std::size_t i = 0; i < a.size(); ++i)
        for_pixels(
            [&](int, int, std::size_t p) { tally.add(difference(a[i].color[p], b[i].color[p])); });
    return tally;
}

}  // namespace gw::test
