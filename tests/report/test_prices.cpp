// Price lists: counters become estimated seconds as the list says, and a wrong list is refused.
#include "inspect/report/prices.h"

#include "gw/error.h"

#include <gtest/gtest.h>
#include "tests/temporary_folder.h"

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
        EXPECT_GT(p.nanoseconds, 0) << p.counter.name;
        EXPECT_GT(p.source.size(), 20u) << p.counter.name;
        estimates += p.estimate;
    }
    EXPECT_GT(estimates, 0);
    // A textured pixel with four look-ups: 17 million a second, as the report of its makers says.
    EXPECT_NEAR(1 / estimated_seconds({.fragments = 1, .texels = 4}, list), 17e6, 0.02e6);
    // The whole screen is cleared in 0.8 ms.
    EXPECT_NEAR(estimated_seconds({.pixels = 1280 * 1024}, list), 0.8e-3, 0.02e-3);
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
    expect_refused("machine = ", "prices.toml");
}

}  // namespace gw::report
