// gw::pow() a vector at a time, for lighting: bases in [0, 1]. Steps, order and tables are those of
// gw/base/elementary.cpp, so the bits are the same. Included once per Highway target that has
// vectors of doubles.
#if defined(GW_FAST_POWER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_POWER_INL_H_
#undef GW_FAST_POWER_INL_H_
#else
#define GW_FAST_POWER_INL_H_
#endif

#include "gw/base/elementary.h"
#include "gw/base/elementary_tables.h"
#include "gw/fast/simd/doubles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

using I64 = hn::Rebind<std::int64_t, D64>;

/// The unevaluated sum of two vectors.
struct SumLanes {
    V64 hi, lo;
};

inline SumLanes two_sum(V64 a, V64 b) {
    const auto hi = hn::Add(a, b), b_part = hn::Sub(hi, a);
    return {hi, hn::Add(hn::Sub(a, hn::Sub(hi, b_part)), hn::Sub(b, b_part))};
}

inline SumLanes two_product(V64 a, V64 b) {
    const auto split = all(134217729.0);  // 2^27 + 1
    const auto a_up = hn::Mul(a, split), b_up = hn::Mul(b, split);
    const auto a_hi = hn::Sub(a_up, hn::Sub(a_up, a)), b_hi = hn::Sub(b_up, hn::Sub(b_up, b));
    const auto a_lo = hn::Sub(a, a_hi), b_lo = hn::Sub(b, b_hi);
    const auto hi = hn::Mul(a, b);
    const auto cross = hn::Add(hn::Add(hn::Sub(hn::Mul(a_hi, b_hi), hi), hn::Mul(a_hi, b_lo)),
                               hn::Mul(a_lo, b_hi));
    return {hi, hn::Add(cross, hn::Mul(a_lo, b_lo))};
}

inline SumLanes divide(const SumLanes& a, const SumLanes& b) {
    const auto quotient = hn::Div(a.hi, b.hi);
    const SumLanes back = two_product(quotient, b.hi);
    const auto rest =
        hn::Sub(hn::Add(hn::Sub(hn::Sub(a.hi, back.hi), back.lo), a.lo), hn::Mul(quotient, b.lo));
    return {quotient, hn::Div(rest, b.hi)};
}

template <std::size_t n>
V64 polynomial(V64 z, const double (&c)[n]) {
    auto sum = all(c[n - 1]);
    for (std::size_t i = n - 1; i-- > 0;) sum = hn::Add(all(c[i]), hn::Mul(z, sum));
    return sum;
}

inline SumLanes node_at(const Sum* table, hn::Vec<I64> index) {
    const D64 d;
    const auto at = hn::Add(index, index);
    const double* first = &table->hi;
    return {hn::GatherIndex(d, first, at),
            hn::GatherIndex(d, first, hn::Add(at, hn::Set(I64(), 1)))};
}

/// 2^e for -1022 <= e <= 1023.
inline V64 power_of_two_lanes(hn::Vec<I64> e) {
    return hn::BitCast(D64(), hn::ShiftLeft<52>(hn::Add(e, hn::Set(I64(), 1023))));
}

/// log x, x normal.
inline SumLanes log_as_sum(V64 x) {
    const I64 i64;
    const auto bits = hn::BitCast(i64, x);
    const auto k = hn::ShiftRight<52>(hn::Sub(bits, hn::BitCast(i64, all(45.25 / 64))));
    const auto m = hn::BitCast(D64(), hn::Sub(bits, hn::ShiftLeft<52>(k)));
    const auto scaled = nearest(hn::Mul(m, all(64)));
    const auto c = hn::Mul(scaled, all(1 / 64.0));
    const SumLanes s = divide({hn::Sub(m, c), hn::Zero(D64())}, two_sum(m, c));

    constexpr double terms[] = {2 / 3.0, 2 / 5.0, 2 / 7.0, 2 / 9.0, 2 / 11.0};
    const auto square = hn::Mul(s.hi, s.hi);
    const auto tail = hn::Mul(hn::Mul(s.hi, square), polynomial(square, terms));
    const SumLanes node = node_at(
        elementary::log_node, hn::Sub(integers(scaled), hn::Set(i64, elementary::first_log_node)));
    const auto times = doubles(k);
    const SumLanes sum =
        two_sum(hn::Add(hn::Mul(times, all(elementary::ln2.hi)), node.hi), hn::Mul(all(2), s.hi));
    const auto low =
        hn::Add(hn::Mul(all(2), s.lo), hn::Add(hn::Mul(times, all(elementary::ln2.lo)), node.lo));
    return two_sum(sum.hi, hn::Add(sum.lo, hn::Add(tail, low)));
}

/// e^(x.hi + x.lo), x.hi in [-746, 0].
inline V64 exp_of_sum(const SumLanes& x) {
    const I64 i64;
    const auto k = nearest(hn::Mul(x.hi, all(0x1.71547652b82fep6)));  // 64 / ln 2
    const auto r = hn::Add(hn::Sub(x.hi, hn::Mul(k, all(elementary::ln2_64th.hi))),
                           hn::Sub(x.lo, hn::Mul(k, all(elementary::ln2_64th.lo))));
    constexpr double terms[] = {1 / 2.0, 1 / 6.0, 1 / 24.0, 1 / 120.0, 1 / 720.0};
    const auto p = hn::Add(r, hn::Mul(hn::Mul(r, r), polynomial(r, terms)));

    const auto whole = integers(k), index = hn::And(whole, hn::Set(i64, 63));
    const SumLanes node = node_at(elementary::exp2_node, index);
    const auto value = hn::Add(node.hi, hn::Add(node.lo, hn::Mul(node.hi, p)));
    // scale(): below 2^-1022 in two steps.
    const auto e = hn::ShiftRight<6>(hn::Sub(whole, index)), least = hn::Set(i64, -1022);
    const auto small = hn::Lt(e, least);
    const auto first = hn::IfThenElse(small, hn::Sub(e, least), e),
               second = hn::IfThenElseZero(small, least);
    return hn::Mul(hn::Mul(value, power_of_two_lanes(first)), power_of_two_lanes(second));
}

/// base^exponent if `wanted`, else 0; bases in [0, 1].
inline V64 power(V64 base, double exponent, hn::Mask<D64> wanted) {
    const D64 d;
    const auto one = all(1), zero = hn::Zero(d);
    const auto denormal =
        hn::And(hn::And(wanted, hn::Gt(base, zero)), hn::Lt(base, all(0x1p-1022)));
    if (exponent > 0 && exponent < 0x1p100 && hn::AllFalse(d, denormal)) {
        const auto usual = hn::And(hn::And(wanted, hn::Gt(base, zero)), hn::Lt(base, one));
        if (hn::AllFalse(d, usual))
            return hn::IfThenElseZero(hn::And(wanted, hn::Eq(base, one)), one);
        const SumLanes log = log_as_sum(hn::IfThenElse(usual, base, all(0.5)));
        const auto estimate = hn::Mul(all(exponent), log.hi);
        const auto vanishes = hn::Lt(estimate, all(-746));
        const SumLanes product = two_product(all(exponent), hn::IfThenZeroElse(vanishes, log.hi));
        const auto x =
            exp_of_sum({product.hi, hn::Add(product.lo, hn::Mul(all(exponent), log.lo))});
        const auto value = hn::IfThenElse(usual, hn::IfThenZeroElse(vanishes, x),
                                          hn::IfThenElseZero(hn::Eq(base, one), one));
        return hn::IfThenElseZero(wanted, value);
    }
    alignas(64) double b[8], w[8];
    hn::Store(base, d, b);
    hn::Store(hn::IfThenElseZero(wanted, one), d, w);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) b[i] = w[i] != 0 ? gw::pow(b[i], exponent) : 0;
    return hn::Load(d, b);
}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
