// Coverage found by sums in double against the exact areas, for discs and the rectangles of lines.
// docs/manual/rasterization.md, "Antialiasing".
#include "gw/fast/raster/shape_coverage.h"
#include "tests/gw/random.h"

#include <gtest/gtest.h>

namespace gw::fast {
namespace {

using namespace test;

constexpr int tile_side = 64;

/// The coverage of a tile's pixels, found by blocks.
std::vector<std::uint32_t> found_coverage(const ShapeSides& shape, ShapePoint to,
                                          const PixelRange& range, int tile_x, int tile_y,
                                          int bits) {
    static ShapeCoverage coverage;  // what it keeps from other shapes must not matter
    coverage.find(shape, to, range, tile_x, tile_y, bits);
    std::vector<std::uint32_t> out(tile_side * tile_side, 0);
    coverage.for_each_block([&](int bx, int by, const CoverageBlock& block, std::uint32_t lanes) {
        for (int lane = 0; lane < block_pixels; ++lane) {
            EXPECT_EQ(block.lane[lane] != 0, (lanes >> lane & 1) != 0);
            const int x = bx * block_side + lane % block_side,
                      y = by * block_side + lane / block_side;
            out[std::size_t(y * tile_side + x)] = block.lane[lane];
        }
    });
    return out;
}

/// Compares each pixel of the tile; counts those that are covered in part.
int compare_coverage(const ShapeSides& shape, ShapePoint to, Random& random, int bits) {
    std::vector<ShapePoint> moved;
    for (const ShapePoint& p : shape.corners()) moved.push_back({p[0] + to[0], p[1] + to[1]});
    const PixelRange reach = shape.pixels(to);
    // A tile around the shape's lower left corner, or its upper right one, and a box in it
    const int tile_x =
                  (random.one_in(2) ? reach.x0 : reach.x1) - int(random.between(0, tile_side - 1)),
              tile_y =
                  (random.one_in(2) ? reach.y0 : reach.y1) - int(random.between(0, tile_side - 1));
    const int cut = random.one_in(3) ? int(random.between(1, 9)) : 0;
    const PixelRange range{std::max(reach.x0 - tile_x, cut), std::max(reach.y0 - tile_y, cut),
                           std::min(reach.x1 - tile_x, tile_side - cut),
                           std::min(reach.y1 - tile_y, tile_side - cut)};
    const auto coverage = found_coverage(shape, to, range, tile_x, tile_y, bits);
    int partial = 0;
    for (int y = 0; y < tile_side; ++y)
        for (int x = 0; x < tile_side; ++x) {
            const bool inside = x >= range.x0 && x < range.x1 && y >= range.y0 && y < range.y1;
            const std::uint32_t exact =
                inside ? coverage_of(area_inside(moved, tile_x + x, tile_y + y), bits) : 0;
            EXPECT_EQ(coverage[std::size_t(y * tile_side + x)], exact) << x << " " << y;
            partial += exact > 0 && exact < max_of_bits(bits);
        }
    return partial;
}

int any_coverage_bits(Random& random) { return random.one_in(2) ? 8 : int(random.between(1, 16)); }

TEST(ShapeCoverage, OfDiscsIsTheExactAreasRounded) {
    Random random(41);
    int partial = 0;
    for (int n = 0; n < 1500 && !testing::Test::HasFailure(); ++n) {
        const float size = n < 1300 ? float(random.between(1024, 16384)) / 2048
                                    : float(random.between(1024, 128 * 2048)) / 2048;
        ShapeSides shape;
        shape.set(disc({0, 0}, half_size(size)).corners);
        // Positions of 8, 3 and 1 sub-pixel bits
        const int step = random.one_in(3) ? 2048 : random.one_in(2) ? 512 : 16;
        const auto at = [&] { return random.between(-3000, 8000) * 4096 / step * step; };
        SCOPED_TRACE(n);
        partial += compare_coverage(shape, {at(), at()}, random, any_coverage_bits(random));
    }
    EXPECT_GT(partial, 10000);
}

TEST(ShapeCoverage, OfLinesIsTheExactAreasRounded) {
    Random random(42);
    int partial = 0;
    for (int n = 0; n < 4000 && !testing::Test::HasFailure(); ++n) {
        const int s = random.one_in(2) ? 8 : int(random.between(1, 8));
        const std::int64_t reach = std::int64_t(random.one_in(3)   ? 8000
                                                : random.one_in(2) ? 80
                                                                   : 4)
                                   << s;
        const ShapePoint a{random.between(0, reach), random.between(0, reach)};
        ShapePoint b{random.between(0, reach), random.between(0, reach)};
        // Level, upright and nearly level lines
        if (random.one_in(4)) b[1] = a[1] + random.between(-1, 1);
        if (random.one_in(4)) b[0] = a[0] + random.between(-1, 1);
        if (a == b) continue;
        const float width = float(random.between(1, 20)) / 2;
        const SmoothLine line = smooth_line(a, b, width, s);
        ShapeSides shape;
        shape.set(line.rectangle(0, line.steps));
        partial += compare_coverage(shape, {0, 0}, random, any_coverage_bits(random));
    }
    EXPECT_GT(partial, 10000);
}

}  // namespace
}  // namespace gw::fast
