// gw radiosity --rank: processes that solve together write what one writes; one that is lost or
// differs ends them with a clear line, and the saved state goes on.
#include "apps/radiosity/ranks.h"
#include "gw/error.h"
#include "tests/apps/support/command_test.h"

#include <gtest/gtest.h>

#include <future>

namespace gw::apps {
namespace {

constexpr const char* scene =
    "[camera]\neye = [0, 1, 4]\n"
    "[[object]]\nshape = 'rectangle'\nname = 'floor'\nwidth = 2\ndepth = 2\nmaterial = {Kd = 0.6}\n"
    "[[object]]\nshape = 'rectangle'\nname = 'lamp'\nrotate = [180, 0, 0]\ntranslate = [0, 1, 0]\n"
    "material = {Kd = 0.5, Ke = [1, 0.8, 0.5]}\n"
    "[[object]]\nshape = 'box'\nname = 'box'\nwidth = 0.4\nheight = 0.4\ndepth = 0.4\n"
    "translate = [0.2, 0.3, 0]\nmaterial = {Kd = [0.7, 0.2, 0.2]}\n";

class RankCommand : public CommandTest {
protected:
    RankCommand() { write("s.toml", scene); }

    std::vector<std::string> words(const std::string& folder,
                                   const std::vector<std::string>& more) const {
        std::vector<std::string> all{"radiosity",  "s.toml", "-o",     folder,  "--texels", "6",
                                     "--hemicube", "32",     "--size", "32x32", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::vector<Outcome> together(const std::string& folder,
                                  const std::vector<std::vector<std::string>>& processes) const {
        std::vector<std::future<Outcome>> running;
        for (const std::vector<std::string>& more : processes)
            running.push_back(
                std::async(std::launch::async, [&] { return gw(words(folder, more)); }));
        std::vector<Outcome> outcomes;
        for (auto& one : running) outcomes.push_back(one.get());
        return outcomes;
    }
};

TEST_F(RankCommand, TwoProcessesWriteWhatOneWrites) {
    ASSERT_EQ(gw(words("one", {"--shots", "30", "--save"})).code, 0);
    const auto both = together("two", {{"--rank", "1/2", "--shots", "30", "--save"},
                                       {"--rank", "2/2", "--shots", "30", "--save"}});
    for (const Outcome& outcome : both) EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(both[0].out.find("30 shots"), std::string::npos);
    EXPECT_EQ(both[1].out + both[1].err, "");
    EXPECT_EQ(names("two"), names("one"));
    for (const char* file : {"picture.png", "pixmaps.exr"})
        EXPECT_TRUE(bytes_of(in("two") / file) == bytes_of(in("one") / file)) << file;
}

TEST_F(RankCommand, OneThatIsKilledLeavesAStateThatGoesOn) {
    const std::vector<std::string> endless{"--shots", "1000000", "--save"};
    std::vector<std::string> first = endless, second = endless;
    first.insert(first.end(), {"--rank", "1/2", "--every", "5"});
    second.insert(second.end(), {"--rank", "2/2"});
    auto killed = std::async(std::launch::async, [&] {
        return gw(words("two", second), {.interrupt_when = "two/shot_000010.png"});
    });
    const Outcome left = gw(words("two", first));
    EXPECT_NE(killed.get().code, 0);
    EXPECT_EQ(left.code, 1);
    const std::string has =
        "gw: process 2 of 2 has ended; expected all to go on; two/pixmaps.exr has the ";
    ASSERT_TRUE(left.err.starts_with(has)) << left.err;
    const int shots = std::stoi(left.err.substr(has.size()));
    EXPECT_GE(shots, 10);
    const std::string more = std::to_string(shots + 7);
    ASSERT_EQ(gw(words("two", {"--resume", "--save", "--shots", more})).code, 0);
    ASSERT_EQ(gw(words("one", {"--save", "--shots", more})).code, 0);
    EXPECT_TRUE(bytes_of(in("two/pixmaps.exr")) == bytes_of(in("one/pixmaps.exr")));
}

TEST_F(RankCommand, OneThatDiffersIsRefused) {
    const auto both =
        together("two", {{"--rank", "1/2", "--shots", "20"}, {"--rank", "2/2", "--shots", "12"}});
    for (const Outcome& outcome : both) {
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.err,
                  "gw: process 2 of 2 has another scene, version, state or options; expected the "
                  "same for all\n");
    }
}

TEST_F(RankCommand, WordsOfProcesses) {
    expect_refused(2, words("d", {"--rank", "3/2"}), {"--rank '3': expected a whole number, 1..2"});
    expect_refused(2, words("d", {"--rank", "1"}), {"--rank '1': expected mpi, or I/N as 1/4"});
    expect_refused(2, words("d", {"--rank", "1/2", "--record"}), {"--rank shares shots"});
}

}  // namespace

TEST(Ranks, TellEachOtherWhatTheyHave) {
    const TemporaryFolder folder;
    const auto process = [&](std::size_t number) {
        const auto others = meet({number, 3, true}, folder.path(), "the same");
        std::vector<std::string> heard;
        for (int round = 0; round < 5; ++round) {
            const std::string mine(std::size_t(100'000 * number), char('a' + round));
            for (const std::string& text : others->exchange(mine))
                heard.push_back(text.empty() ? "" : std::to_string(text.size()) + text[0]);
        }
        return heard;
    };
    std::vector<std::future<std::vector<std::string>>> running;
    for (std::size_t i = 0; i < 3; ++i)
        running.push_back(std::async(std::launch::async, process, 2 - i));
    std::vector<std::string> expected;
    for (const char letter : {'a', 'b', 'c', 'd', 'e'})
        expected.insert(expected.end(),
                        {"", "100000" + std::string(1, letter), "200000" + std::string(1, letter)});
    for (auto& one : running) EXPECT_EQ(one.get(), expected);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Ranks, NoticeThatOneHasEnded) {
    const TemporaryFolder folder;
    auto second = std::async(std::launch::async, [&] {
        meet({1, 2, true}, folder.path(), "w")->exchange("once");  // then it goes away
    });
    const auto first = meet({0, 2, true}, folder.path(), "w");
    EXPECT_EQ(first->exchange("mine"), (std::vector<std::string>{"mine", "once"}));
    second.get();
    try {
        first->exchange("again");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "process 2 of 2 has ended; expected all to go on");
    }
}

TEST(Ranks, AStrangerAtTheDoorIsNotLetIn) {
    const TemporaryFolder folder;
    folder.write(".ranks", "127.0.0.1 1 0123");  // of a launch that ended long ago
    auto second = std::async(std::launch::async, [&] {
        return meet({1, 2, true}, folder.path(), "w")->exchange("two");
    });
    const auto first = meet({0, 2, true}, folder.path(), "w");
    EXPECT_EQ(first->exchange("one"), (std::vector<std::string>{"one", "two"}));
    EXPECT_EQ(second.get(), (std::vector<std::string>{"one", "two"}));
}

}  // namespace gw::apps
