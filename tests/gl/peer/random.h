// The random numbers of programs: the same on every platform, without std distributions.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace gw::gl_peer {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t next() { return engine_(); }
    /// 0 .. n - 1.
    int below(int n) { return int(next() % std::uint64_t(n)); }
    /// low .. high, both included.
    int between(int low, int high) { return low + below(high - low + 1); }
    bool chance(int percent) { return below(100) < percent; }
    double real(double low, double high) {
        return low + (high - low) * (double(next() >> 11) * 0x1p-53);
    }
    template <class T>
    T pick(std::initializer_list<T> values) {
        return values.begin()[below(int(values.size()))];
    }
    template <class T>
    const T& pick(const std::vector<T>& values) {
        return values[std::size_t(below(int(values.size())))];
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace gw::gl_peer
