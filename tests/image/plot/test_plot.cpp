// Plots as text: what is drawn where, what is refused.
#include "gw/error.h"
#include "image/plot/markup.h"
#include "image/plot/plot.h"
#include "image/plot/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace gw::plot {
namespace {

std::vector<std::string> texts(const Scale& scale) {
    std::vector<std::string> out;
    for (const Tick& tick : scale.ticks)
        if (!tick.text.empty()) out.push_back(tick.text);
    return out;
}

TEST(Scale, LinearTicksAreRoundAndEncloseTheValues) {
    const Scale scale = make_scale({"x"}, {0.13, 0.97});
    EXPECT_EQ(texts(scale), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
    EXPECT_DOUBLE_EQ(scale.place(0), 0);
    EXPECT_DOUBLE_EQ(scale.place(0.5), 0.5);
    EXPECT_DOUBLE_EQ(scale.place(1), 1);
}

TEST(Scale, LogarithmicTicksArePowers) {
    EXPECT_EQ(texts(make_scale({"N", 2}, {2, 16})),
              (std::vector<std::string>{"2", "4", "8", "16"}));
    EXPECT_EQ(texts(make_scale({"e", 10}, {0.0011, 9})),
              (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10"}));
    EXPECT_EQ(texts(make_scale({"e", 10}, {1, 9})),
              (std::vector<std::string>{"1", "2", "5", "10"}));
    EXPECT_NEAR(make_scale({"e", 10}, {1, 100}).place(10), 0.5, 1e-15);
}

TEST(Scale, OneValueIsInTheMiddle) {
    EXPECT_NEAR(make_scale({"x"}, {4}).place(4), 0.5, 1e-15);
    EXPECT_NEAR(make_scale({"x"}, {0}).place(0), 0.5, 1e-15);
}

TEST(Scale, RefusesWhatItCannotShow) {
    EXPECT_THROW(make_scale({"x"}, {}), Error);
    EXPECT_THROW(make_scale({"x"}, {1, std::nan("")}), Error);
    EXPECT_THROW(make_scale({"x", 10}, {1, 0}), Error);
    EXPECT_THROW(make_scale({"x", 2}, {-1}), Error);
}

const Plot small{.title = "a < b & c",
                 .caption = "Caption.",
                 .command = "gw study x",
                 .x = {"N", 2},
                 .y = {"error", 10},
                 .series = {{"one, two", {{2, 0.5}, {8, 0.125}}}, {"three", {{4, 0.1}}, false}}};

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(Svg, DrawsALineAndItsMarkersWhereTheAxesSay) {
    const std::string text = svg(small);
    EXPECT_NE(text.find("a &lt; b &amp; c"), text.npos);
    EXPECT_EQ(count(text, "<polyline"), 1u);
    // x from 76 to 500 is 2 to 8, y from 380 to 40 is 0.1 to 1.
    EXPECT_NE(text.find("<polyline points=\"76.00,142.35 500.00,347.05\""), text.npos) << text;
    EXPECT_NE(text.find("<title>one, two: 8, 0.125</title>"), text.npos);
    EXPECT_NE(text.find("translate(288.00,380.00)"), text.npos);
    EXPECT_NE(text.find("gw study x"), text.npos);
}

/// The colours and dashes of the legend's lines, each once.
std::set<std::string> lines_of_legend(const Plot& plot) {
    const std::string text = svg(plot), begin = "<path d=\"M512";
    std::set<std::string> lines;
    for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1)) {
        const std::size_t fill = text.find("fill", at);
        lines.insert(text.substr(fill, text.find("/>", at) - fill));
    }
    return lines;
}

TEST(Svg, GivesEachOfTwentyOneSeriesAnotherLineUnlessTheyShareAStyle) {
    Plot plot = small;
    plot.series.assign(21, {.name = "s", .points = {{2, 0.5}, {8, 0.125}}});
    EXPECT_EQ(lines_of_legend(plot).size(), 21u);
    plot.series[1].style = 0;
    EXPECT_EQ(lines_of_legend(plot).size(), 20u);
}

TEST(Svg, BreaksALongCaptionAtBlanks) {
    Plot plot = small;
    plot.caption = "";
    for (int i = 0; i < 30; ++i) plot.caption += "fifteen-letters ";
    plot.caption.pop_back();
    EXPECT_EQ(count(svg(plot), "fifteen-letters</text>"), 5u);
}

TEST(Svg, SaysByWhichCommandItWasMade) {
    const std::string command = "build/release/bin/gw study 'a & <b>' -o \"x\"";
    Plot plot = small;
    plot.command = "";
    EXPECT_EQ(svg(plot).find("<desc"), std::string::npos);
    plot.command = command;
    EXPECT_NE(
        svg(plot).find(
            "<desc class=\"command\">build/release/bin/gw study &#39;a &amp; &lt;b&gt;&#39; -o "
            "&quot;x&quot;</desc>"),
        std::string::npos);
}

TEST(Csv, HasARowForEveryX) {
    EXPECT_EQ(csv(small), "N,\"one, two\",three\n2,0.5,\n4,,0.1\n8,0.125,\n");
}

TEST(PowerLaw, FindsTheLawThatThePointsFollow) {
    std::vector<dvec2> points;
    for (double x : {2.0, 4.0, 32.0, 100.0}) points.push_back({x, 3 * std::pow(x, -0.75)});
    const PowerLaw law = power_law(points);
    EXPECT_NEAR(law.factor, 3, 1e-12);
    EXPECT_NEAR(law.exponent, -0.75, 1e-12);
    EXPECT_NEAR(law(16), 3.0 / 8, 1e-12);
}

TEST(PowerLaw, IsTheLeastSquaresOne) {
    // log2: (0, 0), (1, 1), (2, 0): the mean, slope 0.
    const PowerLaw law = power_law({{1, 1}, {2, 2}, {4, 1}});
    EXPECT_NEAR(law.exponent, 0, 1e-15);
    EXPECT_NEAR(law.factor, std::cbrt(2.0), 1e-12);
}

TEST(PowerLaw, NeedsTwoDifferentX) {
    EXPECT_THROW(power_law({}), Error);
    EXPECT_THROW(power_law({{2, 1}, {2, 3}}), Error);
    EXPECT_THROW(power_law({{2, 1}, {4, 0}}), Error);
}

TEST(Escaped, IsHarmlessInTextAndInAttributes) {
    EXPECT_EQ(escaped("<a href=\"x\">'&'"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
    EXPECT_EQ(escaped("輪 plain"), "輪 plain");
}

}  // namespace
}  // namespace gw::plot
