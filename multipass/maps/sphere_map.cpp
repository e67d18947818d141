#include "multipass/maps/sphere_map.h"

#include "gw/base/arithmetic.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

constexpr int positions = 4;  // per texel and direction

/// Where a 90 degree view of `size` pixels sees x / w, from -1 to 1.
std::size_t pixel(double x, double w, int size) {
    return std::size_t(std::clamp(int((x / w + 1) / 2 * size), 0, size - 1));
}

/// The mean of n values of `max`, as 16 bits.
std::uint16_t mean16(std::uint64_t sum, std::uint64_t n, std::uint64_t max) {
    return static_cast<std::uint16_t>((sum * 65535 * 2 + n * max) / (n * max * 2));
}

}  // namespace

const Rgba& CubePicture::seen(const dvec3& direction) const {
    for (std::size_t face = 0; face < 6; ++face) {
        const dvec3 e = transform3(dmat3(views[face].eye_from_world), direction);
        const int size = views[face].width;
        if (-e.z <= 0 || std::abs(e.x) > -e.z || std::abs(e.y) > -e.z) continue;
        return colors[face][pixel(e.y, -e.z, size) * std::size_t(size) + pixel(e.x, -e.z, size)];
    }
    return colors[0][0];
}

dvec3 direction_of(double s, double t) {
    // The point (x, y) of a unit sphere seen from far away reflects the line of sight so.
    const double x = 2 * s - 1, y = 2 * t - 1, r = x * x + y * y;
    if (r >= 1) return {0, 0, -1};
    const double z = std::sqrt(1 - r);
    return {2 * z * x, 2 * z * y, 2 * z * z - 1};
}

TextureRef sphere_map(std::string name, const CubePicture& around, const dmat4& eye_from_world,
                      int size, int color_bits) {
    const dmat3 world_from_eye = glm::transpose(dmat3(eye_from_world));
    const int fine = size * positions;
    const auto side = std::size_t(size);
    std::vector<std::array<std::uint64_t, 3>> sums(side * side);
    for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i) {
            const dvec3 d_eye = direction_of((i + 0.5) / fine, (j + 0.5) / fine);
            const Rgba& color = around.seen(transform3(world_from_eye, d_eye));
            auto& sum = sums[std::size_t(j / positions) * side + std::size_t(i / positions)];
            for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c];
        }
    std::vector<std::uint16_t> texels;
    for (const auto& sum : sums) {
        for (const std::uint64_t s : sum)
            texels.push_back(mean16(s, positions * positions, max_of_bits(color_bits)));
        texels.push_back(65535);
    }
    return make_texture(std::move(name), size, size, texels);
}

}  // namespace gw::multipass
