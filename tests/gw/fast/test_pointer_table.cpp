// The hash table of what a segment shares.
#include "gw/fast/plan/pointer_table.h"

#include <gtest/gtest.h>

#include <array>

namespace gw::fast {
namespace {

/// States that differ in a field which their hash leaves out: each costs no more than the one before.
TEST(PointerTable, KeepsAFewElementsOfOneHash) {
    std::array<int, 1000> numbers{};
    PointerTable<int> table;
    for (int& number : numbers) table.add(7, &number);
    EXPECT_EQ(table.size(), 8u);
    int compared = 0;
    EXPECT_EQ(table.find(7, [&](int&) { return ++compared, false; }), nullptr);
    EXPECT_EQ(compared, 8);
    EXPECT_EQ(table.find(7, [&](int& of) { return &of == &numbers[7]; }), &numbers[7]);
}

TEST(PointerTable, FindsElementsOfOtherHashes) {
    std::array<int, 1000> numbers{};
    PointerTable<int> table;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        table.add(7, &numbers[i]);
        table.add(1000 + i, &numbers[i]);
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
        EXPECT_EQ(table.find(1000 + i, [](int&) { return true; }), &numbers[i]) << i;
    table.clear();
    EXPECT_EQ(table.find(1000, [](int&) { return true; }), nullptr);
    EXPECT_EQ(table.size(), 0u);
}

}  // namespace
}  // namespace gw::fast
