#include "image/plane_pictures.h"

#include "gw/base/arithmetic.h"

#include <algorithm>
#include <cstdlib>

namespace gw::image {
namespace {

using Color = std::array<std::uint16_t, 3>;

template <class Values, class Paint>
Picture painted(const Values& values, int width, int height, const Paint& paint) {
    Picture picture{.width = width, .height = height, .channels = 3, .bits = 8, .values = {}};
    picture.values.reserve(values.size() * 3);
    for (const auto& value : values) {
        const Color color = paint(value);
        picture.values.insert(picture.values.end(), color.begin(), color.end());
    }
    return picture;
}

// 0 red, 1/4 yellow, 1/2 green, 3/4 cyan, 1 blue; linear between.
Color ramp(double t) {
    const auto channel = [](double v) {
        return static_cast<std::uint16_t>(clamp01(v) * 255 + 0.5);
    };
    return {channel(2 - 4 * t), channel(t < 0.5 ? 4 * t : 4 - 4 * t), channel(4 * t - 2)};
}

// An odd multiplier keeps distinct identifiers distinct in the low 24 bits.
Color id_color(std::uint32_t id) {
    const std::uint32_t h = (id + 1) * 0x9e3779b1u;
    return {static_cast<std::uint16_t>(h >> 16 & 255), static_cast<std::uint16_t>(h >> 8 & 255),
            static_cast<std::uint16_t>(h & 255)};
}

Color stencil_color(std::uint8_t value) {
    if (value == 0) return {0, 0, 0};
    constexpr int hues[7] = {1, 2, 4, 3, 6, 5, 7};  // bit 0 red, bit 1 green, bit 2 blue
    const int hue = hues[(value - 1) % 7];
    const int light = 255 - std::min(192, (value - 1) / 7 * 48);
    const auto channel = [&](int bit) {
        return static_cast<std::uint16_t>(hue >> bit & 1 ? light : 0);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace

Picture plane_picture(const Planes& planes, Plane plane, const Profile& profile) {
    const int w = planes.width, h = planes.height;
    switch (plane) {
        case Plane::Color: return picture_of(planes.color, w, h, profile.color_bits);
        case Plane::Depth: return depth_colors(planes.depth, w, h, profile.depth_bits);
        case Plane::Stencil: return stencil_colors(planes.stencil, w, h);
        case Plane::Accum: return accum_colors(planes.accum, w, h);
        case Plane::Back: return picture_of(planes.back, w, h, profile.color_bits);
    }
    return {};
}

Picture amount_picture(const std::vector<std::uint32_t>& amounts, int width, int height) {
    const std::uint64_t most =
        std::max<std::uint32_t>(1, *std::max_element(amounts.begin(), amounts.end()));
    return painted(amounts, width, height, [&](std::uint32_t n) {
        const auto v = static_cast<std::uint16_t>((n * std::uint64_t{255} + most / 2) / most);
        return Color{v, v, v};
    });
}

Picture distance_picture(const std::vector<std::uint64_t>& distances, int width, int height) {
    const double greatest =
        distances.empty() ? 0 : double(*std::max_element(distances.begin(), distances.end()));
    Picture picture{width, height, 1, 16, {}};
    for (const std::uint64_t distance : distances)
        picture.values.push_back(
            distance == 0
                ? 0
                : static_cast<std::uint16_t>(16384.0 + 49151.0 * double(distance) / greatest));
    return picture;
}

Change change_picture(const Picture& before, const Picture& after) {
    Change change{after, 1};
    int greatest = 1;
    for (std::size_t i = 0; i < after.values.size(); ++i) {
        const int apart = std::abs(int(after.values[i]) - int(before.values[i]));
        change.picture.values[i] = static_cast<std::uint16_t>(apart);
        greatest = std::max(greatest, apart);
    }
    change.times = static_cast<int>(max_of_bits(after.bits)) / greatest;
    for (std::uint16_t& value : change.picture.values)
        value = static_cast<std::uint16_t>(value * change.times);
    return change;
}

Picture depth_colors(const std::vector<std::uint32_t>& depth, int width, int height, int bits) {
    const std::uint32_t nothing = max_of_bits(bits);
    std::uint32_t nearest = nothing, farthest = 0;
    for (std::uint32_t z : depth) {
        if (z == nothing) continue;
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    const double range = farthest > nearest ? static_cast<double>(farthest - nearest) : 1;
    return painted(depth, width, height, [&](std::uint32_t z) {
        return z == nothing ? Color{0, 0, 0} : ramp((z - nearest) / range);
    });
}

Picture part_colors(const std::vector<double>& parts, int width, int height) {
    return painted(parts, width, height, [](double part) {
        return part > 0 ? ramp(1 - std::min(part, 1.0)) : Color{0, 0, 0};
    });
}

Picture stencil_colors(const std::vector<std::uint8_t>& stencil, int width, int height) {
    return painted(stencil, width, height, stencil_color);
}

Picture id_colors(const std::vector<std::uint32_t>& ids, int width, int height,
                  std::uint32_t none) {
    return painted(ids, width, height, [&](std::uint32_t id) {
        return id == none ? Color{0, 0, 0} : id_color(id);
    });
}

Picture accum_colors(const std::vector<std::array<std::int32_t, 4>>& accum, int width, int height) {
    double largest = 1;
    for (const auto& sum : accum) {
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(static_cast<double>(sum[c])));
    }
    return painted(accum, width, height, [&](const std::array<std::int32_t, 4>& sum) {
        Color color{};
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = static_cast<std::uint16_t>(clamp01(sum[c] / largest) * 255 + 0.5);
        }
        return color;
    });
}

}  // namespace gw::image
