// From texels to pixels [F2.2]: form factors in closed form, and from the ID buffers what is seen.
#include "gw/fast/simd/simd_target.h"
#include "radiosity/hemicube/form_factors.h"
#include "radiosity/hemicube/near_texels.h"
#include "radiosity/hemicube/texel_scan.h"
#include "tests/radiosity/oracle.h"
#include "tests/radiosity/plain_texels.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace gw::radiosity {
namespace {

struct Drawn {
    Hemicube cube;
    IdBuffers buffers;
    SeenIds seen;
};

Drawn drawn(const PixmapModel& model, const dvec3& from, const dvec3& normal, double turn,
            int size) {
    Drawn d{.cube = hemicube_at(from, normal, turn, 1e-3, 2 * model.extent, size)};
    HemicubePainter(size).draw(model, d.cube, d.buffers);
    find_seen(d.buffers, d.seen);
    return d;
}

/// Identifiers in blobs of all sizes.
IdBuffers random_buffers(int size, std::minstd_rand& random) {
    IdBuffers buffers;
    for (std::size_t face = 0; face < buffers.size(); ++face) {
        IdBuffer& buffer = buffers[face];
        buffer.size = size;
        buffer.rows = face == 0 ? size : size / 2;
        buffer.pixels.assign(std::size_t(size) * std::size_t(buffer.rows), 0xFF000001);
        for (int blob = 0; blob < 12; ++blob) {
            const int x = int(random() % unsigned(size)), y = int(random() % unsigned(buffer.rows)),
                      w = int(random() % 40), h = int(random() % 40);
            for (int j = y; j < std::min(buffer.rows, y + h); ++j)
                for (int i = x; i < std::min(size, x + w); ++i)
                    buffer.pixels[pixel_index(i, j, size)] = 0xFF000000 | std::uint32_t(blob % 5);
        }
    }
    return buffers;
}

/// The radius to which all pixels of a face are like this one, found one by one.
int alone(const IdBuffer& buffer, int x, int y) {
    int found = 0;
    for (const int radius : {1, 2, 4, 8}) {
        for (int j = y - radius; j <= y + radius; ++j)
            for (int i = x - radius; i <= x + radius; ++i)
                if (i < 0 || j < 0 || i >= buffer.size || j >= buffer.rows ||
                    buffer.pixels[pixel_index(i, j, buffer.size)] !=
                        buffer.pixels[pixel_index(x, y, buffer.size)])
                    return found;
        found = radius;
    }
    return found;
}

TEST(SeenIds, KnowHowFarAPixelIsAlone) {
    std::minstd_rand random(3);
    for (const std::string& target : fast::simd_targets()) {
        ASSERT_TRUE(fast::use_simd_target(target));
        for (const int size : {8, 18, 64, 66, 130}) {
            const IdBuffers buffers = random_buffers(size, random);
            SeenIds seen;
            find_seen(buffers, seen);
            std::size_t at = 0;
            for (const IdBuffer& buffer : buffers)
                for (int y = 0; y < buffer.rows; ++y)
                    for (int x = 0; x < size; ++x, ++at)
                        ASSERT_EQ(seen.pixels[at],
                                  std::uint32_t(alone(buffer, x, y)) << 24 |
                                      (buffer.pixels[pixel_index(x, y, size)] & id_bits))
                            << target << ", " << size << ": " << x << ", " << y;
        }
    }
    fast::use_simd_target("");
}

scene::Scene box_with_block() {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 1);
    add_quad(scene, "block", {0.3f, 0.4f, 0.3f}, {0.1f, 0, 0.35f}, {0.3f, 0.1f, 0}, 0.5f);
    add_quad(scene, "under", {0.3f, 0.39f, 0.3f}, {0.3f, 0.1f, 0}, {0.1f, 0, 0.35f}, 0.5f);
    return scene;
}

bool same_bits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Every texel of every figure, whole and hidden, at borders and horizons.
TEST(Texels, ArePlainOnesToTheBitOnEveryVectorTarget) {
    const PixmapModel model = make_model(box_with_block(), {.texels_per_unit = 21});
    const Drawn d = drawn(model, {0.07, 0.6, 0.3}, {0.6, -0.8, 0}, 17, 50);
    const auto figures = plane_figures(model);
    std::array<int, near_point + 1> met{};
    for (const std::string& target : fast::simd_targets()) {
        ASSERT_TRUE(fast::use_simd_target(target));
        for (std::uint32_t f = 0; f < model.facets.size(); ++f) {
            const FigureView view = view_of(model, *figures[f], d.cube);
            if (view.depth <= 0) continue;
            const TexelSight sight{view, d.seen, f + 1};
            const PlainTexels plain(sight);
            const int width = figures[f]->width();
            std::vector<float> low(std::size_t(width) + 65), high(low.size()), factors(low.size());
            std::vector<TexelKind> kinds(low.size());
            for (int v = 0; v < figures[f]->end.y; ++v) {
                find_corners(view, {0, v, width}, low.data());
                find_corners(view, {0, v + 1, width}, high.data());
                find_row(sight, {0, v, width}, low.data(), high.data(), factors.data(),
                         kinds.data());
                for (int u = 0; u < width; ++u) {
                    const auto i = std::size_t(u);
                    const PlainTexels::Found found = plain.find(u, v);
                    ASSERT_EQ(kinds[i], found.kind) << target << " " << f << ": " << u << ", " << v;
                    ASSERT_TRUE(same_bits(factors[i], found.factor)) << target << " " << f;
                    ++met[std::size_t(found.kind)];
                    if (found.kind == decided || found.kind == near_point) continue;
                    TexelList list;
                    const dvec2 middle(u + 0.5, v + 0.5);
                    list.add(middle, middle, 0);
                    find_shares(sight, found.kind, list);
                    ASSERT_TRUE(same_bits(list.shares[0], plain.share(found.kind, middle, middle)))
                        << target << " " << f << ": " << u << ", " << v;
                }
            }
        }
    }
    fast::use_simd_target("");
    EXPECT_GT(met[decided], 100);
    EXPECT_GT(met[near_point], 10);
    EXPECT_GT(met[1], 10);
    EXPECT_GT(met[1 + at_border], 10);
}

/// Errors of texels' form factors, in parts of the exact ones: of the figure of `scene`, from (0, 0,
/// 0), in six turns of the hemicube.
struct Errors {
    double rms = 0, worst = 0;
};
Errors errors(const scene::Scene& scene, double texels, int size) {
    const PixmapModel model = make_model(scene, {.texels_per_unit = texels});
    const Facet& facet = model.facets.front();
    Errors e;
    constexpr int turns = 6;
    for (std::uint64_t seed = 0; seed < turns; ++seed) {
        FormFactors factors(model, {.hemicube = size, .seed = seed});
        const Row row = factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0);
        std::vector<double> found(model.texel_count());
        for (std::size_t i = 0; i < row.texels.size(); ++i) found[row.texels[i]] = row.factors[i];
        for (int v = 0; v < model.pixmaps[0].height; ++v)
            for (int u = 0; u < model.pixmaps[0].width; ++u) {
                const double exact =
                    point_to_polygon({0, 0, 0}, {0, 1, 0},
                                     {facet.at(dvec2(u, v)), facet.at(dvec2(u + 1, v)),
                                      facet.at(dvec2(u + 1, v + 1)), facet.at(dvec2(u, v + 1))});
                const double off = found[model.pixmaps[0].texel(u, v)] / exact - 1;
                e.rms += off * off / (turns * double(model.texel_count()));
                e.worst = std::max(e.worst, std::abs(off));
            }
    }
    return {std::sqrt(e.rms), e.worst};
}

scene::Scene wall_at(float height) {
    scene::Scene scene;
    add_quad(scene, "wall", {-1, height, -1}, {2, 0, 0}, {0, 0, 2}, 0, 1);
    return scene;
}

// What nothing hides is exact to the last texel, but for the scale: the pixels of the border. Texels
// at edges of the hemicube's faces that are at the wall's border too may lose a part.
TEST(Texels, OfAnOpenWallAreExact) {
    const Errors coarse = errors(wall_at(1), 16, 32), fine = errors(wall_at(1), 16, 128);
    EXPECT_LT(coarse.rms, 0.02);
    EXPECT_LT(fine.rms, 0.005);
    EXPECT_LT(fine.worst, 0.1);
    EXPECT_LT(errors(wall_at(1), 16, 512).worst, 0.01);
    EXPECT_LT(errors(wall_at(1), 3, 512).worst, 0.002);
}

// Near texels too, a twentieth of their side away.
TEST(Texels, OfANearWallAreExact) {
    EXPECT_LT(errors(wall_at(0.0125f), 4, 128).rms, 0.005);
    EXPECT_LT(errors(wall_at(0.0125f), 4, 512).worst, 0.01);  // three sides away, in grazing light
}

// A small plate before a wall: what the wall loses is what the plate gets.
TEST(Texels, BehindAnOccluderLoseWhatItCovers) {
    scene::Scene scene;
    add_quad(scene, "far", {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0, 1);
    add_quad(scene, "near", {-0.1f, 0.5f, -0.15f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 0, 1);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 10});
    const Quad far{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}},
        near{{-0.1, 0.5, -0.15}, {0.2, 0, 0}, {0, 0, 0.2}};
    const double to_near = point_to_polygon({0, 0, 0}, {0, 1, 0}, near.border()),
                 to_far = point_to_polygon({0, 0, 0}, {0, 1, 0}, far.border()) - to_near;
    double near_sum = 0, far_sum = 0;
    constexpr int turns = 16;
    for (std::uint64_t seed = 0; seed < turns; ++seed) {
        FormFactors factors(model, {.hemicube = 128, .seed = seed});
        const Row row = factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0);
        near_sum += to_object(model, row, "near") / turns;
        far_sum += to_object(model, row, "far") / turns;
    }
    EXPECT_NEAR(near_sum / to_near, 1, 0.005);
    EXPECT_NEAR(far_sum / to_far, 1, 0.005);
}

}  // namespace
}  // namespace gw::radiosity
