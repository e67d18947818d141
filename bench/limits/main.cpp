// What this processor can do at most, one core: bench_limits prints as JSON the nanoseconds of a
// byte or a pixel, and bench/limits/page.py sets the machine's times beside them. Each is the least
// of several repeats over memory of one size.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <vector>

namespace {

/// Each loop is compiled for the processor's widest vectors.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define GW_WIDEST [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define GW_WIDEST
#endif

/// Keeps the compiler from leaving out what made the memory.
void use(const void* memory) { asm volatile("" : : "g"(memory) : "memory"); }

/// The least nanoseconds of a run over `count` elements, by element.
double least(std::size_t count, const auto& run) {
    double best = 1e300;
    for (int i = 0; i < 9; ++i) {
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < 4; ++k) run();
        const std::chrono::duration<double, std::nano> time =
            std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count() / 4 / double(count));
    }
    return best;
}

/// A plane of 1024x1024 colours of 8 bytes, and one that stays in the cache of a core.
constexpr std::size_t memory_bytes = std::size_t{8} << 20, cache_bytes = std::size_t{128} << 10;

double set_bytes(std::size_t bytes) {
    std::vector<char> to(bytes);
    return least(bytes, [&] {
        std::memset(to.data(), 1, bytes);
        use(to.data());
    });
}
double copy_bytes(std::size_t bytes) {
    std::vector<char> to(bytes), from(bytes, 1);
    return least(bytes, [&] {
        std::memcpy(to.data(), from.data(), bytes);
        use(to.data());
    });
}

GW_WIDEST void add_to(std::uint16_t* plane, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        plane[i] = static_cast<std::uint16_t>(std::min(plane[i] + 3, 255));
}
/// Adds a colour of four channels of 16 bits to each pixel of a plane in the cache.
double add_pixels() {
    std::vector<std::uint16_t> plane(cache_bytes / 2);
    return least(plane.size() / 4, [&] {
        add_to(plane.data(), plane.size());
        use(plane.data());
    });
}

GW_WIDEST void multiply(std::uint16_t* plane, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        std::uint16_t x = plane[i];
        for (const unsigned by : {40000u, 50000u, 60000u, 45000u, 55000u, 65000u})
            x = static_cast<std::uint16_t>(x * by >> 16);
        plane[i] = static_cast<std::uint16_t>(x + 1);
    }
}
/// The multiplications of a bilinear texel, MODULATE and a blend: 3 + 1 + 2 for each of four
/// channels.
double multiply_pixels() {
    std::vector<std::uint16_t> plane(cache_bytes / 2, 77);
    return least(plane.size() / 4, [&] {
        multiply(plane.data(), plane.size());
        use(plane.data());
    });
}

GW_WIDEST void join(const std::uint64_t* low, const std::uint64_t* high, std::uint64_t* to,
                    std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to[i] = low[i] ^ low[i + 1] ^ high[i] ^ high[i + 1];
}
/// The four texels of a bilinear filter, of 8 bytes each, for pixels that lie beside each other.
double load_texels() {
    constexpr std::size_t side = 256;
    const std::vector<std::uint64_t> texels(side * side, 3);
    std::vector<std::uint64_t> row(side);
    return least(side * (side - 2), [&] {
        for (std::size_t y = 0; y + 2 < side; ++y) {
            join(&texels[y * side], &texels[(y + 1) * side], row.data(), side);
            use(row.data());
        }
    });
}

struct Point {
    float x, y, z;
};
GW_WIDEST void transform(const Point* points, std::size_t count, const double* m, double* to) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t r = 0; r < 4; ++r)
            to[4 * i + r] = m[r] * double(points[i].x) + m[4 + r] * double(points[i].y) +
                            m[8 + r] * double(points[i].z) + m[12 + r];
}
/// A vertex of three floats by a matrix of doubles, as the manual says.
double transform_vertices() {
    const std::vector<Point> points(1 << 12, {1, 2, 3});
    std::vector<double> out(4 * points.size());
    double m[16];
    std::iota(m, m + 16, 0.5);
    return least(points.size(), [&] {
        use(m);
        transform(points.data(), points.size(), m, out.data());
        use(out.data());
    });
}

}  // namespace

int main() {
    const nlohmann::json limits{{"set a byte of memory", set_bytes(memory_bytes)},
                                {"copy a byte of memory", copy_bytes(memory_bytes)},
                                {"set a byte of cache", set_bytes(cache_bytes)},
                                {"copy a byte of cache", copy_bytes(cache_bytes)},
                                {"add a colour", add_pixels()},
                                {"multiply a pixel", multiply_pixels()},
                                {"load 4 texels", load_texels()},
                                {"transform a vertex", transform_vertices()}};
    std::puts(limits.dump(2).c_str());
}
