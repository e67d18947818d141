// Claims: the log of every algorithm, played, gives its picture; pieces drawn by outline have every
// pixel of their polygon once; the polygons for a program and the documents' examples of steps obey
// steps.schema.json; a bad line is refused with its number, and in
// Japanese.
#include "gw/error.h"
#include "hiddensurface/run/messages.h"
#include "hiddensurface/run/play.h"
#include "hiddensurface/run/step_json.h"
#include "tests/hiddensurface/cases.h"
#include "tests/hiddensurface/step_schema.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;

std::string log_of_run(Trial& trial, const std::string& name, Result& result) {
    StepLog log(Level::Pixel);
    result = trial.run(name, log);
    std::string text = log_header(trial.input, {.algorithm = name}, {}) + "\n";
    for (std::size_t i = 0; i < log.steps().size(); ++i)
        text += to_json(log.steps()[i], i + 1, grid_of(trial.input)) + "\n";
    return text +
           log_end(log.steps().size(), result.counts, grid_of(trial.input),
                   blame_of(log.steps(), result, trial.input.view.width)) +
           "\n";
}

Result play(Trial& trial, const std::string& text) {
    StepLog none;
    Result result =
        run_on(*trial.machine, played(read_play(trial.input, "answer", text)), trial.input, none);
    compare(result, trial.z_buffer.ids, trial.input);
    return result;
}

/// The log without pixels, so that outlines give them.
std::string without_pixels(const std::string& log) {
    std::istringstream lines(log);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        Json json = Json::parse(line);
        json.erase("painted");
        if (!json.contains("log") && !json.contains("end")) text += json.dump() + "\n";
    }
    return text;
}

std::string error_of(const Trial& trial, const std::string& text) {
    try {
        read_play(trial.input, "answer", text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// Two words in a row, but in quotation marks and brackets, where a program's own text stands.
bool has_english_words(const std::string& text) {
    static const std::regex quoted(R"('[^']*'|"[^"]*"|\[[^\]]*\]|\{.*\})"), two("[A-Za-z]+ [a-z]+");
    return std::regex_search(std::regex_replace(text, quoted, ""), two);
}

}  // namespace

TEST(Play, DrawsTheLogOfEveryAlgorithmAgain) {
    for (const auto& make : {case_scene("cycle"), case_scene("pierce"), random_triangles(5, 12)}) {
        Trial trial(make, vgx(), 64, 48);
        for (const Algorithm& algorithm : algorithms()) {
            Result result;
            const std::string log = log_of_run(trial, algorithm.name, result);
            const Result again = play(trial, log);
            EXPECT_EQ(again.ids, result.ids) << algorithm.name;
            EXPECT_EQ(again.counts.passed, result.counts.passed) << algorithm.name;
            EXPECT_EQ(again.counts.planes, result.counts.planes) << algorithm.name;
            EXPECT_EQ(again.counts.depths, result.counts.depths) << algorithm.name;
        }
    }
}

// Cuts through cuts too: no pixel is lost or drawn by both halves.
TEST(Play, GivesPiecesEveryPixelOfTheirPolygonOnce) {
    std::uint64_t splits = 0;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        Trial trial(random_triangles(seed, 8), vgx(), 96, 72);
        for (const char* name : {"newell", "bsp"}) {
            Result result;
            const std::string log = log_of_run(trial, name, result);
            const Result again = play(trial, without_pixels(log));
            splits += again.counts.splits;
            EXPECT_EQ(again.ids, result.ids) << name << ", seed " << seed;
            EXPECT_EQ(again.counts.passed, result.counts.passed) << name << ", seed " << seed;
            EXPECT_EQ(again.counts.wrong, 0u) << name << ", seed " << seed;
        }
    }
    EXPECT_GT(splits, 50u);
}

TEST(Play, GradesEachPolygon) {
    Trial trial(case_scene("cycle"), vgx(), 64, 48);
    const Result result = play(trial,
                               "{\"kind\":\"draw\",\"pieces\":[\"1\"]}\n\n"
                               "{\"kind\":\"draw\",\"pieces\":[\"3\"]}\n");
    const auto grades = grades_of(result, trial.z_buffer.ids);
    ASSERT_EQ(grades.size(), 4u);
    std::uint64_t expected = 0, shown = 0, missing = 0, extra = 0;
    for (const PolygonGrade& grade : grades) {
        expected += grade.expected;
        shown += grade.shown;
        missing += grade.missing;
        extra += grade.extra;
    }
    EXPECT_EQ(expected, 64u * 48u);
    EXPECT_EQ(shown, 64u * 48u);
    EXPECT_EQ(missing, result.counts.wrong);
    EXPECT_EQ(extra, result.counts.wrong);
    EXPECT_EQ(grades[2].id, 2u);
    EXPECT_EQ(grades[2].shown, 0u);
    EXPECT_EQ(grades[2].missing, grades[2].expected);
    EXPECT_GT(grades[2].missing, 50u);
}

TEST(Play, CountsSortsSplitsAndWhatTheProgramCounts) {
    Trial trial(case_scene("cycle"), vgx(), 64, 48);
    const Result result =
        play(trial,
             R"({"kind":"sort","pieces":["1","2"],"counts":{"keys":3}})"
             "\n"
             R"({"kind":"split","pieces":["1"],"made":[{"name":"1a","outline":[[[0,0,0],[512,0,0],)"
             R"([512,512,0]]]}],"counts":{"keys":7,"sorts":1}})");
    EXPECT_EQ(result.counts.sorts, 1u);
    EXPECT_EQ(result.counts.splits, 1u);
    EXPECT_EQ(result.counts.keys, 7u);
}

TEST(Play, GivesProgramsPolygonsThatObeyTheSchema) {
    const StepSchema schema("polygons_file"), answers("answer");
    const Trial trial(case_scene("solids"), vgx(), 64, 48);
    const std::string text = polygons_json(trial.input, {{1, "#ff0000"}});
    EXPECT_TRUE(schema.holds_for(text));
    const Json json = Json::parse(text);
    EXPECT_EQ(json["size"], Json({64, 48}));
    EXPECT_EQ(json["polygons"].size(), trial.input.polygons.size());
    EXPECT_EQ(json["polygons"][0]["color"], "#ff0000");
    EXPECT_FALSE(schema.holds_for("{}"));
    EXPECT_TRUE(answers.holds_for(R"({"kind":"draw","pieces":["1"]})"));
    EXPECT_FALSE(answers.holds_for(R"({"kind":"paint","pieces":["1"]})"));
    EXPECT_FALSE(answers.holds_for(R"({"kind":"draw","piece":"1"})"));
}

TEST(Play, RefusesABadLineByItsNumber) {
    const Trial trial(case_scene("cycle"), vgx(), 64, 48);
    const std::string good = "{\"kind\":\"draw\",\"pieces\":[\"1\"]}\n";
    struct Bad {
        std::string line;
        const char* message;
    };
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    const Bad all[] = {
        {"draw 1", "not JSON at column 1"},
        {R"({"kind":"draw","pieces":["1"])", "ends too early; expected a whole object"},
        {R"({"kind":"sort","values":{"z":NaN}})", "not JSON at column 30"},
        {R"({"kind":"sort","values":{"z":1e999}})", "too large; expected numbers of at most 1e15"},
        {R"({"kind":"sort","values":{"z":1e16}})", "'z' is 1e+16; expected a number of at most"},
        {R"({"kind":"sort","values":{"z":null}})", "'z' is null; expected a number"},
        {R"(["draw"])", "a line with a list; expected a step"},
        {deep, "a line with a list; expected a step"},
        {R"({"kind":"draw","pieces":)" + deep + "}", "'pieces' is a list; expected text"},
        {R"({"pieces":["1"]})", "a step without 'kind'; expected compare, decide"},
        {R"({"kind":"paint"})", "'kind' is \"paint\"; expected one of compare, decide"},
        {R"({"kind":["draw"]})", "'kind' is a list; expected one of"},
        {R"({"kind":"draw","piece":"1"})", "unknown member 'piece'; expected step, level"},
        {R"({"kind":"draw","pieces":"1"})", "'pieces' is \"1\"; expected a list of names"},
        {R"({"kind":"draw","pieces":[1]})", "'pieces' is 1; expected text"},
        {R"({"kind":"draw","pieces":["one"]})", "the piece 'one'; expected a polygon's number"},
        {R"({"kind":"draw","pieces":["9"]})", "unknown polygon '9'; expected one of the scene"},
        {R"({"kind":"draw","pieces":["99999999999"]})", "unknown polygon '99999999999'"},
        {R"({"kind":"draw","pieces":["1a"]})", "the piece '1a' is not made yet; expected"},
        {R"({"kind":"draw","pieces":["1.7"]})", "the piece '1.7' has no outline; expected"},
        {R"({"kind":"draw"})", "draws nothing; expected one piece"},
        {R"({"kind":"draw","pieces":["1","2"]})", "draws 2 pieces; expected one"},
        {R"({"kind":"draw","painted":[[48,0,1,1]]})", "pixels 0 to 0 of row 48; expected"},
        {R"({"kind":"draw","painted":[[3,60,65,1]]})", "60 to 64 of row 3; expected pixels of 64x"},
        {R"({"kind":"draw","painted":[[3,9,5,1]]})", "of row 3; expected pixels"},
        {R"({"kind":"draw","painted":[[-1,0,1,1]]})", "'painted' is -1; expected a whole number"},
        {R"({"kind":"draw","painted":[[1,0,5e9,1]]})", "expected a whole number 0..65535"},
        {R"({"kind":"draw","painted":[[1,0,1.5,1]]})", "'painted' is 1.5; expected a whole number"},
        {R"({"kind":"draw","painted":[[1,0,1]]})", "expected lists [row, first pixel"},
        {R"({"kind":"draw","painted":[[1,0,1,7]]})", "unknown polygon 7; expected"},
        {R"({"kind":"sort","painted":[[1,0,1,1]]})", "does not draw; expected \"kind\": \"draw\""},
        {R"({"kind":"compare","window":[60,0,9,1]})", "'window' reaches outside; expected"},
        {R"({"kind":"split","pieces":["1"]})", "a split without outlines; expected"},
        {R"({"kind":"split","pieces":["1"],"made":[{"name":"1a"}]})", "lacks a name or an outline"},
        {R"({"kind":"split","pieces":["1"],"made":[{"name":"1a","outline":[[[0,0,0],[1,0,0]]]}]})",
         "expected three points or more"},
        {R"({"kind":"split","pieces":["1"],"made":[{"name":"1a","outline":[[[0,0],[1,0],[1,1]]]}]})",
         "expected points [x, y, z]"},
        {R"({"kind":"draw","pieces":["1"],"counts":{"wrong":0}})", "unknown counter 'wrong'"},
        {R"({"kind":"draw","pieces":["1"],"counts":{"keys":-1}})", "expected a whole number"},
        {R"({"kind":"compare","test":"facing","result":"back"})", "has no value 'D_f'; expected"},
        {R"({"log":"gw hidden steps","version":1,"size":[32,24]})", "another size; expected 64x48"},
        {R"({"log":"gw hidden steps","version":2,"size":[64,48]})", "another version; expected 1"},
        {R"({"log":"gw hidden steps","size":[64,48]})", "another version; expected 1"},
        {R"({"log":"other","version":1,"size":[64,48]})", "expected 'gw hidden steps'"},
        {R"({"end":7,"counts":{}})", "another number of steps; expected 1"},
    };
    for (const auto& [line, message] : all) {
        const std::string error = error_of(trial, good + line + "\n");
        EXPECT_EQ(error.substr(0, 10), "answer:2: ") << line.substr(0, 80) << ": " << error;
        EXPECT_NE(error.find(message), error.npos) << line.substr(0, 80) << ": " << error;
        EXPECT_LT(error.size(), 300u) << error;
        const std::string japanese = messages_in(error.substr(10), "ja");
        EXPECT_FALSE(has_english_words(japanese)) << japanese;
    }
    EXPECT_NE(error_of(trial, "").find("no step; expected"), std::string::npos);
    const std::string whole = R"({"log":"gw hidden steps","version":1,"size":[64,48]})"
                              "\n" +
                              good;
    EXPECT_NE(error_of(trial, whole).find("has no end; expected"), std::string::npos);
    EXPECT_EQ(error_of(trial, whole + "{\"end\":1,\"counts\":{}}\n"), "");
    EXPECT_NE(error_of(trial, whole + "{\"end\":1}\n" + good).find("after the end; expected none"),
              std::string::npos);
}

// A concave outline cannot be drawn by its sides; its pixels can be named.
TEST(Play, RefusesToDrawAConcaveOutlineWithoutPixels) {
    const Trial trial(case_scene("cycle"), vgx(), 64, 48);
    const std::string made =
        R"({"kind":"split","pieces":["1"],"made":[{"name":"1a","outline":[[[0,0,0],[512,0,0],)"
        R"([100,100,0],[0,384,0]]]}]})"
        "\n";
    EXPECT_NE(error_of(trial, made + R"({"kind":"draw","pieces":["1a"]})").find("is not convex"),
              std::string::npos);
    EXPECT_EQ(error_of(trial, made + R"({"kind":"draw","pieces":["1a"],"painted":[[1,2,3,1]]})"),
              "");
}

// A line of a few letters draws all loops of a piece again.
TEST(Play, RefusesMoreOutlinesThanMemoryHolds) {
    Trial trial(case_scene("cycle"));
    const std::string triangle = "[[0,0,0],[160,0,0],[0,160,0]]";
    std::string loops = triangle;
    for (int i = 1; i < 20'000; ++i) loops += "," + triangle;
    std::string text =
        R"({"kind":"split","pieces":["1"],"made":[{"name":"1a","outline":[)" + loops + "]}]}\n";
    for (int i = 0; i < 100; ++i)
        text += R"({"kind":"draw","pieces":["1a"]})"
                "\n";
    const std::string said = error_of(trial, text);
    EXPECT_NE(said.find("expected at most 10,000,000 in all"), std::string::npos) << said;
    EXPECT_EQ(said.find("answer:"), 0u);
}

// By hand: 1 is drawn last over all of cycle's polygons.
TEST(Blame, NamesTheStepThatSpoiledEachPixel) {
    Trial trial(case_scene("cycle"));
    StepLog log(Level::Polygon);
    const std::string steps =
        "{\"kind\":\"draw\",\"pieces\":[\"2\"]}\n{\"kind\":\"draw\",\"pieces\":[\"3\"]}\n"
        "{\"kind\":\"draw\",\"pieces\":[\"1\"]}\n";
    Result result =
        run_on(*trial.machine, played(read_play(trial.input, "answer", steps)), trial.input, log);
    compare(result, trial.z_buffer.ids, trial.input);
    const auto all = blame_of(log.steps(), result, trial.input.view.width);
    ASSERT_FALSE(all.empty());
    std::uint64_t pixels = 0;
    for (const Blame& b : all) {
        pixels += b.pixels;
        ASSERT_GE(b.step, 1u);
        const Step& step = log.steps()[b.step - 1];
        EXPECT_EQ(step.action, Action::Draw);
        EXPECT_EQ(step.pieces.front(), std::to_string(b.id));
        const std::size_t at = pixel_index(b.x, b.y, trial.input.view.width);
        EXPECT_EQ(result.ids[at], b.id);
        EXPECT_EQ(trial.z_buffer.ids[at], b.expected);
        EXPECT_EQ(result.difference[at], Difference::Wrong);
        EXPECT_EQ(b.over, b.expected);  // the polygon that it spoiled was there
    }
    EXPECT_EQ(pixels, result.counts.wrong);
    EXPECT_EQ(all.back().step, 3u);
}

TEST(Blame, IsEmptyForARightPicture) {
    Trial trial(case_scene("cycle"));
    StepLog log(Level::Polygon);
    const Result result = trial.run("newell", log);
    EXPECT_EQ(blame_of(log.steps(), result, trial.input.view.width), std::vector<Blame>());
}

TEST(Play, TellsAGradeInJapaneseAndKeepsWhatAProgramPrinted) {
    EXPECT_EQ(messages_in("Step 5 painted 3 over 1 at 3600 pixels, first at (260, 90). Expected: "
                          "the background.\nTraceback (most recent call last):\n",
                          "ja"),
              "ステップ 5 が 3 を 1 の上に 3600 画素塗りました。最初の画素は (260, 90) "
              "です。正しくは 背景 です。\nTraceback (most recent call last):\n");
    EXPECT_EQ(messages_in("step:2: 'z' is a list; expected text", "ja"),
              "2 番目のステップ：'z' は リスト です。必要なもの：文字列");
    EXPECT_EQ(messages_in("step:2: '{1}' is {0}; expected text", "ja"),
              "2 番目のステップ：'{1}' は {0} です。必要なもの：文字列");
    EXPECT_EQ(messages_in("step:2: unknown polygon 'none'; expected one of the scene", "ja"),
              "2 番目のステップ：知らないポリゴン 'none' です。必要なもの：シーンのポリゴン");
    std::string endless;
    for (int i = 0; i < 100'000; ++i) endless += "a; expected ";
    EXPECT_EQ(messages_in(endless, "ja"), endless);
    EXPECT_EQ(messages_in("no step", "en"), "no step");
    EXPECT_EQ(messages_in("", "ja"), "");
}

}  // namespace gw::hiddensurface
