// A deterministic generator: the same numbers on every machine and with every compiler. Does not
// use the standard distributions, whose results are not specified. Draw one number per full
// expression or within braces, because compilers choose the order of operands and arguments.
#pragma once

#include "gw/describe/enumerators.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace gw::conformance {

/// The finalizer of splitmix64 [Steele, Lea, Flood 2014]: a bijection whose every output bit
/// depends on every input bit.
constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// splitmix64.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() { return mixed(state_ += 0x9e3779b97f4a7c15u); }
    /// 0 .. n - 1.
    int below(int n) {
        return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(n) >> 32);
    }
    /// low .. high, both included.
    int between(int low, int high) { return low + below(high - low + 1); }
    bool chance(int percent) { return below(100) < percent; }
    /// low .. high, a multiple of (high - low) 2^-53.
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    /// A magnitude of any size: real(low, high) * 2^e, e in low_exponent .. high_exponent.
    double scaled(double low, double high, int low_exponent, int high_exponent) {
        const double v = real(low, high);
        return std::ldexp(v, between(low_exponent, high_exponent));
    }
    /// -1 in `percent` of 100 cases, else 1.
    int sign(int percent) { return chance(percent) ? -1 : 1; }
    std::uint32_t bits(int n) {
        return n == 0 ? 0 : static_cast<std::uint32_t>(next() >> (64 - n));
    }

    template <typename T>
    T pick(std::initializer_list<T> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }
    template <typename T>
    const T& pick(const std::vector<T>& values) {
        return values[std::size_t(below(static_cast<int>(values.size())))];
    }
    /// Any value of an enumeration, of those up to `last` if one is given.
    template <typename Enum>
    Enum any() {
        return any(last_of<Enum>);
    }
    template <typename Enum>
    Enum any(Enum last) {
        return static_cast<Enum>(below(static_cast<int>(last) + 1));
    }

private:
    std::uint64_t state_;
};

/// The seed of list `index` of a suite: FNV-1a over the name, mixed with the index. Without the
/// mixing, the seeds of neighbours would be a step of next() apart and share their numbers.
constexpr std::uint64_t seed_of(std::string_view suite, std::uint64_t index) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : suite) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return mixed(h ^ index);
}

}  // namespace gw::conformance
