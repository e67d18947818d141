// A report's files say what the recording is: planes, counters, states, and every pixel's history.
#include "inspect/report/report.h"

#include "gw/error.h"
#include "gw/mesh.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "inspect/report/embedded.h"

#include "tests/inspect/three_passes.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace gw::report {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

class Reports : public testing::Test {
protected:
    ReportSummary write(const inspect::Recording& recording, ReportOptions options = {}) const {
        options.file = "t.gwt";
        options.prices = vgx_prices();
        return write_report(recording, folder_, options);
    }
    nlohmann::json data() const {
        const std::string text = text_of(folder_ / "data.js"), begin = "gw_report(";
        EXPECT_EQ(text.substr(0, begin.size()), begin);
        return nlohmann::json::parse(text.substr(begin.size(), text.rfind(')') - begin.size()));
    }
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            if (entry.is_regular_file())
                all[entry.path().lexically_relative(folder_).string()] = text_of(entry.path());
        return all;
    }
    void expect_refused(const inspect::Recording& recording, const ReportOptions& options,
                        const std::string& part) const {
        try {
            write(recording, options);
            ADD_FAILURE() << "accepted; expected " << part;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }

    TemporaryFolder here_;
    const fs::path folder_ = here_.path();
};

/// "shaded": a square of two polygons over the right half of 4 x 2 pixels. "ids": its identifiers.
inspect::Recording two_polygons() {
    inspect::Recording r;
    r.width = 4;
    r.height = 2;
    const MeshRef mesh = make_mesh({.positions = {{0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0}},
                                    .indices = {0, 1, 2, 0, 2, 3}});
    State state;
    state.viewport = {0, 0, 4, 2};
    CommandList list;
    list.add(BeginPass{.name = "shaded"});
    list.add(Clear{.planes = all_planes});
    list.add(SetState{state});
    list.add(Draw{.mesh = mesh});
    list.add(BeginPass{.name = "ids"});
    state.color_source = ColorSource::PolygonId;
    list.add(SetState{state});
    list.add(Draw{.mesh = mesh, .id_base = 7});
    r.lists.push_back(list);
    return r;
}

}  // namespace

TEST_F(Reports, ShowPolygonsAndWhereTheyAreWrittenIdentifiers) {
    write(two_polygons());
    const auto json = data();
    EXPECT_EQ(json["passes"][0]["identifiers"], false);
    EXPECT_EQ(json["passes"][1]["identifiers"], true);
    EXPECT_EQ(json["passes"][0]["planes"]["polygons"]["pixels"], 4);
    EXPECT_FALSE(json["passes"][1]["planes"]["polygons"].contains("change"));
    EXPECT_EQ(json["passes"][1]["planes"]["identifiers"]["pixels"], 4);
    EXPECT_EQ(json["passes"][1]["planes"]["identifiers"]["after"], "0001_identifiers");
    EXPECT_EQ(json["passes"][1]["planes"]["identifiers"]["before"], "0001_identifiers_before");
    EXPECT_FALSE(json["passes"][0]["planes"].contains("identifiers"));
}

TEST_F(Reports, HoldEveryPassWithWhatItChanged) {
    const ReportSummary summary = write(inspect::three_passes());
    EXPECT_EQ(summary.passes, 3u);
    EXPECT_EQ(summary.history->last, 2u);
    const auto json = data();
    ASSERT_EQ(json["passes"].size(), 3u);
    const auto &clear = json["passes"][0], &first = json["passes"][1], &second = json["passes"][2];
    EXPECT_EQ(first["name"], "first");
    EXPECT_EQ(first["set"], "(Ka=0, Kd=object)");
    EXPECT_EQ(first["counters"]["fragments"], 4);
    EXPECT_EQ(first["planes"]["color"]["before"], clear["planes"]["color"]["after"]);
    EXPECT_EQ(first["planes"]["color"]["after"], "0001_color");
    EXPECT_EQ(first["planes"]["color"]["pixels"], 4);
    EXPECT_EQ(first["planes"]["color"]["times"], 2);  // 100 becomes 200 of 255
    EXPECT_FALSE(first["planes"]["stencil"].contains("change"));
    EXPECT_EQ(second["planes"]["color"]["after"], "0001_color");
    EXPECT_EQ(second["planes"]["stencil"]["pixels"], 4);
    EXPECT_EQ(second["planes"]["accum"]["pixels"], 4);
    for (const auto& pass : json["passes"])
        for (const auto& plane : pass["planes"])
            for (const char* which : {"before", "after", "change"}) {
                if (!plane.contains(which)) continue;
                const std::string file = plane[which].get<std::string>() + ".png";
                EXPECT_TRUE(fs::exists(folder_ / "pictures" / file)) << file;
            }
}

TEST_F(Reports, NeedNothingBesideThem) {
    EXPECT_EQ(write(inspect::three_passes()).page, !embedded("report.html").empty());
    const std::string page = text_of(folder_ / "index.html");
    EXPECT_EQ(page, embedded("report.html"));
    EXPECT_TRUE(fs::exists(folder_ / "data.js"));
    EXPECT_EQ(page.empty(), page.find("data.js") == page.npos);
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const auto known = report_files();
        EXPECT_NE(std::find(known.begin(), known.end(), entry.path().filename()), known.end())
            << entry;
    }
}

TEST_F(Reports, HistoriesAreTheEventsOfPixelHistoryInRows) {
    const inspect::Recording recording = inspect::three_passes();
    write(recording);
    const std::string tile = text_of(folder_ / "history" / "0_0.js");
    // Cleared to 0, where all was 0 but Z: one row for all 48 pixels and one plane each.
    EXPECT_NE(tile.find("gw_history(\"0_0\",{width:8,start:[[48,0],],rows:[\n"), std::string::npos)
        << tile;
    EXPECT_NE(tile.find("\n[0,48,1,{z:"), std::string::npos) << tile;
    // The rectangle's fragment at window pixel (3, 2), which is the fourth.
    EXPECT_NE(tile.find("\n[19,1,3,{c:[100,100,100,255]},-1,3,-1,3,1,100,100,100,255,0],\n"),
              std::string::npos)
        << tile;
    // The stencil rectangle's value at (4, 3).
    EXPECT_NE(tile.find("\n[28,1,6,{s:4}],\n"), std::string::npos) << tile;
    EXPECT_TRUE(tile.ends_with("]});\n"));
}

TEST_F(Reports, AreTheSameBytesEveryTime) {
    write(inspect::three_passes());
    const auto once = files();
    fs::remove_all(folder_);
    fs::create_directory(folder_);
    write(inspect::three_passes());
    EXPECT_EQ(files(), once);
}

TEST_F(Reports, OfSomePassesBeginWithThePlanesBeforeThem) {
    ReportOptions options;
    options.passes = PassSpan{2, 2};
    const ReportSummary summary = write(inspect::three_passes(), options);
    EXPECT_EQ(summary.passes, 1u);
    EXPECT_EQ(summary.passes_of_recording, 3u);
    const auto json = data();
    EXPECT_EQ(json["passes"][0]["pass"], 2);
    EXPECT_EQ(json["passes"][0]["planes"]["color"]["after"], "0002_color_before");
    EXPECT_FALSE(json["passes"][0]["planes"]["color"].contains("change"));
    const std::string tile = text_of(folder_ / "history" / "0_0.js");
    EXPECT_NE(tile.find("start:[[10,{z:"), std::string::npos) << tile;
    EXPECT_NE(tile.find("{c:[100,100,100,255],z:"), std::string::npos) << tile;
}

TEST_F(Reports, WithoutHistoriesHaveNone) {
    ReportOptions options;
    options.with_history = false;
    EXPECT_FALSE(write(inspect::three_passes(), options).history);
    EXPECT_FALSE(fs::exists(folder_ / "history"));
    EXPECT_TRUE(data()["history"].is_null());
}

TEST_F(Reports, RefusePassesThatAreNotThereAndSizesBeyondTheLimit) {
    const inspect::Recording recording = inspect::three_passes();
    ReportOptions options;
    options.passes = PassSpan{1, 3};
    expect_refused(recording, options, "expected passes of 0-2");
    options.passes = PassSpan{1, 2};
    options.history = PassSpan{0, 1};
    expect_refused(recording, options, "expected passes of 1-2");
    options.passes = PassSpan{0, 1};
    options.history = PassSpan{1, 2};
    expect_refused(recording, options, "expected passes of 0-1");
    options = {};
    options.most_bytes = 3000;
    expect_refused(recording, options, "the report needs more than 0 MB");
    expect_refused({.width = 4, .height = 4}, {}, "t.gwt: has no pass");
}

TEST_F(Reports, HaveAThousandPassesAndNoMore) {
    inspect::Recording recording{.width = 1, .height = 1};
    recording.lists.emplace_back();
    for (std::size_t i = 0; i <= most_passes; ++i) {
        recording.lists[0].add(BeginPass{"pass"});
        recording.lists[0].add(Clear{.planes = all_planes});
    }
    ReportOptions options;
    options.with_history = false;
    options.passes = PassSpan{0, most_passes};
    expect_refused(recording, options,
                   "1001 passes are too many for one page; expected at most 1000");
    options.passes = PassSpan{1, most_passes};
    EXPECT_EQ(write(recording, options).passes, most_passes);
}

TEST_F(Reports, KeepHistoriesOfExactlyThePassesShown) {
    ReportOptions options;
    options.passes = options.history = PassSpan{1, 2};
    const auto summary = write(inspect::three_passes(), options);
    ASSERT_TRUE(summary.history);
    EXPECT_EQ(summary.history->first, 1u);
    EXPECT_EQ(summary.history->last, 2u);
}

TEST_F(Reports, AreInTheLimitToTheByte) {
    const std::uint64_t bytes = write(inspect::three_passes()).bytes;
    std::uint64_t sum = 0;
    for (const auto& [name, text] : files()) sum += text.size();
    EXPECT_EQ(sum, bytes);
    for (const std::uint64_t limit : {bytes - 1, bytes}) {
        fs::remove_all(folder_);
        fs::create_directory(folder_);
        ReportOptions options;
        options.most_bytes = limit;
        if (limit == bytes)
            EXPECT_EQ(write(inspect::three_passes(), options).bytes, bytes);
        else
            expect_refused(inspect::three_passes(), options, "needs more than");
    }
}

}  // namespace gw::report
