// Claims: the growth study finds the exponents that counters must have; stops what is slow and says
// so; prices turn counts into the sums they say; rankings flip where two cost curves cross;
// malformed lists name line and expectation.
#include "apps/study/growth_plots.h"
#include "apps/study/growth_scenes.h"
#include "apps/study/prices.h"
#include "gw/error.h"

#include <gtest/gtest.h>
#include "test_paths.h"
#include "tests/temporary_folder.h"

namespace gw::study {
namespace {

const std::string folder = GW_SOURCE_DIR "/scenes/hidden/prices/";

/// Counts that are known: rays = x^2, depths = 100 x.
Growth made_up() {
    Growth growth;
    for (double x = 1; x <= 1024; x *= 4)
        for (const char* name : {"ray-casting", "z-buffer"}) {
            const bool rays = std::string(name) == "ray-casting";
            growth.points.push_back(
                {"polygons",
                 false,
                 x,
                 name,
                 {{"rays", rays ? x * x : 0}, {"depths", rays ? 0 : 100 * x}, {"peak_bytes", 0}}});
        }
    return growth;
}

PriceList unit_prices() {
    PriceList list{.name = "unit", .machine = "a machine", .prices = {}};
    for (const char* name :
         {"add", "compare", "multiply", "divide", "load", "store", "machine", "memory"})
        list.prices[name] = {1, true, "none"};
    return list;
}

std::string message_of(const std::string& text, bool recipes) {
    const TemporaryFolder here;
    const auto file = here.write("prices.toml", text);
    std::string message;
    try {
        recipes ? void(read_recipes(file)) : void(read_prices(file));
    } catch (const Error& error) {
        message = error.what();
    }
    return message;
}

}  // namespace

TEST(Growth, CountsWhatIsKnownToGrowSo) {
    const auto laws_of = [](const char* axis) {
        return growth_laws(
            study::growth({.limit = 1e9, .threads = 1, .axis = axis, .only = {"z-buffer"}},
                          [](const std::string&) {}));
    };
    const auto exponent = [](const std::vector<GrowthLaw>& laws, const char* value) {
        for (const GrowthLaw& law : laws)
            if (law.value == value) return law.law.exponent;
        ADD_FAILURE() << value;
        return 0.0;
    };
    const auto polygons = laws_of("polygons"), depth = laws_of("depth"),
               resolution = laws_of("resolution");
    EXPECT_NEAR(exponent(polygons, "polygons"), 1, 0.01);
    EXPECT_NEAR(exponent(polygons, "peak_bytes"), 0, 1e-6);
    // a comparison for every polygon over every pixel
    EXPECT_NEAR(exponent(depth, "depths"), 1, 1e-9);
    EXPECT_NEAR(exponent(resolution, "peak_bytes"), 1, 1e-6);
    EXPECT_NEAR(exponent(resolution, "depths"), 1, 0.02);
}

TEST(Growth, StopsWhatTakesLongerThanTheLimit) {
    const Growth growth = study::growth(
        {.limit = 0, .threads = 1, .axis = "frames", .only = {"newell", "z-buffer", "appel"}},
        [](const std::string&) {});
    ASSERT_EQ(growth.points.size(), 3u);  // the smallest size is always asked
    ASSERT_EQ(growth.cuts.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(growth.cuts[i].x, 0.25);
        EXPECT_EQ(growth.cuts[i].algorithm, growth.points[i].algorithm);
        EXPECT_GT(growth.points[i].values.at("changed"), 0) << growth.points[i].algorithm;
    }
    EXPECT_GT(growth.points[0].values.at("moved"), 0);
    EXPECT_EQ(growth.points[1].values.at("moved"), 0);  // the Z-buffer has no order
    for (const GrowthPlot& plot : growth_plots(growth)) {
        EXPECT_NE(plot.plot.caption.find("was stopped after 0.25"), std::string::npos) << plot.name;
        EXPECT_NE(plot::svg(plot.plot).find("<path"), std::string::npos) << plot.name;
    }
}

TEST(Growth, SceneHasTheDepthThatIsAskedFor) {
    EXPECT_EQ(triangle_soup(64, 4, 0).objects[0].mesh->polygon_count(), 64u);
    EXPECT_EQ(hill_grid(64, 2, 0).objects[0].mesh->polygon_count(), 64u);
    // Turned by 90 degrees around the middle.
    const scene::Camera turned = *triangle_soup(1, 1, 90).camera;
    EXPECT_NEAR(turned.eye.x, 6, 1e-9);
    EXPECT_NEAR(turned.eye.z, 0, 1e-9);
}

TEST(Moves, AreTheFewestThatMakeOneOrderOfAnother) {
    EXPECT_EQ(moves_between({1, 2, 3, 4}, {1, 2, 3, 4}), 0u);
    EXPECT_EQ(moves_between({1, 2, 3, 4}, {4, 1, 2, 3}), 1u);
    EXPECT_EQ(moves_between({1, 2, 3, 4}, {4, 3, 2, 1}), 3u);
    EXPECT_EQ(moves_between({1, 2}, {1, 2, 1}), 1u);
    EXPECT_EQ(moves_between({}, {}), 0u);
}

TEST(Prices, OfTheThreeTimesAreComplete) {
    for (const char* name : {"1974", "1992", "today"}) {
        const PriceList list = read_prices(folder + name + ".toml");
        EXPECT_EQ(list.name, name);
        EXPECT_EQ(list.prices.size(), 8u);
        for (const auto& [what, price] : list.prices) EXPECT_GT(price.source.size(), 5u) << what;
    }
    EXPECT_GT(read_recipes(folder + "recipes.toml").size(), 10u);
    // What is said of it: memory has fallen more than time.
    const PriceList then = read_prices(folder + "1974.toml"),
                    now = read_prices(folder + "today.toml");
    EXPECT_GT(then.prices.at("memory").value / then.prices.at("machine").value,
              now.prices.at("memory").value / now.prices.at("machine").value);
}

TEST(Prices, AreOperationsTimesPricesForTheRentOfThatTime) {
    const GrowthPoint point{"polygons",
                            false,
                            1,
                            "z-buffer",
                            {{"depths", 10}, {"keys", 99}, {"peak_bytes", 3 * 1048576.0}}};
    const Cost cost = cost_of(point, unit_prices(),
                              {{"depths", {{"add", 2}, {"load", 3}}}, {"rays", {{"divide", 7}}}});
    EXPECT_NEAR(cost.seconds, 50e-6, 1e-15);
    EXPECT_NEAR(cost.dollars, 50e-6 * (1 + 3) / (30 * 24 * 3600.0), 1e-20);
}

TEST(Prices, FlipWhereTheCurvesCross) {
    const Recipes recipes{{"rays", {{"add", 1}}}, {"depths", {{"add", 1}}}};
    const auto ranked = rankings(made_up(), "polygons", false, unit_prices(), recipes);
    ASSERT_EQ(ranked.size(), 6u);
    EXPECT_EQ(ranked.front().algorithms[0].first, "ray-casting");
    EXPECT_EQ(ranked.back().algorithms[0].first, "z-buffer");
    const auto found = flips(ranked);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].before, "ray-casting");
    EXPECT_EQ(found[0].after, "z-buffer");
    EXPECT_NEAR(found[0].x, 100, 1e-6);
}

TEST(Prices, RefuseWhatIsNoList) {
    const std::string price = "[[price]]\nwhat = \"add\"\nvalue = 1\nsource = \"s\"\n";
    EXPECT_NE(message_of("name = \"a\"\n" + price, false).find("no price of 'compare'"),
              std::string::npos);
    EXPECT_NE(
        message_of("name = \"a\"\n" + price + price, false).find(":6: a second price of 'add'"),
        std::string::npos);
    EXPECT_NE(message_of("name = \"a\"\n[[price]]\nwhat = \"ad\"\nvalue = 1\n", false).find(":3: "),
              std::string::npos);
    EXPECT_NE(
        message_of("name = \"a\"\n[[price]]\nwhat = \"add\"\nvalue = -1\nsource = \"s\"\n", false)
            .find(":4: "),
        std::string::npos);
    EXPECT_NE(
        message_of("name = \"a\"\n[[price]]\nwhat = \"add\"\nvalue = 1\n", false).find("no source"),
        std::string::npos);
    EXPECT_NE(message_of("name = \"a\"\nprice = 3\n", false).find(":2: "), std::string::npos);
    EXPECT_NE(message_of("[[recipe]]\ncount = \"depth\"\n", true).find(":2: "), std::string::npos);
    EXPECT_NE(message_of("[[recipe]]\ncount = \"depths\"\nadds = 1\n", true).find(":3: "),
              std::string::npos);
    EXPECT_NE(message_of("", true).find("no recipe"), std::string::npos);
}

}  // namespace gw::study
