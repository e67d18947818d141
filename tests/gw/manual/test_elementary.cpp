// docs/manual/elementary.md: the page's algorithms and tables, transcribed, are the machine's.
#include "conformance/generate/random.h"
#include "gw/base/elementary.h"
#include "gw/base/elementary_tables.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace gw {
namespace {

struct Sum {
    double hi, lo;
};

/// A table of the page: rows "| i | hi | lo |" after the rule.
std::map<int, Sum> table_after(const std::string& rule) {
    std::ifstream page(GW_SOURCE_DIR "/docs/manual/elementary.md");
    std::map<int, Sum> out;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("**[")) inside = line.starts_with("**[" + rule + "]**");
        std::istringstream words(line);
        std::string bar, i, hi, lo;
        words >> bar >> i >> bar >> hi >> bar >> lo;
        if (inside && bar == "|" && hi.find("0x") != hi.npos)
            out[std::stoi(i)] = {std::strtod(hi.c_str(), nullptr),
                                 std::strtod(lo.c_str(), nullptr)};
    }
    return out;
}

struct Tables {
    std::map<int, Sum> log_node = table_after("R3.8"), exp2_node = table_after("R3.9");
};
const Tables& tables() {
    static const Tables all;
    return all;
}

// ---- The page, line by line ---------------------------------------------------------------------

Sum two_sum(double a, double b) {
    const double hi = a + b, part = hi - a;
    return {hi, (a - (hi - part)) + (b - part)};
}

Sum two_product(double a, double b) {
    const double a_up = a * 134217729, b_up = b * 134217729;
    const double a_hi = a_up - (a_up - a), b_hi = b_up - (b_up - b);
    const double a_lo = a - a_hi, b_lo = b - b_hi, hi = a * b;
    return {hi, ((a_hi * b_hi - hi) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

Sum divide(Sum a, Sum b) {
    const double quotient = a.hi / b.hi;
    const Sum back = two_product(quotient, b.hi);
    return {quotient, ((a.hi - back.hi) - back.lo + a.lo - quotient * b.lo) / b.hi};
}

double polynomial(double z, const std::vector<double>& c) {
    double sum = c.back();
    for (std::size_t i = c.size() - 1; i-- > 0;) sum = c[i] + z * sum;
    return sum;
}

Sum log_as_sum(double x) {
    int k = 0;
    double m = std::frexp(x, &k);  // 1/2 <= m < 1
    if (m < 45.25 / 64) {
        m *= 2;
        --k;
    }
    const int i = int(std::nearbyint(64 * m));
    const double c = i / 64.0;
    const Sum s = divide({m - c, 0}, two_sum(m, c));
    const double z = s.hi * s.hi;
    const double tail = s.hi * z * polynomial(z, {2 / 3.0, 2 / 5.0, 2 / 7.0, 2 / 9.0, 2 / 11.0});
    const Sum ln2{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45}, node = tables().log_node.at(i);
    const Sum sum = two_sum(k * ln2.hi + node.hi, 2 * s.hi);
    const double rest = sum.lo + (tail + (2 * s.lo + (k * ln2.lo + node.lo)));
    return two_sum(sum.hi, rest);
}

double exp_of_sum(Sum x) {
    const Sum ln2_64th{0x1.62e42fefap-7, 0x1.cf79abc9e3b3ap-46};
    if (x.hi > 710) return INFINITY;
    if (x.hi < -746) return 0;
    const double k = std::nearbyint(x.hi * 0x1.71547652b82fep6);
    const double r = (x.hi - k * ln2_64th.hi) + (x.lo - k * ln2_64th.lo);
    const double p = r + r * r * polynomial(r, {1 / 2.0, 1 / 6.0, 1 / 24.0, 1 / 120.0, 1 / 720.0});
    const int i = int(k) & 63, e = (int(k) - i) / 64;
    const Sum node = tables().exp2_node.at(i);
    return std::ldexp(node.hi + (node.lo + node.hi * p), e);
}

double page_pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (x == 0) return 0;
    const Sum l = log_as_sum(x);
    const double estimate = y * l.hi;
    if (estimate > 710) return INFINITY;
    if (estimate < -746) return 0;
    const Sum product = two_product(y, l.hi);
    return exp_of_sum({product.hi, product.lo + y * l.lo});
}

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// [R3.8] [R3.9]
TEST(ManualElementary, TheTablesOfThePageAreTheMachines) {
    ASSERT_EQ(tables().log_node.size(), 46u);
    ASSERT_EQ(tables().exp2_node.size(), 64u);
    for (const auto& [i, sum] : tables().log_node) {
        const auto& ours = elementary::log_node[i - elementary::first_log_node];
        EXPECT_TRUE(same(sum.hi, ours.hi) && same(sum.lo, ours.lo)) << i;
    }
    for (const auto& [i, sum] : tables().exp2_node) {
        const auto& ours = elementary::exp2_node[i];
        EXPECT_TRUE(same(sum.hi, ours.hi) && same(sum.lo, ours.lo)) << i;
    }
}

// [R3.1] [R3.2] [R3.3] [R3.4] [R3.5] [R3.6] [R3.7]
TEST(ManualElementary, ThePagesAlgorithmsAreTheMachines) {
    conformance::Random r(3);
    for (int i = 0; i < 200000; ++i) {
        const double x = r.chance(20) ? r.scaled(0.5, 1, -1070, 0) : r.real(0, 1);
        const double y = r.chance(50) ? r.between(0, 128) : float(r.scaled(0, 1, -10, 14));
        ASSERT_TRUE(same(page_pow(x, y), pow(x, y))) << x << " ^ " << y;
        const double e = r.scaled(-1, 1, -60, 10);
        ASSERT_TRUE(same(exp_of_sum({e, 0}), exp(e))) << e;
    }
    for (const double x : {0.0, 1.0, 0.5, 45.25 / 64, 90.5 / 128, 0x1p-1074})
        for (const double y : {0.0, 1.0, 0.5, 10000.0})
            ASSERT_TRUE(same(page_pow(x, y), pow(x, y))) << x << " ^ " << y;
    EXPECT_TRUE(std::isnan(exp(NAN)));
    EXPECT_EQ(exp(-INFINITY), 0);
}

TEST(ManualElementary, PowStepByStep) {
    const Sum a = log_as_sum(0.75);
    EXPECT_EQ(a.hi, -0x1.269621134db92p-2);
    EXPECT_EQ(a.lo, -0x1.e0efadd9dbp-56);
    const Sum product = two_product(20, a.hi);
    EXPECT_EQ(product.hi, -0x1.703ba95821276p+2);
    EXPECT_EQ(product.lo + 20 * a.lo, -0x1.164ae654147p-50);
    const Sum b = log_as_sum(0.9);
    EXPECT_EQ(b.hi, -0x1.af8e8210a415cp-4);
    EXPECT_EQ(b.lo, 0x1.62ed2p-58);
}

TEST(ManualElementary, PowersOfTheExamples) {
    EXPECT_EQ(pow(0.75, 20), 0x1.9fa83722p-9);
    EXPECT_EQ(pow(0.9, 27.3), 0x1.cd8a8a7144f76p-5);
    EXPECT_EQ(exp(-1), 0x1.78b56362cef38p-2);
}

}  // namespace
}  // namespace gw
