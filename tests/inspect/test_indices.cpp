// docs/manual/indices.md: the worked examples, and the shown pictures of manifests.
#include "gw/base/arithmetic.h"
#include "inspect/compare/verify.h"
#include "inspect/recording/content.h"
#include "inspect/replay/shown_maps.h"
#include "tests/gw/workbench.h"

#include <gtest/gtest.h>

namespace gw::inspect {
namespace {

using test::Workbench;
const MachineMaker fast = maker_of("fast", 1), reference = maker_of("reference");

ColorMap index_map(int bits, int bits_in_r, IndexPlanes planes = IndexPlanes::Window) {
    ColorMap map{.planes = planes, .bits = bits, .bits_in_r = bits_in_r};
    for (unsigned i = 0; i < 1u << bits; ++i) map.entries.push_back(i * 0x010203);
    return map;
}

/// One pixel, written by lists of a pass each.
Recording pixels(const std::vector<Rgba>& colors) {
    Recording r;
    r.width = r.height = 1;
    for (const Rgba& color : colors) {
        r.lists.emplace_back().add(BeginPass{"pass"});
        r.lists.back().add(WritePixels{.rect = {0, 0, 1, 1}, .colors = {color}});
    }
    return r;
}

/// XXH3-128 of a plane of one pixel: of the digest of its block.
Digest digest_of_pixel(const std::vector<std::uint8_t>& bytes) {
    const Digest block = digest_of_bytes(bytes);
    std::vector<std::uint8_t> canonical;
    for (const std::uint64_t half : {block.high, block.low})
        for (int shift = 56; shift >= 0; shift -= 8)
            canonical.push_back(std::uint8_t(half >> shift));
    return digest_of_bytes(canonical);
}

}  // namespace

// [R18.1]
TEST(ManualIndices, AreTheLowBitsOfRAndG) {
    EXPECT_EQ(index_map(12, 8).index_of({95, 15, 7, 255}), 3935u);
    EXPECT_EQ(index_map(12, 8).index_of({0xF5F, 0x3F, 0, 0}), 3935u);
    EXPECT_EQ(index_map(5, 3).index_of({0xFFFF, 0xFFFD, 0xFFFF, 0}), 0b01111u);
    EXPECT_EQ(index_map(4, 8).index_of({0x4B, 0xFF, 0, 0}), 0xBu);
}

// [R18.2]
TEST(ManualIndices, AreExactAsColours) {
    for (int bits = 8; bits <= 16; ++bits) {
        const std::uint32_t one = max_of_bits(bits);
        for (std::uint32_t v = 0; v <= one; ++v)
            ASSERT_EQ(quantize(float(v) / float(one), bits), v) << bits;
    }
}

// [R18.1] [R18.2] [R12.19] The worked example.
TEST(ManualIndices, AWriteMaskByBit) {
    Workbench bench(vgx(), 1, 1);
    bench.write({0, 0, 1, 1}, {0xFF, 0xF, 0, 255});
    bench.state.color_mask = {true, true, false, false};
    bench.state.color_mask_bits = {.r = 0xF0, .g = 0};
    bench.write({0, 0, 1, 1}, {0x55, 0x1, 0, 255});
    EXPECT_EQ(bench.color(0, 0), (Rgba{95, 15, 0, 255}));
    EXPECT_EQ(index_map(12, 8).index_of(bench.color(0, 0)), 3935u);
}

// [R18.3] The worked example, on every machine of the papers.
TEST(ManualIndices, VaryAsTexels) {
    for (const Profile& profile : {vgx(), reality(), ideal()}) {
        const std::uint64_t one = max_of_bits(profile.color_bits);
        std::vector<std::uint16_t> texels;
        for (std::uint64_t i = 0; i < 4096; ++i)
            for (const std::uint64_t v : {i & 255, i >> 8, std::uint64_t{0}, one})
                texels.push_back(std::uint16_t((v * 65535 + one / 2) / one));
        Workbench bench(profile, 16, 1);
        bench.state.texture.min_filter = MinFilter::Nearest;
        bench.state.texture.mag_filter = MagFilter::Nearest;
        bench.state.texture.env = TexEnv::Replace;
        MeshData quad =
            test::mesh_data(Primitive::Quads, {{0, 0, 0}, {16, 0, 0}, {16, 1, 0}, {0, 1, 0}});
        const float low = 100.5f / 4096, high = 420.5f / 4096;
        quad.texcoords = {{low, 0.5f}, {high, 0.5f}, {high, 0.5f}, {low, 0.5f}};
        bench.draw(Draw{.mesh = make_mesh(std::move(quad)),
                        .map = {make_texture("indices", 4096, 1, texels), {}}});
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(index_map(12, 8).index_of(bench.color(x, 0)), 110u + 20u * unsigned(x));
        EXPECT_EQ(bench.color(8, 0), (Rgba{14, 1, 0, std::uint16_t(one)}));
    }
}

// [R18.5] The worked example.
TEST(ManualIndices, TheShownPicture) {
    ColorMap map{.planes = IndexPlanes::Overlay, .bits = 2, .entries = {0xFFFFFF, 0x030201, 0, 0}};
    EXPECT_EQ(shown_picture({{4, 0, 0, 0}, {1, 9, 9, 9}}, map),
              (std::vector<Rgba>{{0, 0, 0, 0}, {1, 2, 3, 255}}));
    map.planes = IndexPlanes::Window;
    EXPECT_EQ(map.shown(0), (Rgba{255, 255, 255, 255}));
}

// [R18.4] [R18.6] The map of the list that ends the pass; a digest while there is one.
TEST(ManualIndices, EachPassIsShownThroughItsMap) {
    Recording r = pixels({{1, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}});
    r.lists[2].commands.erase(r.lists[2].commands.begin());  // of the pass before
    r.color_maps = {index_map(4, 8), {}, index_map(4, 8, IndexPlanes::PopUp), ColorMap{}};
    for (const MachineMaker& make : {fast, reference}) {
        const Manifest manifest = replayed_manifest(r, make, nullptr);
        ASSERT_EQ(manifest.passes.size(), 3u);
        EXPECT_EQ(manifest.passes[0].shown, digest_of_pixel({3, 0, 2, 0, 1, 0, 255, 0}));
        EXPECT_EQ(manifest.passes[1].shown, digest_of_pixel({6, 0, 4, 0, 2, 0, 255, 0}));
        EXPECT_FALSE(manifest.passes[2].shown);
        EXPECT_EQ(manifest.passes[1].color_map->planes, IndexPlanes::PopUp);
        EXPECT_EQ(map_of_pass(manifest, 0)->planes, IndexPlanes::Window);
        EXPECT_EQ(map_of_pass(manifest, 2), nullptr);
        EXPECT_EQ(manifest_from_json(to_json(manifest)), manifest);
    }
}

// [R18.5] [R18.6] Index 0 of planes beside the window is 0 in all channels.
TEST(ManualIndices, WhatShowsBelowHasNoColour) {
    Recording r = pixels({{0, 0, 9, 9}});
    r.color_maps = {index_map(2, 8, IndexPlanes::Overlay)};
    EXPECT_EQ(replayed_manifest(r, fast, nullptr).passes[0].shown,
              digest_of_pixel({0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(ManifestMaps, VerifyFindsAnotherMapAndOldManifestsDoNotKnowIt) {
    Recording r = pixels({{1, 0, 0, 0}, {2, 0, 0, 0}});
    r.color_maps = {index_map(4, 8)};
    const Manifest manifest = replayed_manifest(r, fast, nullptr);
    EXPECT_FALSE(manifest.passes[1].color_map);
    EXPECT_EQ(map_of_pass(manifest, 1), &*manifest.passes[0].color_map);
    EXPECT_FALSE(verify(r, manifest, {}, fast, reference).finding);
    r.color_maps[0]->entries[2] = 7;
    const auto finding = verify(r, manifest, {}, fast, reference).finding;
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->what, "the shown picture");
    EXPECT_EQ(finding->pass, 1u);
    r.color_maps.clear();
    EXPECT_EQ(verify(r, manifest, {}, fast, reference).finding->actual, "colours");
    Manifest old = manifest;
    for (ManifestPass& pass : old.passes) {
        pass.shown.reset();
        pass.color_map.reset();
    }
    EXPECT_FALSE(verify(r, old, {}, fast, reference).finding);
}

TEST(ManifestMaps, AreRefusedIfTheyAreNone) {
    Recording r = pixels({{1, 0, 0, 0}});
    r.color_maps = {index_map(1, 8)};
    const std::string json = to_json(replayed_manifest(r, fast, nullptr));
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string text = json;
        text.replace(text.find(from), from.size(), to);
        return test::error_of([&] { manifest_from_json(text); });
    };
    EXPECT_EQ(refusal("000000030201", "000000"), "a colour map of 1 entries; expected 2");
    EXPECT_EQ(refusal("000000030201", "00000003x201"),
              "pass 0 color_map 'entries' has '03x201'; expected six digits an entry");
    EXPECT_EQ(refusal("\"window\"", "\"roof\""),
              "pass 0 color_map 'planes' is 'roof'; expected window, overlay, underlay or pop-up");
}

}  // namespace gw::inspect
