// Claims: every line of every algorithm's log obeys steps.schema.json; every step has a sentence in
// both languages, made from its values; every piece is known before it is named; the counters of
// the steps end at those of the run. And Newell's algorithm sorts whole plane polygons.
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/run/step_words.h"
#include "tests/hiddensurface/cases.h"
#include "tests/hiddensurface/step_schema.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::json;

/// A whole log as lines, and the steps that it was made from.
struct Log {
    std::vector<Step> steps;
    std::vector<std::string> lines;
    PictureGrid grid;
};

template <class Counts>
Log log_of(const Trial& trial, const StepLog& log, const LogSubject& subject,
           const Counts& counts) {
    Log made{
        log.steps(), {log_header(trial.input, subject, {{0, "#000000"}})}, grid_of(trial.input)};
    for (const Step& step : made.steps)
        made.lines.push_back(to_json(step, made.lines.size(), made.grid));
    made.lines.push_back(log_end(made.steps.size(), counts));
    return made;
}

Log log_of(Trial& trial, const Algorithm& algorithm, Level level = Level::Pixel) {
    StepLog log(level);
    const Counts counts = trial.run(algorithm.name, log).counts;
    return log_of(trial, log,
                  {.algorithm = algorithm.name,
                   .title = algorithm.title,
                   .in_world = algorithm.in_world,
                   .level = level},
                  counts);
}

Log log_of(Trial& trial, const LineAlgorithm& algorithm) {
    StepLog log(Level::Pixel);
    const LineCounts counts = run_on(*trial.machine, algorithm, trial.input, log).counts;
    return log_of(trial, log,
                  {.algorithm = algorithm.name,
                   .title = algorithm.title,
                   .lines = true,
                   .level = Level::Pixel},
                  counts);
}

/// Four bars, each over the next at one end.
scene::Scene pinwheel() {
    MeshData data{.primitive = Primitive::Quads};
    for (int k = 0; k < 4; ++k)
        for (const vec3& p : {vec3(-1, 0.45f, -0.3f), vec3(1, 0.45f, 0.3f), vec3(1, 0.75f, 0.3f),
                              vec3(-1, 0.75f, -0.3f)}) {
            vec3 turned = p;
            for (int i = 0; i < k; ++i) turned = {-turned.y, turned.x, turned.z};
            data.positions.push_back(turned);
        }
    return polygon_scene(std::move(data));
}

/// One quadrilateral that is not plane, and a triangle through it.
scene::Scene bent() {
    return polygon_scene({.primitive = Primitive::Polygons,
                          .positions = {{-1, -1, 0},
                                        {1, -1, 0.8f},
                                        {1, 1, 0},
                                        {-1, 1, 0.8f},
                                        {0, -1.2f, -1},
                                        {0.1f, 1.2f, 0},
                                        {0.2f, -1.2f, 1}},
                          .polygon_sizes = {4, 3}});
}

/// Many small squares behind one that is large, drawn near to far by an octree.
scene::Scene wall() {
    MeshData data{.primitive = Primitive::Quads};
    const auto square = [&](float x, float y, float z, float half) {
        for (const auto& [i, j] :
             {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
            data.positions.push_back(vec3(x + half * float(i), y + half * float(j), z));
    };
    square(0, 0, 1.5f, 2.4f);
    for (int i = 0; i < 40; ++i)
        square(0.15f * float(i % 8) - 0.5f, 0.15f * float(i / 8) - 0.3f, -1, 0.05f);
    return polygon_scene(std::move(data));
}

/// Seen from infinitely far: directions decide, not the eye's place.
scene::Scene parallel(scene::Scene scene) {
    scene.camera->ortho_height = 6;
    return scene;
}

template <class Visit>
void for_each_log(const Visit& visit) {
    std::vector<scene::Scene> scenes{case_scene("cycle"),
                                     case_scene("pierce"),
                                     case_scene("five"),
                                     case_scene("two_undecidable"),
                                     case_scene("hills"),
                                     case_scene("solids"),
                                     pinwheel(),
                                     bent(),
                                     wall(),
                                     parallel(case_scene("solids")),
                                     random_triangles(5, 12)};
    for (scene::Scene& scene : scenes) {
        const bool hills = scene.name == "hills";
        Trial trial(std::move(scene), vgx(), 32, 24);
        for (const Algorithm& algorithm : algorithms())
            if (!hills) visit(algorithm.name, trial, log_of(trial, algorithm));
        const Algorithm& z_buffer = algorithm_named("z-buffer");  // has steps of polygons or pixels
        visit(z_buffer.name, trial, log_of(trial, z_buffer, Level::Polygon));
        for (const LineAlgorithm& algorithm : line_algorithms())
            if (hills || algorithm.name != "floating-horizon")
                visit(algorithm.name, trial, log_of(trial, algorithm));
    }
}

}  // namespace

namespace {

void expect_schema(const StepSchema& schema, const std::string& name, const Log& log) {
    EXPECT_GT(log.lines.size(), 3u) << name;
    // The lines of one kind are alike: some hundred of them tell.
    const std::size_t every = log.lines.size() / 300 + 1;
    for (std::size_t i = 0; i < log.lines.size(); ++i)
        if (i % every == 0 || i + 1 == log.lines.size()) {
            ASSERT_TRUE(schema.holds_for(log.lines[i])) << name << ": " << log.lines[i];
        }
}

/// Says the steps whose test and result are new, and some of the others.
void say(const std::string& name, const Log& log, std::set<std::string>& said) {
    for (const Step& step : log.steps) {
        if (!said.insert(step.test + "." + step.result).second && said.size() % 7 != 0) continue;
        for (const char* language : {"en", "ja"}) {
            std::string sentence;
            ASSERT_NO_THROW(sentence = sentence_of(step, log.grid, language)) << name;
            EXPECT_EQ(sentence.find_first_of("{}"), sentence.npos) << sentence;
        }
    }
}

// A sentence for every test and result, and none that nobody says, but for five answers that only
// rounding could give.
void expect_words(const std::set<std::string>& said) {
    std::set<std::string> known;
    const Json all = Json::parse(step_words());
    for (const auto& [test, results] : all.items())
        for (const auto& [result, words] : results.items()) known.insert(test + "." + result);
    for (const char* rare : {"split.none", "facing.edge-on", "facing-parallel.edge-on",
                             "pyramid-cube.outside", "pyramid-polygon.outside"})
        known.erase(rare);
    for (const std::string& key : known) EXPECT_TRUE(said.count(key)) << key << " is never said";
    for (const std::string& key : said) EXPECT_TRUE(known.count(key)) << key << " has no words";
}

void expect_pieces_once_made(const std::string& name, const Log& log) {
    std::set<std::string> known;
    const Json header = Json::parse(log.lines[0]);
    for (const Json& polygon : header["polygons"]) {
        known.insert(std::to_string(polygon["id"].get<int>()));
        for (const Json& piece : polygon["pieces"]) known.insert(piece["name"]);
    }
    for (const Step& step : log.steps) {
        for (const std::string& piece : step.pieces)
            ASSERT_TRUE(known.count(piece)) << name << ": " << piece;
        for (const NamedOutline& piece : step.made) known.insert(piece.name);
    }
}

}  // namespace

// One test, as the runs take longer than all that is asked about them.
TEST(StepLogOfEveryAlgorithm, ObeysTheSchemaHasWordsAndNamesNoPieceBeforeItIsMade) {
    const StepSchema schema;
    EXPECT_FALSE(schema.holds_for(R"({"step":1})"));
    EXPECT_FALSE(schema.holds_for(
        R"({"step":1,"level":"line","kind":"draw","test":"a","result":"b","pieces":["x"]})"));
    std::set<std::string> names, said;
    for_each_log([&](const std::string& name, const Trial&, const Log& log) {
        names.insert(name);
        expect_schema(schema, name, log);
        say(name, log, said);
        expect_pieces_once_made(name, log);
    });
    EXPECT_EQ(names.size(), 20u);
    expect_words(said);
}

// Those of surfaces; the algorithm's counters alone, as the machine counts later.
TEST(StepLogOfEveryAlgorithm, CountsUpToTheRunsCounts) {
    Trial trial(random_triangles(5, 12), vgx(), 32, 24);
    for (const Algorithm& algorithm : algorithms()) {
        const Log log = log_of(trial, algorithm);
        const Json end = Json::parse(log.lines.back());
        for (const char* counter :
             {"facings", "keys", "planes", "overlaps", "crossings", "depths"}) {
            std::uint64_t last = 0;
            for (const Step& step : log.steps)
                for (const auto& [counted, value] : step.counts)
                    if (counted == counter) {
                        EXPECT_GT(value, last) << algorithm.name;
                        last = value;
                    }
            EXPECT_LE(last, end["counts"][counter]) << algorithm.name << ", " << counter;
        }
    }
}

TEST(StepLogOfEveryAlgorithm, CountsRowsFromTheTop) {
    const PictureGrid grid{10, 8};
    const Step step{.test = "t",
                    .result = "r",
                    .window = {1, 2, 3, 1},
                    .painted = {{{2, 1, 4}, 7}},
                    .made = {{"7a", {{{8, 16, 5}}}}}};
    const Json json = Json::parse(to_json(step, 1, grid));
    EXPECT_EQ(json["window"], Json({1, 7, 3, 1}));
    EXPECT_EQ(json["painted"], Json({{7, 1, 4, 7}}));
    EXPECT_EQ(json["made"][0]["outline"], Json({{{8, 64, 5}}}));
}

TEST(StepLogOfEveryAlgorithm, EndsBeforeItFillsTheMemory) {
    StepLog log(Level::Polygon);
    for (std::size_t i = 0; i < 10; ++i) log.add({});
    EXPECT_EQ(log.steps().size(), 10u);
    EXPECT_LE(most_steps * sizeof(Step), std::size_t{1} << 30);
}

// The snap bends a quadrilateral; it is sorted and cut as one plane polygon.
TEST(Newell, SortsWholePlanePolygons) {
    Trial trial(pinwheel());
    StepLog log(Level::Polygon);
    const Result result = trial.run("newell", log);
    const auto sorted = std::find_if(log.steps().begin(), log.steps().end(),
                                     [](const Step& step) { return step.action == Action::Sort; });
    ASSERT_NE(sorted, log.steps().end());
    EXPECT_EQ(std::set(sorted->pieces.begin(), sorted->pieces.end()),
              (std::set<std::string>{"1", "2", "3", "4"}));
    EXPECT_LE(result.counts.splits, 5u);  // of triangles: 10
    EXPECT_GE(result.counts.splits, 1u);
    EXPECT_EQ(result.counts.wrong, 0u);
    for (const Step& step : log.steps())
        for (const std::string& piece : step.pieces)
            EXPECT_EQ(piece.find('.'), piece.npos) << piece;
}

}  // namespace gw::hiddensurface
