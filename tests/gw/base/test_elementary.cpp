// The elementary functions: error bounds over strides of floats and over doubles, special values,
// and one digest that every compiler and processor must give.
#include <bit>
#include <limits>

#include "tests/gw/base/elementary_oracle.h"

namespace gw::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t stride = 9973;
constexpr double largest_angle = 0x1p20;

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

}  // namespace

TEST(Elementary, ExpIsAccurate) {
    expect_below(exp_over_floats(stride), exp_bound);
    expect_below(worst_over_doubles(
                     -708, 709.7, [](double x) { return exp(x); },
                     [](long double x) { return std::exp(x); }),
                 exp_bound);
}

TEST(Elementary, LogIsAccurate) {
    expect_below(log_over_floats(stride), log_bound);
    expect_below(
        worst_over_doubles(
            0.5, 2, [](double x) { return log(x); }, [](long double x) { return std::log(x); }),
        log_bound);
    expect_below(
        worst_over_doubles(
            0, 1e300, [](double x) { return log(x); }, [](long double x) { return std::log(x); }),
        log_bound);
}

TEST(Elementary, PowIsAccurate) {
    for (const double y : {0.01, 0.5, 2.2, 10.0, 50.0, 200.0, 1000.0, 1e5}) {
        expect_pow_accurate(y, stride);
        const auto own = [y](double x) { return pow(x, y); };
        const auto exact = [y](long double x) { return std::pow(x, static_cast<long double>(y)); };
        expect_below(worst_over_doubles(std::exp2(-1021.9 / y), 1, own, exact), pow_bound);
    }
    // Huge exponents close to 1: the logarithm must keep its relative precision.
    const auto own = [](double x) { return pow(x, 3e8); };
    const auto exact = [](long double x) { return std::pow(x, 3e8L); };
    expect_below(worst_over_doubles(1 - 1e-6, 1 + 1e-6, own, exact), pow_bound);
}

TEST(Elementary, SinCosTanAreAccurate) {
    expect_below(sin_over_floats(stride), sin_bound);
    expect_below(cos_over_floats(stride), cos_bound);
    expect_below(tan_over_floats(stride), tan_bound);
    const auto sin_exact = [](long double x) { return std::sin(x); };
    const auto cos_exact = [](long double x) { return std::cos(x); };
    const auto tan_exact = [](long double x) { return std::tan(x); };
    for (const double range : {7.0, largest_angle}) {
        expect_below(worst_over_doubles(
                         -range, range, [](double x) { return sin(x); }, sin_exact),
                     sin_bound);
        expect_below(worst_over_doubles(
                         -range, range, [](double x) { return cos(x); }, cos_exact),
                     cos_bound);
        expect_below(worst_over_doubles(
                         -range, range, [](double x) { return tan(x); }, tan_exact),
                     tan_bound);
    }
}

// The doubles nearest to multiples of pi/2, at which the reduction cancels most.
TEST(Elementary, SinCosAreAccurateNearTheirZeros) {
    Worst sin_worst, cos_worst;
    for (int k = 1; k * (pi_long / 2) < static_cast<long double>(largest_angle); ++k) {
        const auto x = static_cast<double>(k * (pi_long / 2));
        sin_worst.see(x, sin(x), std::sin(static_cast<long double>(x)));
        cos_worst.see(x, cos(x), std::cos(static_cast<long double>(x)));
    }
    expect_below(sin_worst, sin_bound);
    expect_below(cos_worst, cos_bound);
}

// The oracle takes quarter turns off exactly, before it multiplies by pi.
TEST(Elementary, DegreesAreAccurate) {
    const auto exact_sin = [](long double x) {
        int quarters = 0;
        const long double angle = std::remquo(x, 90.0L, &quarters) * (pi_long / 180);
        const long double value = quarters % 2 == 0 ? std::sin(angle) : std::cos(angle);
        return (quarters & 2) == 0 ? value : -value;
    };
    const auto exact_cos = [&](long double x) { return exact_sin(x + 90); };
    const auto exact_tan = [&](long double x) { return exact_sin(x) / exact_cos(x); };
    expect_below(worst_over_doubles(
                     -1e5, 1e5, [](double x) { return sin_degrees(x); }, exact_sin),
                 sin_bound);
    expect_below(worst_over_doubles(
                     -1e5, 1e5, [](double x) { return cos_degrees(x); }, exact_cos),
                 cos_bound);
    expect_below(worst_over_doubles(
                     -1e5, 1e5, [](double x) { return tan_degrees(x); }, exact_tan),
                 tan_bound);
}

TEST(Elementary, QuarterTurnsInDegreesAreExact) {
    const double sines[4] = {0, 1, 0, -1};
    for (int k = -400; k <= 400; ++k) {
        EXPECT_EQ(bits(sin_degrees(90 * k)), bits(sines[k & 3])) << k;
        EXPECT_EQ(bits(cos_degrees(90 * k)), bits(sines[(k + 1) & 3])) << k;
    }
    EXPECT_EQ(sin_degrees(30), 0.5);
    EXPECT_EQ(cos_degrees(60), 0.5);
    EXPECT_EQ(tan_degrees(45), 1);
    EXPECT_EQ(tan_degrees(90), infinity);
}

TEST(Elementary, OddAndEvenFunctionsAreSo) {
    Doubles next(2);
    for (int i = 0; i < 10'000; ++i) {
        const double x = next(-1000, 1000);
        EXPECT_EQ(sin(-x), -sin(x));
        EXPECT_EQ(cos(-x), cos(x));
        EXPECT_EQ(tan(-x), -tan(x));
        EXPECT_EQ(atan2(-x, 100), -atan2(x, 100));
    }
}

TEST(Elementary, InverseFunctionsAreAccurate) {
    expect_below(acos_over_floats(stride), acos_bound);
    expect_below(asin_over_floats(stride), asin_bound);
    const auto acos_exact = [](long double x) { return std::acos(x); };
    const auto asin_exact = [](long double x) { return std::asin(x); };
    expect_below(worst_over_doubles(
                     -1, 1, [](double x) { return acos(x); }, acos_exact),
                 acos_bound);
    expect_below(worst_over_doubles(
                     -1, 1, [](double x) { return asin(x); }, asin_exact),
                 asin_bound);
    for (const double x : {1e-3, 0.7, 1.0, -2.5, -1e6}) {
        const auto exact = [x](long double y) {
            return std::atan2(y, static_cast<long double>(x));
        };
        expect_below(worst_over_doubles(
                         -2, 2, [x](double y) { return atan2(y, x); }, exact),
                     atan2_bound);
    }
}

TEST(Elementary, PowAtTheEndsOfItsRange) {
    EXPECT_EQ(pow(0, 0), 1);
    EXPECT_EQ(pow(0, 0.5), 0);
    EXPECT_EQ(pow(0, -1), infinity);
    EXPECT_EQ(pow(1, 1e308), 1);
    EXPECT_EQ(pow(0.5, 1074), 0x1p-1074);
    EXPECT_EQ(pow(0.5, 1076), 0);
    EXPECT_EQ(pow(2, 1023), 0x1p1023);
    EXPECT_EQ(pow(2, 1024), infinity);
    EXPECT_EQ(pow(0.5, infinity), 0);
    EXPECT_EQ(pow(infinity, -2), 0);
    EXPECT_EQ(pow(std::numeric_limits<double>::max(), 1), std::numeric_limits<double>::max());
    EXPECT_EQ(pow(0x1p-1074, 1), 0x1p-1074);
    EXPECT_NE(pow(-1, 2), pow(-1, 2));
}

TEST(Elementary, ExpAndLogAtTheEndsOfTheirRanges) {
    EXPECT_EQ(exp(0), 1);
    EXPECT_EQ(exp(-1e308), 0);
    EXPECT_EQ(exp(-745.1), 0x1p-1074);
    EXPECT_EQ(exp(-745.2), 0);
    EXPECT_EQ(exp(709.8), infinity);
    EXPECT_EQ(log(1), 0);
    EXPECT_EQ(log(0), -infinity);
    EXPECT_EQ(log(infinity), infinity);
    EXPECT_NE(log(-1), log(-1));
}

TEST(Elementary, ArgumentsOutsideTheRangeGiveNan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double outside = largest_angle + 1;
    for (const double x : {exp(nan), log(nan), pow(nan, 2), pow(0.5, nan), sin(nan), cos(nan),
                           tan_degrees(nan), acos(nan), asin(nan), sin(outside), cos(-outside),
                           tan(infinity), sin_degrees(outside), acos(1.5), asin(-1.5)}) {
        EXPECT_NE(x, x);
    }
}

TEST(Elementary, Atan2KnowsItsQuadrant) {
    EXPECT_EQ(atan2(0, 1), 0);
    EXPECT_EQ(atan2(0, -1), pi);
    EXPECT_EQ(atan2(-0.0, -1), -pi);
    EXPECT_EQ(atan2(1, 0), pi / 2);
    EXPECT_EQ(atan2(-1, 0), -pi / 2);
    EXPECT_EQ(atan2(1, 1), pi / 4);
    EXPECT_EQ(atan2(1, -1), 3 * pi / 4);
    EXPECT_EQ(atan2(0, 0), 0);
}

TEST(Elementary, GivesTheSameBitsEverywhere) {
    const struct {
        const char* call;
        double value;
        std::uint64_t expected;
    } rows[] = {
        {"exp(-1)", exp(-1), 0x3fd78b56362cef38},
        {"exp(-0.1)", exp(-0.1), 0x3fecf46d99d52b3a},
        {"exp(-103.9)", exp(-103.9), 0x36913220ab08c519},
        {"log(0.3)", log(0.3), 0xbff34378fcbda721},
        {"pow(0.9, 50)", pow(0.9, 50), 0x3f751c1fff764631},
        {"pow(0.5, 0.3)", pow(0.5, 0.3), 0x3fe9fdf8bcce533d},
        {"pow(0.999, 1000)", pow(0.999, 1000), 0x3fd788526411ed72},
        {"pow(0.1, 307.9)", pow(0.1, 307.9), 0x00090d7a3a045676},
        {"sin(1)", sin(1), 0x3feaed548f090cee},
        {"sin(12345.678)", sin(12345.678), 0xbfe687d5890974a5},
        {"cos(1)", cos(1), 0x3fe14a280fb5068c},
        {"cos(-99999)", cos(-99999), 0xbfe050e628324337},
        {"tan(0.7)", tan(0.7), 0x3feaf406c2fc78ae},
        {"tan(1.5707963267948966)", tan(1.5707963267948966), 0x434d02967c31cdb5},
        {"sin_degrees(30)", sin_degrees(30), 0x3fe0000000000000},
        {"cos_degrees(45)", cos_degrees(45), 0x3fe6a09e667f3bcd},
        {"tan_degrees(22.5)", tan_degrees(22.5), 0x3fda827999fcef32},
        {"atan2(1, 2)", atan2(1, 2), 0x3fddac670561bb4f},
        {"atan2(-3, -0.5)", atan2(-3, -0.5), 0xbffbc66e44cbc074},
        {"acos(0.3)", acos(0.3), 0x3ff441f5ecbeef59},
        {"asin(0.999)", asin(0.999), 0x3ff86ac9ad18f803},
    };
    for (const auto& row : rows) EXPECT_EQ(bits(row.value), row.expected) << row.call;
}

// 100,000 arguments of each function in one number (FNV-1a over the bits of the results).
TEST(Elementary, GivesTheSameBitsEverywhereInBulk) {
    std::uint64_t digest = 0xcbf29ce484222325;
    const auto add = [&](double value) { digest = (digest ^ bits(value)) * 0x100000001b3; };
    Doubles next(3);
    for (int i = 0; i < 100'000; ++i) {
        add(exp(next(-200, 1)));
        add(log(next(0, 2)));
        const double base = next(0, 1);
        add(pow(base, next(0, 200)));
        const double angle = next(-100, 100);
        add(sin(angle));
        add(cos(angle));
        add(tan(angle));
        add(sin_degrees(angle));
        add(atan2(angle, next(-100, 100)));
        add(acos(next(-1, 1)));
    }
    EXPECT_EQ(digest, 2683455531783972859u);
}

}  // namespace gw::oracle
