// gw study: plots with their numbers.
#include "examples.h"

#include <algorithm>

namespace gw::apps {

using Study = ExampleTest;

TEST_F(Study, ConvergenceWritesPlotsAndTheirNumbers) {
    const Outcome outcome = gw({"study", "convergence", "-o", "out", "--samples", "4"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("\nantialiasing "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("N^-"), std::string::npos) << outcome.out;
    EXPECT_EQ(names("out"), (std::vector<std::string>{"antialiasing.csv", "antialiasing.svg",
                                                      "soft_shadow.csv", "soft_shadow.svg"}));
    const std::string svg = bytes_of(in("out/antialiasing.svg")), csv = bytes_of(in("out/antialiasing.csv"));
    EXPECT_NE(svg.find("build/release/bin/gw study convergence -o out --samples 4"), svg.npos);
    EXPECT_EQ(csv.substr(0, 10), "samples N,");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);  // names, N = 2, N = 4
}

TEST_F(Study, RefusesWhatCannotBe) {
    expect_refused(2, {"study", "convergence", "-o", ""}, {"-o is empty"});
    expect_refused(2, {"study", "speed", "-o", "out"}, {"STUDY 'speed'", "convergence, precision"});
    expect_refused(2, {"study", "convergence", "-o", "out", "--samples", "1"}, {"--samples '1'", "4..4096"});
    expect_refused(1, {"study", "precision", "-o", "missing/out"}, {"missing/out"});
    std::filesystem::remove(in("scenes"));
    expect_refused(1, {"study", "precision", "-o", "out"}, {"scenes/columns.toml"});
}

}  // namespace gw::apps
