// Claims: a recording keeps the calls of its commands, and pixel, diff and verify name them; without
// calls its bytes are those that they always were; no table does harm.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "inspect/compare/difference.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/recording/content.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/text/call_text.h"
#include "tests/inspect/same.h"
#include "tests/inspect/three_passes.h"

#include <sstream>

namespace gw::inspect {
namespace {

/// List 3 in list 7, played by call 14 of the frame: calls of the commands of three_passes.
CallTable some_calls() {
    CallTable table{.functions = {"glCallList", "glDrawPixels"}, .sources = {"main+0x1f in gears"}};
    table.lists = {{7, {.number = 14, .function = 0, .source = 0}},
                   {3, {.number = 2, .function = 0, .list = 0}}};
    table.runs = {{.command = 1, .call = {.number = 9, .function = 1, .list = 1}},
                  {.command = 3, .call = {.number = 30, .function = 1}}};
    return table;
}

Recording called() {
    Recording r = three_passes();
    r.calls = {some_calls()};
    return r;
}

constexpr const char* nested =
    "call 14 glCallList at main+0x1f in gears, list 7: call 2 glCallList, list 3: call 9 "
    "glDrawPixels";

std::string refusal_of(const CallTable& table) {
    Recording r = three_passes();
    r.calls = {table};
    try {
        decode(encode(r));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST(Calls, AreKept) {
    const Recording back = decode(encode(called()));
    ASSERT_EQ(back.calls.size(), 2u);
    EXPECT_EQ(back.calls[0], some_calls());
    EXPECT_EQ(back.calls[1], CallTable{});
}

TEST(Calls, AreKeptByStreams) {
    std::ostringstream out;
    Recording heading = three_passes();
    heading.lists.clear();
    StreamWriter writer(out, heading);
    const Recording r = called();
    writer.open("a", 8, 6);
    writer.add("a", r.lists[1]);
    writer.add("a", r.lists[0], r.calls[0]);
    writer.finish();
    std::istringstream in(out.str());
    const Stream stream = decode_stream(in);
    ASSERT_EQ(stream.windows.at(0).recording.calls.size(), 2u);
    EXPECT_EQ(stream.windows[0].recording.calls[1], some_calls());
}

/// The digest of the bytes before there were calls.
TEST(Calls, LeaveRecordingsWithoutThemAsTheyWere) {
    Recording empty = three_passes();
    empty.calls.resize(2);
    EXPECT_EQ(encode(empty), encode(three_passes()));
    EXPECT_EQ(to_string(digest_of_bytes(encode(three_passes()))),
              "c6d6f4080d9a2fdf356d969a785aecb6");
}

TEST(Calls, AreNamedWithTheirLists) {
    const Recording r = called();
    const CallNames names(r);
    EXPECT_FALSE(names.empty());
    EXPECT_EQ(names.text(0), "");
    EXPECT_EQ(names.text(1), nested);
    EXPECT_EQ(names.text(2), "");
    EXPECT_EQ(names.text(3), "call 30 glDrawPixels");
    EXPECT_EQ(names.text(5), "") << "of a list without a table";
    EXPECT_TRUE(CallNames(three_passes()).empty());
}

TEST(Calls, OfPrimitivesGoOnInSteps) {
    Recording r;
    const std::vector<vec3> corners(24, vec3(0));
    r.lists.resize(1);
    r.lists[0].add(Draw{.mesh = make_mesh({.primitive = Primitive::Quads, .positions = corners})});
    CallTable table{.functions = {"glVertex3f"}};
    table.runs = {{.first = 0, .call = {.number = 4}, .step = 5, .ordinal = 0},
                  {.first = 4, .call = {.number = 40}, .step = 4, .ordinal = 2}};
    r.calls = {table};
    const CallNames names(r);
    EXPECT_EQ(names.text(0, 0), "call 4 glVertex3f, quad 0");
    EXPECT_EQ(names.text(0, 3), "call 19 glVertex3f, quad 3");
    EXPECT_EQ(names.text(0, 4), "call 40 glVertex3f, quad 2");
    EXPECT_EQ(names.text(0, 5), "call 44 glVertex3f, quad 3");
}

TEST(Calls, StandInHistories) {
    const auto events = pixel_history(called(), 3, 2);
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[0].call, nested);
    EXPECT_EQ(events[1].call, "call 30 glDrawPixels");
    EXPECT_EQ(events[2].call, "");
    const auto rows = history_rows(events);
    EXPECT_EQ(rows[0].back(), "call");
    EXPECT_EQ(rows[1].back(), nested);
    EXPECT_EQ(rows[3].back(), "-");
    EXPECT_NE(history_rows(pixel_history(three_passes(), 3, 2))[0].back(), "call");
}

/// Call 12 clears the stencil to `value`, call 101 the colour to white.
Recording cleared_by_calls(int value) {
    Recording r;
    r.width = r.height = 1;
    r.lists.resize(1);
    r.lists[0].add(BeginPass{"frame 0"});
    r.lists[0].add(Clear{.planes = mask_of(Plane::Stencil), .stencil = value});
    r.lists[0].add(Clear{.planes = mask_of(Plane::Color), .color = {1, 1, 1, 1}});
    CallTable table{.functions = {"glClear"}};
    table.runs = {{.command = 1, .call = {.number = 12}}, {.command = 2, .call = {.number = 101}}};
    r.calls = {table};
    return r;
}

TEST(Calls, ThatChangedThePlaneAreNamedNotThoseThatChangedAnother) {
    ValuesWriter values(1, 1);
    const Manifest manifest = replayed_manifest(cleared_by_calls(3), maker_of("fast"), &values);
    const auto v = verify(cleared_by_calls(4), manifest, values.finish(), maker_of("fast"),
                          maker_of("reference"));
    ASSERT_TRUE(v.finding);
    EXPECT_EQ(v.finding->what, "plane stencil");
    EXPECT_EQ(v.finding->notes.back(), "last written by call 12 glClear");
}

/// A pixel is drawn to the back buffer by call 12, to the front one by 101, and both are exchanged.
Recording exchanged(float back) {
    Recording r;
    r.width = r.height = 1;
    r.profile.color_planes = 2;
    r.lists.resize(1);
    r.lists[0].add(BeginPass{"frame 0"});
    for (const auto& [buffer, red] :
         {std::pair{DrawBuffer::Back, back}, {DrawBuffer::Front, 1.0f}}) {
        r.lists[0].add(SetState{State{.draw_buffer = buffer}});
        r.lists[0].add(Clear{.planes = mask_of(Plane::Color), .color = {red, 0, 0, 1}});
    }
    r.lists[0].add(SwapBuffers{});
    CallTable table{.functions = {"glClear", "glXSwapBuffers"}};
    table.runs = {{.command = 2, .call = {.number = 12}},
                  {.command = 4, .call = {.number = 101}},
                  {.command = 5, .call = {.number = 102, .function = 1}}};
    r.calls = {table};
    return r;
}

TEST(Calls, ThatDrewToTheOtherBufferAreNamedAfterAnExchange) {
    ValuesWriter values(1, 1, 2);
    const Manifest manifest = replayed_manifest(exchanged(0.25f), maker_of("fast"), &values);
    const auto v =
        verify(exchanged(0.5f), manifest, values.finish(), maker_of("fast"), maker_of("reference"));
    ASSERT_TRUE(v.finding);
    EXPECT_EQ(v.finding->what, "plane color");
    EXPECT_EQ(v.finding->notes.back(), "last written by call 12 glClear");
}

TEST(Calls, StandInDifferences) {
    Recording other = called();
    too_green(other.lists[0].commands[3]);
    const auto commands = first_command_difference(called(), other);
    ASSERT_TRUE(commands);
    EXPECT_EQ(commands->notes,
              (std::vector<std::string>{"A: call 30 glDrawPixels", "B: call 30 glDrawPixels"}));
    EXPECT_NE(first_event_difference(called(), other, 3, 2).find(", call call 30 glDrawPixels"),
              std::string::npos);
    ValuesWriter values(8, 6);
    const Manifest manifest = replayed_manifest(called(), maker_of("fast"), &values);
    const auto v =
        verify(other, manifest, values.finish(), maker_of("fast"), maker_of("reference"));
    ASSERT_TRUE(v.finding);
    EXPECT_EQ(v.finding->notes.back(), "last written by call 30 glDrawPixels");
}

TEST(Calls, ThatNameWhatThereIsNotAreRefused) {
    const auto changed = [](const auto& change) {
        CallTable table = some_calls();
        change(table);
        return refusal_of(table);
    };
    EXPECT_EQ(refusal_of(some_calls()), "none");
    EXPECT_EQ(changed([](auto& t) { t.runs[0].call.function = 2; }),
              "list 0: a call of function 2; there are 2");
    EXPECT_EQ(changed([](auto& t) { t.lists[0].caller.source = 1; }),
              "list 0: a call of source 1; there are 1");
    EXPECT_EQ(changed([](auto& t) { t.runs[0].call.list = 2; }),
              "list 0: a call of list 2; there are 2");
    EXPECT_EQ(changed([](auto& t) { t.lists[1].caller.list = 1; }),
              "list 0: a call of list 1; there are 1");
    EXPECT_EQ(changed([](auto& t) { t.runs[1].command = 4; }),
              "list 0: a call of command 4; there are 4");
    EXPECT_EQ(changed([](auto& t) { t.runs[1].command = 1; }),
              "list 0: calls that are not in the order of their commands");
}

TEST(Calls, AndAllElseThatNoMachineReadsAreNotInTheDigestOfCommands) {
    const Recording recording = three_passes();
    const auto digest_after = [&](auto change) {
        Recording other = recording;
        change(other);
        return replayed_manifest(other, maker_of("fast", 1), nullptr).commands_hash;
    };
    const Digest digest = digest_after([](Recording&) {});
    EXPECT_EQ(digest_after([](Recording& r) { r.producer = r.scene = r.renderer = "o"; }), digest);
    EXPECT_EQ(digest_after([](Recording& r) { r.sets.clear(); }), digest);
    EXPECT_EQ(digest_after([](Recording& r) { r.calls = {some_calls()}; }), digest);
    const ColorMap map{.bits = 1, .bits_in_r = 1, .entries = {1, 2}};
    EXPECT_EQ(digest_after([&](Recording& r) { r.color_maps = {map}; }), digest);
    EXPECT_NE(digest_after([](Recording& r) { r.lists[0].add(gw::Clear{}); }), digest);
    EXPECT_NE(digest_after([](Recording& r) { ++r.width; }), digest);
}

}  // namespace gw::inspect
