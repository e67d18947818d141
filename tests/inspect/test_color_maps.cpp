// Claims: a recording keeps the maps through which a screen shows indices; the histories of pixels and
// pictures use the map at the end of the pass.
#include "gw/error.h"
#include "inspect/compare/difference.h"
#include "inspect/compare/verify.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/shown_maps.h"
#include "tests/inspect/three_passes.h"
#include "tests/inspect/wrong_machine.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace gw::inspect {
namespace {

/// Entry i is (i, 2 i, 3 i) + `more`, 8 bits each.
ColorMap map_of(int bits, unsigned more = 0) {
    ColorMap map{.bits = bits};
    for (unsigned i = 0; i < 1u << bits; ++i)
        map.entries.push_back(((i + more) & 255) | (2 * i & 255) << 8 | (3 * i & 255) << 16);
    return map;
}

/// One pixel, a pass of two lists, then one of one: indices 1, 0x102, then 5.
Recording indices() {
    Recording r;
    r.width = r.height = 1;
    r.lists.resize(3);
    const auto write = [](const Rgba& color) {
        return WritePixels{.rect = {0, 0, 1, 1}, .colors = {color}};
    };
    r.lists[0].add(BeginPass{"frame 0"});
    r.lists[0].add(write({1, 0, 0, 255}));
    r.lists[1].add(write({2, 1, 0, 255}));
    r.lists[2].add(BeginPass{"frame 1"});
    r.lists[2].add(write({5, 0, 0, 255}));
    r.color_maps = {map_of(12, 7), map_of(12), {}};
    return r;
}

std::string refusal_of(const ColorMap& map) {
    Recording r = three_passes();
    r.color_maps = {map};
    try {
        decode(encode(r));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST(ColorMaps, AreKept) {
    const Recording back = decode(encode(indices()));
    ASSERT_EQ(back.color_maps.size(), 3u);
    EXPECT_EQ(back.color_maps[0], map_of(12, 7));
    EXPECT_EQ(back.color_maps[1], map_of(12));
    EXPECT_FALSE(back.color_maps[2]);
}

TEST(ColorMaps, AreKeptByStreams) {
    std::ostringstream out;
    const Recording r = indices();
    Recording heading;
    StreamWriter writer(out, heading);
    writer.open("a", 1, 1);
    for (std::size_t i = 0; i < r.lists.size(); ++i)
        writer.add("a", r.lists[i], {}, r.color_maps[i]);
    writer.finish();
    std::istringstream in(out.str());
    EXPECT_EQ(decode_stream(in).windows.at(0).recording.color_maps, r.color_maps);
}

TEST(ColorMaps, LeaveRecordingsWithoutThemAsTheyWere) {
    Recording none = three_passes();
    none.color_maps.resize(2);
    EXPECT_EQ(encode(none), encode(three_passes()));
}

TEST(ColorMaps, WithoutAnEntryForEachIndexAreRefused) {
    EXPECT_EQ(refusal_of(map_of(12)), "none");
    EXPECT_EQ(refusal_of(ColorMap{}), "none");
    ColorMap map = map_of(2);
    map.entries.pop_back();
    EXPECT_EQ(refusal_of(map), "list 0: a colour map of 3 entries; expected 4");
    map = {.entries = {0}};
    EXPECT_EQ(refusal_of(map), "list 0: a colour map of 1 entries; expected 0");
    map = {.bits = 17};
    EXPECT_EQ(refusal_of(map), "list 0: a colour map of 17 bits; expected 0 to 16");
    map = map_of(2);
    map.bits_in_r = 0;
    EXPECT_EQ(refusal_of(map), "list 0: a colour map of 0 bits in R; expected 1 to 16");
    map = map_of(2);
    map.planes = static_cast<IndexPlanes>(4);
    EXPECT_EQ(refusal_of(map), "list 0: the value 4 of an enumeration; expected 0 to 3");
}

TEST(ColorMaps, OfAPassAreThoseAtItsEnd) {
    const Recording r = indices();
    const ShownMaps maps(r);
    EXPECT_EQ(maps.of(1), &*r.color_maps[1]) << "of the pass's second list";
    EXPECT_EQ(maps.of(2), &*r.color_maps[1]);
    EXPECT_EQ(maps.of(4), &*r.color_maps[1]) << "a list without a map keeps the one before";
    EXPECT_EQ(maps.last(), &*r.color_maps[1]);
    Recording off = r;
    off.color_maps[2] = ColorMap{};
    EXPECT_EQ(ShownMaps(off).last(), nullptr);
    EXPECT_EQ(ShownMaps(off).of(4), nullptr);
    EXPECT_EQ(ShownMaps(three_passes()).of(1), nullptr);
}

// Index 0x102 = 258: entry (258, 516, 774) mod 256.
TEST(ColorMaps, StandInHistories) {
    const Recording r = indices();
    const auto events = pixel_history(r, 0, 0);
    ASSERT_EQ(events.size(), 3u);
    const auto rows = history_rows(events);
    EXPECT_EQ(rows[1][8], "index 0 > 1 through map entry 1 (1 2 3)");
    EXPECT_EQ(rows[2][8], "index 1 > 258 through map entry 258 (2 4 6)");
    EXPECT_EQ(rows[2][6], "index 258");
    EXPECT_EQ(rows[3][8], "index 258 > 5 through map entry 5 (5 10 15)");
    const auto json = history_json(r, 0, 0, events)["events"][1];
    EXPECT_EQ(json["index_planes"], "window");
    EXPECT_EQ(json["index"], 258);
    EXPECT_EQ(json["before"]["index"], 1);
    EXPECT_EQ(json["after"]["index"], 258);
    EXPECT_EQ(json["after"]["entry"], (std::vector<int>{2, 4, 6}));
    EXPECT_EQ(json["after"]["color"], (std::vector<int>{2, 1, 0, 255}));
    EXPECT_FALSE(history_json(three_passes(), 3, 2,
                              pixel_history(three_passes(), 3, 2))["events"][1]["after"]
                     .contains("index"));
}

// The last list writes index 6 in place of 5.
TEST(ColorMaps, StandInFindings) {
    const MachineMaker fast = maker_of("fast", 1);
    Recording other = indices();
    const auto one_more = [](Command& command) {
        if (auto* pixels = std::get_if<WritePixels>(&command); pixels && pixels->colors[0][0] == 5)
            pixels->colors[0][0] = 6;
    };
    for (Command& command : other.lists[2].commands) one_more(command);
    const std::string five = "index 5 through map entry 5 (5 10 15)",
                      six = "index 6 through map entry 6 (6 12 18)";
    const auto machines = compare_machines(indices(), fast, wrong(one_more));
    ASSERT_TRUE(machines);
    EXPECT_EQ(machines->expected, five);
    EXPECT_EQ(machines->actual, six);
    ValuesWriter values(1, 1);
    const Manifest manifest = replayed_manifest(indices(), fast, &values);
    const auto verified = verify(other, manifest, values.finish(), fast, fast);
    ASSERT_TRUE(verified.finding);
    EXPECT_EQ(verified.finding->expected, five);
    EXPECT_EQ(verified.finding->actual, six);
    const Recording a = indices(), b = other;
    const auto result = first_result_difference(a, b, fast);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->finding.expected, five);
    EXPECT_EQ(result->finding.actual, six);
    EXPECT_EQ(wrong_pixel_lines(*result, 5), "0 0: " + five + ", " + six + "\n");
    const auto commands = first_command_difference(a, b);
    ASSERT_TRUE(commands);
    EXPECT_EQ(commands->expected, "index 5");
    EXPECT_EQ(commands->actual, "index 6");
    EXPECT_FALSE(first_map_difference(a, b));
}

TEST(ColorMaps, ThatDifferAreNamedByTheirFirstEntry) {
    const Recording a = indices();
    Recording b = indices();
    b.color_maps[1]->entries[300] = 1 | 2 << 8 | 3 << 16;
    auto found = first_map_difference(a, b);
    ASSERT_TRUE(found);
    EXPECT_EQ(text(*found, 1), "pass 0 'frame 0', entry 300: expected 44 88 132, got 1 2 3\n");
    b.color_maps[1] = ColorMap{};
    found = first_map_difference(a, b);
    ASSERT_TRUE(found);
    EXPECT_EQ(text(*found, 1),
              "pass 0 'frame 0', kind: expected window indices of 12 bits, 8 in R, got colours\n");
}

TEST(ColorMaps, OfPlanesAboveNameThemAndShowWhatIsBelow) {
    ColorMap map = map_of(2);
    map.planes = IndexPlanes::Overlay;
    EXPECT_EQ(index_change_text(map, {0, 0, 0, 0}, {2, 0, 0, 0}),
              "overlay index 0 > 2 through map entry 2 (2 4 6)");
    EXPECT_EQ(index_change_text(map, {2, 0, 0, 0}, {4, 0, 0, 0}),
              "overlay index 2 > 0, which shows what is below");
    map.planes = IndexPlanes::PopUp;
    EXPECT_EQ(index_text(map, {3, 0, 0, 0}), "pop-up index 3");
    map.entries[0] = 0xFFFFFF;
    EXPECT_EQ(through_map({{4, 0, 0, 0}, {1, 9, 9, 9}}, map),
              (std::vector<Rgba>{{0, 0, 0, 255}, {1, 2, 3, 255}}));
}

}  // namespace gw::inspect
