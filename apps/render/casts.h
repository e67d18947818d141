// Words and pictures of ray casting that the command and the lab share.
#pragma once

#include "image/picture.h"
#include "raytrace/casting/casting.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gw::apps {

inline constexpr std::pair<const char*, raytrace::CastMethod> cast_methods[] = {
    {"brute-force", raytrace::CastMethod::BruteForce},
    {"volumes", raytrace::CastMethod::BoundingVolumes},
    {"hierarchy", raytrace::CastMethod::Hierarchy},
    {"grid", raytrace::CastMethod::Grid}};
inline constexpr std::pair<const char*, raytrace::InsideTest> inside_tests[] = {
    {"crossings", raytrace::InsideTest::Crossings},
    {"products", raytrace::InsideTest::CrossProducts},
    {"angles", raytrace::InsideTest::Angles}};

/// The number of tests at each pixel in grey: the dearest pixel is white.
inline image::Picture picture_of_tests(const std::vector<std::uint32_t>& tests, int width,
                                       int height) {
    const std::uint64_t most =
        std::max<std::uint32_t>(1, *std::max_element(tests.begin(), tests.end()));
    std::vector<Rgba> color;
    for (const std::uint32_t n : tests) {
        const auto v = static_cast<std::uint16_t>((n * std::uint64_t{255} + most / 2) / most);
        color.push_back({v, v, v, 255});
    }
    return image::picture_of(color, width, height, 8);
}

}  // namespace gw::apps
