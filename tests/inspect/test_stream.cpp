// Claims: a stream gives the recordings of its windows, also if it is cut short; the writer's
// memory has a bound; no bytes do harm.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "gw/machine.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/player.h"
#include "tests/inspect/same.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace gw::inspect {
namespace {

/// The list without a query that its end leaves open: it may follow itself.
CommandList with_ended_queries(CommandList list) {
    const Query* last = nullptr;
    for (const Command& command : list.commands)
        if (const auto* query = std::get_if<Query>(&command)) last = query;
    if (last && last->begin) list.add(Query{.key = last->key, .begin = false});
    return list;
}

Recording stream_heading() {
    return {.producer = "test", .scene = "s", .renderer = "r", .profile = opengl()};
}

Draw drawn_points(float x) {
    return {.mesh = make_mesh({.primitive = Primitive::Points, .positions = {{x, 0, 0}}})};
}

CommandList frame(int number, Command command) {
    CommandList list;
    list.add(BeginPass{"frame " + std::to_string(number)});
    list.add(std::move(command));
    return list;
}

Stream decoded_stream(const std::string& bytes, const Limits& limits = {}) {
    std::istringstream in(bytes);
    return decode_stream(in, limits);
}

std::string stream_refusal(const std::string& bytes, const Limits& limits = {}) {
    try {
        decoded_stream(bytes, limits);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

std::string message_of(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

/// Two windows in turn, three frames each, of shared and of new meshes.
std::string two_windows() {
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    writer.open("a", 4, 3);
    writer.open("b", 8, 8);
    const Draw shared = drawn_points(0);
    for (int i = 0; i < 3; ++i) {
        writer.add("a", frame(i, shared));
        writer.add("b", frame(i, drawn_points(float(i) / 4)));
    }
    writer.close("a");
    writer.finish();
    return out.str();
}

std::size_t lists_of(const Stream& stream) {
    std::size_t count = 0;
    for (const WindowRecording& w : stream.windows) count += w.recording.lists.size();
    return count;
}

}  // namespace

TEST(Streams, GiveTheListsOfEachWindow) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        std::vector<fuzz::Case> cases;
        for (std::uint64_t i = 0; i < 4; ++i) {
            cases.push_back(fuzz::make_case(suite, i));
            cases.back().profile = cases.front().profile;
        }
        std::ostringstream out;
        StreamWriter writer(out,
                            {.producer = "p", .profile = cases[0].profile, .sets = {{"a", "b"}}});
        cases[0].list = with_ended_queries(std::move(cases[0].list));
        const fuzz::Case& c = cases[0];
        writer.open("x", c.width, c.height);
        writer.open("y", c.width, c.height);
        for (int i = 0; i < 3; ++i) {
            writer.add("x", c.list);
            if (i == 1) writer.add("y", c.list);
        }
        writer.finish();
        const Stream stream = decoded_stream(out.str());
        EXPECT_EQ(stream.cut, "");
        ASSERT_EQ(stream.windows.size(), 2u);
        for (const auto& [window, lists] : {std::pair(0u, 3u), {1u, 1u}}) {
            const Recording& r = stream.windows[window].recording;
            EXPECT_EQ(r.producer, "p");
            EXPECT_EQ(r.profile, c.profile);
            EXPECT_EQ(r.width, c.width);
            EXPECT_EQ(r.height, c.height);
            EXPECT_EQ(r.sets, (std::vector<ParameterSet>{{"a", "b"}}));
            ASSERT_EQ(r.lists.size(), lists);
            for (const CommandList& list : r.lists) ASSERT_TRUE(same(list, c.list)) << suite.name;
        }
    }
}

TEST(Streams, AWindowIsAMachineOfItsOwn) {
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    writer.open("w", 4, 3);
    writer.add("w", frame(0, drawn_points(0)));
    writer.open("w", 5, 6);  // resized
    writer.add("w", frame(1, drawn_points(0)));
    writer.close("w");
    writer.open("w", 7, 8);
    writer.finish();
    const Stream stream = decoded_stream(out.str());
    ASSERT_EQ(stream.windows.size(), 3u);
    const std::vector<std::string> names{"w", "w 2", "w 3"};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(stream.windows[i].name, names[i]);
    EXPECT_EQ(stream.windows[1].recording.height, 6);
    EXPECT_EQ(stream.windows[1].recording.lists.size(), 1u);
    EXPECT_TRUE(stream.windows[2].recording.lists.empty());
    EXPECT_EQ(choose_window(stream, "w 2").width, 5);
    EXPECT_EQ(choose_window(stream, "2").width, 7);
    EXPECT_EQ(message_of([&] { choose_window(stream, ""); }),
              "several windows; expected --window with the name or the number of one of these: 'w' "
              "(4 x 3), 'w 2' (5 x 6), 'w 3' (7 x 8)");
    EXPECT_TRUE(message_of([&] { choose_window(stream, "3"); }).starts_with("--window '3': "));
    for (const char* window : {"", "w"})
        EXPECT_EQ(message_of([&] { choose_window(Stream(), window); }),
                  "the recording has no frame; expected a program that draws");
}

TEST(Streams, ReplayAsTheyWereExecuted) {
    const auto machine = make_reference(opengl(), 8, 8);
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    writer.open("main", 8, 8);
    StreamRecorder recorder(*machine, writer, "main");
    for (int i = 0; i < 3; ++i) recorder.execute(frame(i, drawn_points(float(i) / 4)));
    writer.finish();
    const Recording r = choose_window(decoded_stream(out.str()), "");
    const auto again = make_reference(opengl(), 8, 8);
    Player(r, *again).play();
    EXPECT_EQ(again->planes(), machine->planes());
    EXPECT_EQ(again->passes(), machine->passes());
    EXPECT_NE(machine->planes(), Planes(8, 8));
}

TEST(Streams, CutShortGiveEverythingUpToTheLastWholeList) {
    const std::string bytes = two_windows();
    ASSERT_EQ(lists_of(decoded_stream(bytes)), 6u);
    std::size_t lists = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string cut = bytes.substr(0, size);
        if (const std::string why = stream_refusal(cut); why != "none") {
            EXPECT_TRUE(size < 8 || why == "cut short before its first part") << why;
            EXPECT_EQ(lists, 0u);
            continue;
        }
        const Stream stream = decoded_stream(cut);
        EXPECT_TRUE(stream.cut.starts_with("cut short after part ")) << size;
        EXPECT_GE(lists_of(stream), lists);
        lists = lists_of(stream);
    }
    EXPECT_EQ(lists, 6u);
    EXPECT_EQ(stream_refusal(bytes.substr(0, 20)), "cut short before its first part");
    EXPECT_EQ(stream_refusal(bytes + "x"), "damaged after part 9");
}

TEST(Streams, DamagedBytesAreRefusedOrEndIt) {
    const std::string bytes = two_windows();
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const char flip : {1, -128}) {
            std::string damaged = bytes;
            damaged[i] = static_cast<char>(damaged[i] ^ flip);
            if (stream_refusal(damaged) != "none") continue;
            EXPECT_NE(decoded_stream(damaged).cut, "") << i;
        }
}

TEST(Streams, PartsMustFitTogether) {
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    EXPECT_EQ(message_of([&] { writer.add("w", {}); }), "window 'w' is not open");
    EXPECT_EQ(message_of([&] { writer.close("w"); }), "window 'w' is not open");
    EXPECT_EQ(message_of([&] { writer.open("", 1, 1); }), "a window without a name");
    writer.open("w", 5000, 1);
    EXPECT_EQ(stream_refusal(out.str()),
              "part 0: window of 5000 x 1 pixels; expected 1 to 4096 each");
    // The second part alone: its window and its mesh are those of another one.
    StoredValues stored;
    DecodedValues none;
    Part part{.window = "w", .recording = stream_heading()};
    part.recording.lists.push_back(frame(0, drawn_points(0)));
    encode_part(part, stored);
    const auto bytes = encode_part(part, stored);
    EXPECT_NE(message_of([&] { decode_part(bytes, none, {}); }).find("mesh 0; there are 0"),
              std::string::npos);
    Part open{.window = "w", .event = WindowEvent::Open, .recording = stream_heading()};
    open.recording.width = open.recording.height = 1;
    EXPECT_EQ(message_of([&] { decode(encode_part(open, stored)); }),
              "a part of a stream; expected a whole recording");
}

TEST(Streams, ListsMustBeValidAfterThoseBefore) {
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    writer.open("w", 4, 4);
    writer.add("w", frame(0, Accumulate{.value = INFINITY}));
    EXPECT_EQ(stream_refusal(out.str()),
              "window 'w': list 0: command 1 (Accumulate) of pass 'frame 0': value = inf; expected "
              "a finite number");
}

/// By counting entries and bytes: 4,000 frames of one mesh, then of a new mesh each.
TEST(Streams, WritersRememberABoundedNumberOfValues) {
    std::ostringstream out;
    StreamWriter writer(out, stream_heading());
    writer.open("w", 4, 4);
    const Draw shared{.mesh = make_mesh({.positions = std::vector<vec3>(3000, vec3(0.5f))})};
    std::size_t after_ten = 0, bytes_after_ten = 0;
    for (int i = 0; i < 4000; ++i) {
        writer.add("w", frame(i, shared));
        if (i != 9) continue;
        after_ten = writer.remembered();
        bytes_after_ten = out.str().size();
    }
    EXPECT_EQ(writer.remembered(), after_ten);
    EXPECT_GT(bytes_after_ten, 36000u);  // the mesh, once
    EXPECT_LT(out.str().size() - bytes_after_ten, 3990u * 1000);
    std::size_t most = 0;
    for (int i = 0; i < 40000; ++i) {
        writer.add("w", frame(i, drawn_points(float(i))));
        most = std::max(most, writer.remembered());
    }
    EXPECT_LE(most, StoredValues::most + 16);
    EXPECT_GT(most, StoredValues::most);
}

TEST(Streams, AFullDiskIsAnError) {
    std::ofstream full("/dev/full", std::ios::binary);
    ASSERT_TRUE(full.is_open());
    EXPECT_EQ(message_of([&] { StreamWriter(full, stream_heading()); }),
              "the recording cannot be written");
}

}  // namespace gw::inspect
