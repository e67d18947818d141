// Price lists: counters become estimated seconds as the list says, and a wrong list is refused.
#include "inspect/report/prices.h"

#include "gw/error.h"

#include <gtest/gtest.h>
#include "tests/temporary_folder.h"

#include <algorithm>

namespace gw::report {
namespace {

/// A price list in a file that goes away.
class Prices : public testing::Test {
protected:
    PriceList read(const std::string& text) const {
        return read_prices(folder_.write("prices.toml", text));
    }
    void expect_refused(const std::string& text, const std::string& part) const {
        try {
            read(text);
            ADD_FAILURE() << "accepted: " << text;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }

private:
    TemporaryFolder folder_;
};

std::string price(const std::string& count, const std::string& stage,
                  const std::string& nanoseconds) {
    return "[[price]]\ncount = \"" + count + "\"\nstage = \"" + stage +
           "\"\nnanoseconds = " + nanoseconds + "\nsource = \"a book\"\n";
}

}  // namespace

TEST_F(Prices, APassTakesAsLongAsItsSlowestStage) {
    const PriceList list =
        read("machine = \"m\"\n" + price("primitives", "geometry", "1000") +
             price("fragments", "pixels", "20") + price("pixels", "pixels", "0.5"));
    EXPECT_EQ(list.machine, "m");
    EXPECT_DOUBLE_EQ(estimated_seconds({.primitives = 3, .fragments = 100, .pixels = 200}, list),
                     3e-6);
    EXPECT_DOUBLE_EQ(estimated_seconds({.primitives = 2, .fragments = 100, .pixels = 200}, list),
                     2.1e-6);
    EXPECT_EQ(estimated_seconds({}, list), 0);
    EXPECT_EQ(estimated_seconds({.draws = 7, .bytes = 1000}, list), 0);
}

TEST_F(Prices, OfTheVgxHaveSourcesAndSayWhatIsEstimated) {
    const PriceList list = vgx_prices();
    EXPECT_NE(list.machine.find("VGX"), std::string::npos);
    int estimates = 0;
    for (const Price& p : list.prices) {
        EXPECT_GT(p.nanoseconds, 0) << p.count.name;
        EXPECT_GT(p.source.size(), 20u) << p.count.name;
        estimates += p.estimate;
    }
    EXPECT_GT(estimates, 0);
    // A textured pixel with four look-ups: 17 million a second, as the report of its makers says.
    EXPECT_NEAR(1 / estimated_seconds({.fragments = 1, .texels = 4}, list), 17e6, 0.02e6);
    // The whole screen is cleared in 0.8 ms.
    EXPECT_NEAR(estimated_seconds({.pixels = 1280 * 1024}, list), 0.8e-3, 0.02e-3);
}

/// A list of every stage whose estimates are easy to say: 4 s, and from 2 to 12.
const std::string traced_list = R"(machine = "m"
[[price]]
count = "fragments"
stage = "pixels"
nanoseconds = 1000
low = 500
high = 4000
source = "a book"
[[price]]
count = "boxes"
stage = "processor"
nanoseconds = 2000
source = "a book"
[[price]]
count = "shaded"
stage = "processor"
nanoseconds = 1000
low = 1000
high = 6000
source = "a book"
)";

TEST_F(Prices, APictureIsTheSumOfItsPassesAndRays) {
    const PriceList list = read(traced_list);
    const std::vector<Counters> passes{{.fragments = 1000000}, {.fragments = 500000}};
    const raytrace::RayCounts rays{.shaded = 500000, .tests = {1000000, 77}};
    double sum = traced_seconds(rays, list);
    EXPECT_DOUBLE_EQ(sum, 2.5);
    for (const Counters& pass : passes) sum += estimated_seconds(pass, list);
    EXPECT_DOUBLE_EQ(picture_seconds(passes, rays, list), sum);
    EXPECT_DOUBLE_EQ(sum, 4);
}

TEST_F(Prices, IntervalsAreTheExtremesOfAllLimits) {
    const PriceList list = read(traced_list);
    EXPECT_EQ(extremes(list).size(), 4u) << "two prices have limits";
    const std::vector<Counters> passes{{.fragments = 1000000}};
    const PictureWork drawn{passes, {}}, traced{{}, {.shaded = 500000, .tests = {1000000, 0}}};
    const Interval seconds = seconds_interval(drawn, list);
    EXPECT_DOUBLE_EQ(seconds.value, 1);
    EXPECT_DOUBLE_EQ(seconds.low, 0.5);
    EXPECT_DOUBLE_EQ(seconds.high, 4);
    const Interval gain = ratio_interval(traced, drawn, list);
    EXPECT_DOUBLE_EQ(gain.value, 2.5);
    EXPECT_DOUBLE_EQ(gain.low, 2.5 / 4);
    EXPECT_DOUBLE_EQ(gain.high, 5 / 0.5);
    // The same prices above and below: a picture is as fast as itself at all of them.
    const Interval same = ratio_interval(traced, traced, list);
    EXPECT_EQ(same.low, 1);
    EXPECT_EQ(same.high, 1);
    EXPECT_EQ(ratio_interval(drawn, {}, list).value, 0);
}

TEST_F(Prices, ACalibratedListGivesItsTimeAndPredictsInProportion) {
    const PriceList list = read(traced_list +
                                "[calibration]\nseconds = 514\nlow = 257\nhigh = 1028\nrays = "
                                "7\nboxes = 1000\nshaded = 2000\nsource = \"Fig. 9\"\n");
    const raytrace::RayCounts rays{.shaded = 2000, .tests = {1000, 0}};
    EXPECT_DOUBLE_EQ(traced_seconds(rays, list), 514);
    const raytrace::RayCounts twice{.shaded = 4000, .tests = {2000, 0}};
    EXPECT_DOUBLE_EQ(traced_seconds(twice, list), 1028);
    // Whatever the prices are, the calibration's own rays take between its limits.
    const Interval seconds = seconds_interval({{}, rays}, list);
    EXPECT_DOUBLE_EQ(seconds.low, 257);
    EXPECT_DOUBLE_EQ(seconds.high, 1028);
}

TEST_F(Prices, BuiltInListsPriceEveryStage) {
    EXPECT_EQ(built_in_prices().size(), 3u);
    EXPECT_EQ(built_in_prices()[0].name, "vgx");
    for (const PriceList& list : built_in_prices()) {
        for (const char* stage : {"geometry", "pixels", "processor"})
            EXPECT_TRUE(
                std::ranges::any_of(list.prices, [&](const Price& p) { return p.stage == stage; }))
                << list.name << " " << stage;
        for (const Price& p : list.prices)
            EXPECT_TRUE(p.low <= p.nanoseconds && p.nanoseconds <= p.high) << p.count.name;
    }
    ASSERT_TRUE(built_in_prices()[0].calibration);
    EXPECT_EQ(built_in_prices()[0].calibration->seconds, 8 * 60 + 34) << "Fig. 9 [K4f]";
}

TEST_F(Prices, WrongListsAreRefusedWithTheirLine) {
    expect_refused("machine = \"m\"\n", "no prices");
    expect_refused(price("pixels", "pixels", "1"), "no machine");
    expect_refused("machine = \"m\"\n" + price("pixel", "pixels", "1"), ":3: ");
    expect_refused("machine = \"m\"\n" + price("pixels", "fog", "1"), "geometry");
    expect_refused("machine = \"m\"\n" + price("pixels", "pixels", "-1"), "nanoseconds");
    expect_refused("machine = \"m\"\n" + price("pixels", "pixels", "nan"), "nanoseconds");
    expect_refused(
        "machine = \"m\"\n" + price("pixels", "pixels", "1") + price("pixels", "pixels", "1"),
        "a second price of 'pixels'");
    expect_refused(
        "machine = \"m\"\n[[price]]\ncount = \"pixels\"\nstage = \"pixels\"\nnanoseconds = 1\n",
        "without 'source'");
    expect_refused("machine = \"m\"\n" + price("pixels", "processor", "1"), "expected processor");
    expect_refused("machine = \"m\"\n" + price("boxes", "pixels", "1"), "expected processor");
    expect_refused("machine = \"m\"\n" + price("pixels", "pixels", "1") + "low = 2\n", "limits");
    expect_refused("machine = \"m\"\n" + price("boxes", "processor", "1") +
                       "[calibration]\nseconds = 5\nrays = 3\nsource = \"a\"\n",
                   "no price");
    expect_refused("machine = \"m\"\n" + price("boxes", "processor", "1") +
                       "[calibration]\nseconds = 5\nsource = \"a\"\n",
                   "without 'rays'");
    expect_refused("machine = ", "prices.toml");
}

}  // namespace gw::report
