// Claims: a manifest is as its recording is, comes back from its JSON, and any other machine or
// recording is found out by pass, plane, pixel, both values and stage.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "gw/error.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "test_paths.h"
#include "tests/inspect/same.h"
#include "tests/inspect/three_passes.h"
#include "tests/inspect/wrong_machine.h"

namespace gw::inspect {
namespace {

const MachineMaker fast = maker_of("fast", 1), reference = maker_of("reference");

std::string refusal(const std::string& json) {
    try {
        manifest_from_json(json);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == text.npos ? "nothing to replace" : text.replace(at, from.size(), to);
}

}  // namespace

TEST(Manifest, SaysWhatEachPassIs) {
    Recording recording = three_passes();
    State state;
    state.depth.func = DepthFunc::Equal;
    auto& first = recording.lists[0].commands;
    first.insert(first.begin() + 3, SetState{state});
    const Manifest manifest = replayed_manifest(recording, fast, nullptr);
    ASSERT_EQ(manifest.passes.size(), 3u);
    EXPECT_EQ(manifest.passes[1].set, "(Ka=0, Kd=object)");
    EXPECT_EQ(manifest.passes[1].state, (std::vector<Field>{{"depth.func", "Equal"}}));
    EXPECT_TRUE(manifest.passes[2].state.empty());
    EXPECT_EQ(manifest.passes[1].report.counters.written, 4u);
    EXPECT_NE(manifest.passes[0].report.digests[0], manifest.passes[1].report.digests[0]);
}

TEST(Manifest, IsTheSameFromEachMachineAndInAnyPieces) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording recording = recording_of(fuzz::make_case(suite, 1));
        EXPECT_EQ(replayed_manifest(recording, fast, nullptr),
                  replayed_manifest(recording, reference, nullptr));
        EXPECT_EQ(manifest_of(recording, reports_of(recording, fast)),
                  replayed_manifest(recording, fast, nullptr));
    }
}

TEST(Manifest, ComesBackFromItsJson) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        Manifest manifest =
            replayed_manifest(recording_of(fuzz::make_case(suite, 2)), fast, nullptr);
        manifest.values = "a.values";
        EXPECT_EQ(manifest_from_json(to_json(manifest)), manifest) << suite.name;
    }
}

TEST(Manifest, WrongJsonIsRefusedByMember) {
    const std::string json = to_json(replayed_manifest(three_passes(), fast, nullptr));
    EXPECT_EQ(refusal(json), "none");
    EXPECT_EQ(refusal("[]"), "the manifest is not an object; expected one");
    EXPECT_EQ(refusal("{"), "is not JSON at byte 2; expected a manifest that gw wrote");
    EXPECT_EQ(refusal(std::string(100000, '[')),
              "is not JSON at byte 100001; expected a manifest that gw wrote");
    EXPECT_EQ(refusal("[1e999]"), "has a number beyond 1e308; expected a manifest that gw wrote");
    EXPECT_EQ(refusal(replaced(json, "gw manifest", "other")),
              "the manifest is of another kind; expected \"format\": \"gw manifest\"");
    EXPECT_EQ(refusal(replaced(json, "\"version\": 1", "\"version\": 2")),
              "the manifest is of version 2; expected 1");
    EXPECT_EQ(refusal(replaced(json, "\"width\": 8", "\"width\": 8.5")),
              "the manifest 'width' is 8.5; expected a whole number");
    EXPECT_NE(
        refusal(replaced(json, "\"name\":\"first\",", "")).find("pass 1 has no member 'name'"),
        std::string::npos);
    EXPECT_NE(refusal(replaced(json, "\"written\"", "\"writen\"")).find("pass 1 counters has"),
              std::string::npos);
}

TEST(Verify, WhatAManifestSaysIsSo) {
    const Recording recording = three_passes();
    const Manifest manifest = replayed_manifest(recording, fast, nullptr);
    for (const auto& machine : {fast, reference})
        EXPECT_FALSE(verify(recording, manifest, {}, machine, fast).finding);
}

TEST(Verify, AWrongMachineIsNamedByPixelWithTheHelpOfAnother) {
    const Recording recording = three_passes();
    const Manifest manifest = replayed_manifest(recording, fast, nullptr);
    const Verification v = verify(recording, manifest, {}, wrong(too_green), reference);
    ASSERT_TRUE(v.finding);
    EXPECT_TRUE(v.same_commands);
    EXPECT_EQ(
        text(*v.finding, recording.height),
        "pass 1 'first', plane color, pixel 3 3: expected 100 100 100 255, got 100 101 100 255; stage: "
        "shading, texture, fog, blending or the colour mask\n"
        "  1 pixel of this plane differs\n");
}

TEST(Verify, AnotherRecordingIsNamedByPixelWithTheHelpOfStoredValues) {
    const Recording expected = three_passes();
    ValuesWriter values(expected.width, expected.height);
    const Manifest manifest = replayed_manifest(expected, fast, &values);
    Recording other = three_passes();
    other.lists[0].commands.insert(other.lists[0].commands.begin() + 3,
                                   SetState{State{.depth = {.mask = false}}});
    too_green(other.lists[0].commands[4]);
    const Verification v = verify(other, manifest, values.finish(), fast, reference);
    ASSERT_TRUE(v.finding);
    EXPECT_FALSE(v.same_commands);
    EXPECT_TRUE(v.same_scene);
    EXPECT_EQ(
        text(*v.finding, other.height),
        "pass 1 'first', plane color, pixel 3 3: expected 100 100 100 255, got 100 101 100 255; stage: "
        "shading, texture, fog, blending or the colour mask\n"
        "  state depth.mask: expected as the pass before, got off\n"
        "  1 pixel of this plane differs\n");
}

TEST(Verify, WithoutValuesThePlaneIsNamed) {
    const Manifest manifest = replayed_manifest(three_passes(), fast, nullptr);
    Recording other = three_passes();
    too_green(other.lists[0].commands[3]);
    const Verification v = verify(other, manifest, {}, fast, reference);
    ASSERT_TRUE(v.finding);
    EXPECT_EQ(v.finding->what, "plane color");
    EXPECT_FALSE(v.finding->pixel);
}

TEST(Verify, StatesNamesAndNumbersOfPassesCount) {
    const Manifest manifest = replayed_manifest(three_passes(), fast, nullptr);
    Recording other = three_passes();
    std::get<BeginPass>(other.lists[1].commands[0]).name = "third";
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->what, "name");
    other = three_passes();
    other.sets.clear();
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->what, "parameter set");
    other = three_passes();
    other.lists.pop_back();
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->what, "number of passes");
    other = three_passes();
    other.profile = reality();
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->what, "profile");
}

TEST(Verify, NamesThePassThatIsMissingOrNew) {
    const Manifest manifest = replayed_manifest(three_passes(), fast, nullptr);
    Recording other = three_passes();
    auto& commands = other.lists[0].commands;
    commands.erase(commands.begin() + 2, commands.end());
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->notes.back(),
              "missing: pass 1 'first'");
    other = three_passes();
    other.lists.pop_back();
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->notes,
              std::vector<std::string>{"missing: pass 2 'second'"});
    other = three_passes();
    for (int i = 0; i < 7; ++i) other.lists[1].add(BeginPass{"more"});
    EXPECT_EQ(verify(other, manifest, {}, fast, reference).finding->notes,
              std::vector<std::string>{"not expected: pass 3 'more', 4 'more', 5 'more', 6 'more', "
                                       "7 'more' and 2 more"});
    other = three_passes();
    std::get<BeginPass>(other.lists[1].commands[0]).name = "third";
    EXPECT_EQ(
        verify(other, manifest, {}, fast, reference).finding->notes,
        (std::vector<std::string>{"missing: pass 2 'second'", "not expected: pass 2 'third'"}));
}

TEST(Verify, OfAListThatIsNotValidNamesListPassAndCommand) {
    Recording recording = three_passes();
    recording.lists[0].add(Read{.rect = {0, 0, 100, 100}});
    const auto refusal = [&](const auto& run) -> std::string {
        try {
            run();
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    const std::string begin = "list 0: command 4 (Read) of pass 'first': ";
    EXPECT_TRUE(refusal([&] { replayed_manifest(recording, fast, nullptr); }).starts_with(begin));
    EXPECT_TRUE(refusal([&] { compare_machines(recording, reference, fast); }).starts_with(begin));
    EXPECT_TRUE(refusal([&] { decode(encode(recording)); }).starts_with(begin));
}

TEST(Values, OfVersion1AreReadAsWell) {
    const ManifestFile golden =
        load_manifest(GW_SOURCE_DIR "/examples/golden/goldens/pyramid.json");
    ASSERT_FALSE(golden.values.empty());
    for (std::size_t i = 0; i < golden.manifest.passes.size(); ++i) {
        const Planes planes =
            planes_after(golden.values, golden.manifest.width, golden.manifest.height, i);
        for (const Plane plane : planes_in_order)
            EXPECT_EQ(digest(planes, plane),
                      golden.manifest.passes[i].report.digests[std::size_t(plane)]);
    }
}

TEST(Values, AreThePlanesAfterEachPass) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording recording = recording_of(fuzz::make_case(suite, 4));
        const int colors = recording.profile.color_planes;
        ValuesWriter writer(recording.width, recording.height, colors);
        const Manifest manifest = replayed_manifest(recording, fast, &writer);
        const auto bytes = writer.finish();
        for (std::size_t i = 0; i < manifest.passes.size(); ++i) {
            const Planes planes = planes_after(bytes, recording.width, recording.height, i, colors);
            for (const Plane plane : planes_in_order)
                EXPECT_EQ(digest(planes, plane),
                          manifest.passes[i].report.digests[std::size_t(plane)]);
        }
    }
}

TEST(Values, DamagedBytesNeverDoHarm) {
    const Recording recording = three_passes();
    ValuesWriter writer(recording.width, recording.height);
    replayed_manifest(recording, fast, &writer);
    const auto bytes = writer.finish();
    int refused = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const int flip : {1, 0x80, 0xff}) {
            auto damaged = bytes;
            damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ flip);
            try {
                planes_after(damaged, recording.width, recording.height, 2);
            } catch (const Error&) {
                ++refused;
            }
        }
    EXPECT_GT(refused, 100);
}

}  // namespace gw::inspect
