// Claims [K4f]: gw study passes writes the same counts twice, and estimates that are its counts times
// its prices; it takes scenes at the extremes; it says why it omits a sweep; wrong words are refused;
// finished rows stay if it is interrupted.
#include "apps/study/passes/plots.h"
#include "tests/apps/study/study_scenes.h"
#include "tests/apps/support/command_test.h"

#include <nlohmann/json.hpp>

namespace gw::study {
namespace {

using Json = nlohmann::json;

class PassesCommand : public apps::CommandTest {
protected:
    /// A pane over a floor under one lamp; the pane's lines can be replaced.
    void write_scene(const std::string& pane = "Ks = 0.5\nillum = 3\n") const {
        write("scene.toml",
              "[camera]\neye = [0, 2, 5]\nat = [0, 0.5, 0]\n"
              "[[light]]\nname = \"lamp\"\nposition = [1, 4, 3]\nshadow = \"volume\"\n"
              "[material.floor]\nKd = 0.7\n[material.pane]\nKd = 0.2\n" +
                  pane +
                  "[[object]]\nname = \"floor\"\nshape = \"rectangle\"\nmaterial = \"floor\"\n"
                  "width = 6\ndepth = 6\n"
                  "[[object]]\nname = \"pane\"\nshape = \"box\"\nmaterial = \"pane\"\n");
    }
    apps::Outcome study(std::vector<std::string> more) const {
        std::vector<std::string> words{"study",  "passes", "scene.toml", "-o",     "out",
                                       "--size", "32x24",  "--quiet",    "--runs", "0"};
        words.insert(words.end(), more.begin(), more.end());
        return gw(words);
    }
    Json results() const { return Json::parse(apps::bytes_of(in("out/results.json"))); }
};

render::StudyRow row_of(scene::Scene scene) {
    render::Request request{.size = {24, 18}, .threads = 1};
    return render::measured(render::no_sweep(), 1,
                            render::make_drawing(request, vgx(), {.scene = std::move(scene)}), 0,
                            [](const std::string&) {});
}

}  // namespace

TEST_F(PassesCommand, WritesTheSameCountsTwice) {
    write_scene();
    const std::vector<std::string> sweeps{"--sweep", "lights=1,3", "--sweep", "depth=1,2"};
    ASSERT_EQ(study(sweeps).code, 0);
    const std::string first = apps::bytes_of(in("out/counts.csv")),
                      estimates = apps::bytes_of(in("out/estimates.csv"));
    ASSERT_EQ(study(sweeps).code, 0);
    EXPECT_EQ(apps::bytes_of(in("out/counts.csv")), first);
    EXPECT_EQ(apps::bytes_of(in("out/estimates.csv")), estimates);
    EXPECT_EQ(std::ranges::count(first, '\n'), 1 + 4 * (1 + 2 + 2));
    for (const char* name : {"index.html", "results.json", "times.csv", "lights_counts.svg",
                             "lights_gain.svg", "lights_estimated.svg", "depth_gain.svg"})
        EXPECT_FALSE(apps::bytes_of(in(std::string("out/") + name)).empty()) << name;
}

// The text is one compiler's: whichever builds this test must count the same.
TEST_F(PassesCommand, CountsAreThoseOfEveryCompiler) {
    write_scene();
    ASSERT_EQ(study({"--sweep", "depth=2"}).code, 0);
    const std::string expected =
        "sweep,value,x,method,width,height,samples,lights,depth,triangles,passes,draws,"
        "primitives,fragments,written,texels,pixels,bytes,primary,reflected,transmitted,"
        "shadow,shaded,boxes_tested,triangles_tested,picture\n"
        "scene,1,1,maps,32,24,1,1,2,14,6,13,102,3378,2136,0,4608,25671,0,0,0,0,0,0,0,"
        "2789789f95b095d81c64cebde32255a9\n"
        "scene,1,1,item-buffer,32,24,1,1,2,14,8,15,116,4674,3378,0,6912,45165,30,30,0,18,"
        "18,384,414,595dab39da710537076d22ad8a168948\n"
        "scene,1,1,item-buffer-maps,32,24,1,1,2,14,11,20,146,5228,3908,0,16128,73761,30,"
        "30,0,0,18,240,270,595dab39da710537076d22ad8a168948\n"
        "scene,1,1,ray-tracing,32,24,1,1,2,14,1,0,0,768,768,0,0,3072,768,30,0,450,450,"
        "9984,7846,fff1f150fb12184ee9633f46b0cd7f03\n";
    EXPECT_TRUE(apps::bytes_of(in("out/counts.csv")).starts_with(expected));
    EXPECT_FALSE(results()["measured_by"]["commit"].get<std::string>().empty());
    EXPECT_NE(apps::bytes_of(in("out/times.csv")).find(",program,commit,compiler,"),
              std::string::npos);
}

TEST_F(PassesCommand, NamesTheSceneByTheDigestThatManifestsHave) {
    write_scene();
    ASSERT_EQ(study({"--sweep", "depth=1"}).code, 0);
    ASSERT_EQ(
        gw({"record", "scene.toml", "-o", "t.gwt", "--size", "32x24", "--manifest", "m.json"}).code,
        0);
    const Json manifest = Json::parse(apps::bytes_of(in("m.json")));
    EXPECT_EQ(results()["scene_hash"], manifest["scene"]["hash"]);
    EXPECT_EQ(results()["scene_hash"].get<std::string>().size(), 32u);
}

TEST_F(PassesCommand, EstimatesAreItsCountsTimesItsPrices) {
    write_scene();
    std::filesystem::create_directory(in("prices"));
    write("prices/only.toml",
          "machine = \"m\"\n[[price]]\ncount = \"shaded\"\nstage = \"processor\"\n"
          "nanoseconds = 1000\nlow = 500\nhigh = 3000\nsource = \"a test\"\n");
    ASSERT_EQ(study({"--sweep", "depth=2", "--prices", "prices"}).code, 0);
    for (const Json& row : results()["rows"]) {
        const double shaded = row["counts"]["shaded"];
        const Json& seconds = row["estimated"]["only"]["seconds"];
        EXPECT_DOUBLE_EQ(seconds[0], shaded * 500e-9);
        EXPECT_DOUBLE_EQ(seconds[1], shaded * 1000e-9);
        EXPECT_DOUBLE_EQ(seconds[2], shaded * 3000e-9);
    }
}

/// Samples: every picture's rays, and an error for all rows but the reference.
TEST_F(PassesCommand, MeasuresTheErrorOfSamples) {
    write_scene();
    ASSERT_EQ(study({"--sweep", "samples=1,4"}).code, 0);
    const std::string errors = apps::bytes_of(in("out/errors.csv"));
    EXPECT_EQ(std::ranges::count(errors, '\n'), 1 + 4 + 3);
    EXPECT_NE(errors.find("1,ray-tracing,"), errors.npos);
    EXPECT_EQ(errors.find("4,ray-tracing,"), errors.npos);
}

TEST_F(PassesCommand, SaysWhichSweepsAreOmittedAndWhy) {
    write_scene("Ks = 0\n");
    const apps::Outcome all = study({"--limit", "0.001"});
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.out.find("depth: nothing in the scene reflects by rays"), all.out.npos);
    EXPECT_NE(all.out.find("the limit is 0.001 s"), all.out.npos);
}

TEST_F(PassesCommand, RefusesWrongWords) {
    write_scene("Ks = 0\n");
    const std::vector<std::string> words{"study", "passes", "scene.toml", "-o", "out", "--quiet"};
    const auto refused = [&](int code, std::vector<std::string> more,
                             const std::vector<std::string>& parts) {
        std::vector<std::string> all = words;
        all.insert(all.end(), more.begin(), more.end());
        expect_refused(code, all, parts);
    };
    refused(2, {"--sweep", "lite"}, {"--sweep 'lite'", "lights"});
    refused(2, {"--sweep", "lights=0"}, {"--sweep lights '0'", "1"});
    refused(2, {"--sweep", "lights="}, {"--sweep lights ''"});
    refused(2, {"--sweep", "lights=1,,2"}, {"--sweep lights ''"});
    refused(2, {"--sweep", "lights", "--sweep", "lights=2"}, {"given twice"});
    refused(2, {"--runs", "-1"}, {"--runs"});
    refused(2, {"--size", "0x5"}, {"--size"});
    refused(1, {"--sweep", "depth"}, {"scene.toml", "nothing in the scene reflects", "depth"});
    refused(1, {"--prices", "none"}, {"none", "no price lists"});
    expect_refused(2, {"study", "passes", "-o", "out"}, {"no SCENE"});
    expect_refused(2, {"study", "hemicube", "scene.toml", "-o", "out"}, {"SCENE 'scene.toml'"});
    expect_refused(1, {"study", "passes", "missing.toml", "-o", "out"}, {"missing.toml"});
}

TEST_F(PassesCommand, KeepsFinishedRowsWhenItIsInterrupted) {
    write_scene();
    const apps::Outcome outcome =
        gw({"study", "passes", "scene.toml", "-o", "out", "--size", "160x120", "--quiet", "--runs",
            "5", "--sweep", "lights=1,2,4,8,16,32,64", "--limit", "3600"},
           {.interrupt_when = "out/index.json"});
    EXPECT_EQ(outcome.code, 128 + 2);
    EXPECT_NE(outcome.err.find("rows are in out"), outcome.err.npos) << outcome.err;
    EXPECT_GE(results()["rows"].size(), 4u);
}

/// No share of the pixels is glossy; all are; one polygon; none is visible.
TEST(PassStudyPage, TakesScenesAtTheExtremes) {
    for (const bool glossy : {false, true})
        for (const double eye : {3.0, -3.0}) {
            scene::Scene scene = ball(8);
            std::uint32_t id = 0;
            scene.objects[0].mesh =
                scene::make_numbered_mesh(shape("rectangle", {50, 50, 1, 1}), id);
            scene.materials[0].illum = glossy ? 3 : 2;
            scene.camera = scene::Camera{.eye = {0, eye, 0.1}, .at = {0, 2 * eye, 0}};
            if (eye > 0) scene.camera->at = {0, 0, 0};
            PassStudy study{.scene = "extreme",
                            .profile = "vgx",
                            .command = "gw",
                            .lists = report::built_in_prices()};
            study.add(row_of(scene));
            EXPECT_EQ(study.rows[0].share(), glossy && eye > 0 ? 1 : 0);
            for (const std::string& text :
                 {page(study), counts_csv(study), estimates_csv(study), results_json(study)}) {
                for (const char* bad : {"nan,", "nan<", "nan ", "inf,", "inf<", "inf "})
                    EXPECT_EQ(text.find(bad), text.npos) << text;
            }
            EXPECT_TRUE(plots(study, "scene").empty()) << "one row is no curve";
        }
}

/// The gain falls through 1 half way between two rows of made-up costs.
TEST(PassStudyPage, FindsTheCrossing) {
    const auto row = [](int lights, std::uint64_t item, std::uint64_t ordinary) {
        render::StudyRow r{.sweep = "lights", .value = lights, .x = double(lights)};
        for (const render::Method& method : render::methods())
            r.costs.push_back({.method = method.name,
                               .rays = {.shaded = method.name == "ray-tracing" ? ordinary : item}});
        return r;
    };
    report::PriceList list{.name = "one", .machine = "m"};
    list.prices.push_back({.count = report::priced_counts().back(),
                           .stage = "processor",
                           .nanoseconds = 1e9,
                           .low = 1e9,
                           .high = 1e9});
    PassStudy study{.scene = "s", .profile = "vgx", .command = "gw", .lists = {list}};
    study.add(row(2, 10, 15));
    study.add(row(4, 10, 5));
    EXPECT_EQ(crossings(study, "lights"),
              (std::vector<std::string>{"at prices of one: the curves cross at about 3 lights"}));
    EXPECT_EQ(plots(study, "lights").size(), 2u) << "no counts, and nothing timed";
}

}  // namespace gw::study
