// Commands on a recording in colour map mode name indices and entries of the map, never four channels.
#include "inspect/recording/recording.h"
#include "tests/apps/support/command_test.h"

#include <map>
#include <regex>

namespace gw::apps {

class ColorMapRecordings : public CommandTest {
protected:
    /// Two pixels: index 37, and `second`; entry 258 of the map is `blue` after 1 2.
    void write_recording(const std::string& file, unsigned second, unsigned blue = 3) const {
        inspect::Recording r;
        r.width = 2;
        r.height = 1;
        r.lists.resize(1);
        r.lists[0].add(BeginPass{"frame 0"});
        r.lists[0].add(Clear{.planes = mask_of(Plane::Color),
                             .color = {float(second & 255) / 255, float(second >> 8) / 255, 0, 1}});
        const Rgba right{std::uint16_t(second & 255), std::uint16_t(second >> 8), 0, 255};
        r.lists[0].add(WritePixels{.rect = {0, 0, 2, 1}, .colors = {{37, 0, 0, 255}, right}});
        inspect::ColorMap map{.bits = 12, .entries = std::vector<std::uint32_t>(4096)};
        map.entries[37] = 200 | 100 << 8 | 50 << 16;
        map.entries[258] = 1 | 2 << 8 | blue << 16;
        map.entries[259] = 7 | 8 << 8 | 9 << 16;
        r.color_maps = {map};
        const auto bytes = inspect::encode(r);
        write(file, {bytes.begin(), bytes.end()});
    }
    /// What a command says, which is four numbers nowhere.
    std::string said(const std::vector<std::string>& words) const {
        const Outcome outcome = gw(words);
        const std::string all = outcome.out + outcome.err;
        const std::regex channels(R"([\d.]+ [\d.]+ [\d.]+ [\d.]+)");
        EXPECT_FALSE(std::regex_search(all, channels)) << words[0] << ":\n" << all;
        return all;
    }
};

TEST_F(ColorMapRecordings, AreReadInIndicesByEveryCommand) {
    write_recording("a.gwt", 258);
    write_recording("b.gwt", 259);
    ASSERT_EQ(gw({"verify", "a.gwt", "a.json", "--update"}).code, 0);
    const std::string right = "index 258 through map entry 258 (1 2 3)",
                      wrong = "index 259 through map entry 259 (7 8 9)";
    struct Told {
        std::vector<std::string> words;
        std::vector<std::string> parts;  ///< that it says
    };
    const std::map<std::string, Told> commands{
        {"pixel", {{"a.gwt", "1", "0"}, {"index 0 > 258 through map entry 258 (1 2 3)"}}},
        {"diff",
         {{"a.gwt", "b.gwt"},
          {"(Clear), color: expected index 258, got index 259",
           "expected " + right + ", got " + wrong, "1 0: " + right + ", " + wrong,
           "A: pass frame 0, command 1, outcome Clear, colour index 0 > 258 through"}}},
        {"verify", {{"b.gwt", "a.json"}, {"expected " + right + ", got " + wrong}}},
        {"replay", {{"a.gwt", "--machine", "both", "-o", "a.png", "--planes", "a"}, {}}},
        {"maps", {{"a.gwt", "-o", "maps"}, {}}},
        {"inspect", {{"a.gwt", "-o", "page"}, {}}}};
    for (const auto& [command, told] : commands) {
        std::vector<std::string> words{command};
        words.insert(words.end(), told.words.begin(), told.words.end());
        const std::string all = said(words);
        for (const std::string& part : told.parts)
            EXPECT_NE(all.find(part), std::string::npos) << command << ":\n" << all;
    }
    // Another command that takes a recording stands above too.
    const std::string help = gw({"--help"}).out;
    std::smatch row;
    const std::regex name(R"(\n  ([a-z][a-z-]+) )");
    for (auto at = help.cbegin() + long(help.find("Subcommands:"));
         std::regex_search(at, help.cend(), row, name); at = row[0].second - 1) {
        const std::string usage = gw({row[1], "--help"}).out;
        if (usage.find("  RECORDING ") != std::string::npos) {
            EXPECT_TRUE(commands.contains(row[1])) << row[1];
        }
    }
}

TEST_F(ColorMapRecordings, ThatDifferInTheMapAloneDiffer) {
    write_recording("a.gwt", 258);
    write_recording("b.gwt", 258, 4);
    EXPECT_EQ(gw({"diff", "a.gwt", "a.gwt"}).code, 0);
    const Outcome outcome = gw({"diff", "a.gwt", "b.gwt", "--quiet"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out,
              "colour map: pass 0 'frame 0', entry 258: expected 1 2 3, got 1 2 4\n"
              "result: the same planes after every pass that both have\n");
}

TEST_F(ColorMapRecordings, ManifestsNameIndicesOfTheirMaps) {
    write_recording("a.gwt", 258);
    write_recording("b.gwt", 259);
    write_recording("c.gwt", 258, 4);
    for (const std::string name : {"a", "b", "c"})
        ASSERT_EQ(gw({"verify", name + ".gwt", name + ".json", "--update"}).code, 0);
    EXPECT_NE(said({"diff", "a.json", "b.json"})
                  .find("1 0: index 258 through map entry 258 (1 2 3), index 259 through map entry "
                        "259 (7 8 9)"),
              std::string::npos);
    const Outcome outcome = gw({"diff", "a.json", "c.json"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("the shown picture"), std::string::npos) << outcome.out;
    EXPECT_EQ(gw({"verify", "c.gwt", "a.json"}).code, 3);
    EXPECT_EQ(gw({"verify", "c.gwt", "c.json"}).code, 0);
}

}  // namespace gw::apps
