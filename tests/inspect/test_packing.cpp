// Claim: packed values come back as they were, however they are distributed; few bytes where
// neighbours are alike; damaged bytes are refused or give other values, and nothing worse.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "inspect/manifest/packing.h"

#include <limits>

namespace gw::inspect {
namespace {

class Random {
public:
    explicit Random(std::uint32_t seed) : seed_(seed) {}
    std::uint32_t below(std::uint32_t end) {
        seed_ = seed_ * 1664525 + 1013904223;
        return (seed_ >> 8) % end;
    }

private:
    std::uint32_t seed_;
};

constexpr std::size_t pixels = 1000;

PackedChanges random_changes(Random& random, std::size_t channels) {
    PackedChanges changes;
    for (std::uint32_t at = random.below(50); at < pixels; at += 1 + random.below(50)) {
        const std::uint32_t count = 1 + random.below(static_cast<std::uint32_t>(pixels) - at);
        changes.runs.push_back({at, count});
        for (std::size_t i = 0; i < count * channels; ++i)
            changes.numbers.push_back(random.below(3) == 0 ? random.below(70000) : 7);
        at += count;
    }
    return changes;
}

}  // namespace

TEST(Packing, ComesBackAsItWas) {
    Random random(1);
    for (int i = 0; i < 300; ++i)
        for (const std::size_t channels : {std::size_t{1}, std::size_t{4}}) {
            const PackedChanges changes = random_changes(random, channels);
            const PackedChanges back = unpack(pack(changes, channels), pixels, channels);
            ASSERT_EQ(back.runs, changes.runs) << i;
            ASSERT_EQ(back.numbers, changes.numbers) << i;
        }
}

TEST(Packing, HoldsTheExtremesOfEveryPlane) {
    using Accum = std::numeric_limits<std::int32_t>;
    const PackedChanges changes{{{0, 6}},
                                {Accum::min(), Accum::max(), Accum::min(), 0, 0, 4294967295}};
    EXPECT_EQ(unpack(pack(changes, 1), 6, 1).numbers, changes.numbers);
}

TEST(Packing, OfNothingIsNothing) {
    EXPECT_TRUE(pack({}, 4).empty());
    EXPECT_TRUE(unpack({}, pixels, 4).runs.empty());
}

TEST(Packing, OfOneColorTakesAFewBytes) {
    PackedChanges changes{{{0, 640 * 480}}, {}};
    for (int i = 0; i < 640 * 480; ++i)
        for (const int channel : {10, 20, 30, 255}) changes.numbers.push_back(channel);
    EXPECT_LT(pack(changes, 4).size(), 20u);
}

TEST(Packing, OfDamagedBytesNeverDoesHarm) {
    Random random(2);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        auto bytes = pack(random_changes(random, 4), 4);
        if (bytes.empty()) continue;
        const auto at = random.below(static_cast<std::uint32_t>(bytes.size()));
        if (i % 2 == 0)
            bytes.resize(at);
        else
            bytes[at] = static_cast<std::uint8_t>(random.below(256));
        try {
            const PackedChanges back = unpack(bytes, pixels, 4);
            std::size_t end = 0;
            for (const PixelRun& run : back.runs) {
                ASSERT_GE(run.first, end);
                end = run.first + run.count;
            }
            ASSERT_LE(end, pixels);
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1500);
}

}  // namespace gw::inspect
