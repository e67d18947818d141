// gw study: plots with their numbers.
#include "tests/apps/support/examples.h"

#include <algorithm>

namespace gw::apps {

using Study = ExampleTest;

TEST_F(Study, ConvergenceWritesPlotsAndTheirNumbers) {
    const Outcome outcome = gw({"study", "convergence", "-o", "out", "--samples", "4"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("\nantialiasing "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("N^-"), std::string::npos) << outcome.out;
    EXPECT_EQ(names("out"),
              (std::vector<std::string>{"antialiasing.csv", "antialiasing.svg", "index.html",
                                        "index.json", "soft_shadow.csv", "soft_shadow.svg"}));
    const std::string svg = bytes_of(in("out/antialiasing.svg")),
                      csv = bytes_of(in("out/antialiasing.csv"));
    EXPECT_NE(svg.find("build/release/bin/gw study convergence -o out --samples 4"), svg.npos);
    EXPECT_EQ(csv.substr(0, 10), "samples N,");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);  // names, N = 2, N = 4
}

TEST_F(Study, HiddenSurfacesGrowAndCost) {
    const Outcome outcome =
        gw({"study", "hidden", "-o", "out", "--limit", "0.02", "--axis", "resolution"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* part :
         {"Against pixels", "was stopped after", "prices of 1974", "prices of today", "z-buffer"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
    const auto files = names("out");
    for (const char* name :
         {"growth.csv", "laws.csv", "costs.csv", "index.html", "resolution_seconds.svg",
          "cost_1974_resolution.svg", "lines_resolution_planes.svg"})
        EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
    EXPECT_EQ(bytes_of(in("out/growth.csv")).substr(0, 27), "axis,algorithm,value,x,y\nre");
}

TEST_F(Study, RefusesWhatCannotBe) {
    expect_refused(2, {"study", "convergence", "-o", ""}, {"--output is empty"});
    expect_refused(2, {"study", "speed", "-o", "out"},
                   {"STUDY 'speed'", "convergence, precision, hidden"});
    expect_refused(2, {"study", "convergence", "-o", "out", "--samples", "1"},
                   {"--samples '1'", "4..4096"});
    expect_refused(1, {"study", "precision", "-o", "missing/out"}, {"missing/out"});
    expect_refused(2, {"study", "hidden", "-o", "out", "--limit", "0"}, {"--limit '0'"});
    expect_refused(2, {"study", "hidden", "-o", "out", "--axis", "colour"},
                   {"--axis 'colour'", "polygons"});
    expect_refused(1, {"study", "hidden", "-o", "out", "--prices", "none"},
                   {"none", "no price lists"});
    std::filesystem::remove(in("scenes"));
    expect_refused(1, {"study", "precision", "-o", "out"}, {"scenes/columns.toml"});
}

}  // namespace gw::apps
