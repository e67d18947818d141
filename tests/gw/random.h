// Seeded random numbers for tests, the same on every platform. Does not use std distributions,
// which are not.
#pragma once

#include <cstdint>

namespace gw::test {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    /// low .. high, both included.
    std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + std::int64_t(next() % std::uint64_t(high - low + 1));
    }
    bool one_in(int n) { return next() % std::uint64_t(n) == 0; }
    /// A multiple of 2^-24 in [0, 1).
    float fraction() { return float(next() >> 40) / 16777216.0f; }

private:
    std::uint64_t state_;
};

}  // namespace gw::test
