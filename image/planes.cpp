#include "image/planes.h"

#include "gw/base/arithmetic.h"
#include "image/write.h"

#include <algorithm>

namespace gw::image {
namespace {

std::vector<std::uint32_t> widened(const std::vector<std::uint8_t>& values) {
    return {values.begin(), values.end()};
}

std::vector<float> as_floats(const std::vector<std::array<std::int32_t, 4>>& accum) {
    std::vector<float> floats;
    floats.reserve(accum.size() * 4);
    for (const auto& sum : accum) {
        for (std::int32_t v : sum) floats.push_back(static_cast<float>(v));
    }
    return floats;
}

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

Picture distance_picture(const std::vector<std::uint64_t>& distances, int width, int height) {
    const double greatest = distances.empty() ? 0 : double(*std::ranges::max_element(distances));
    Picture picture{width, height, 1, 16, {}};
    for (const std::uint64_t distance : distances)
        picture.values.push_back(
            distance == 0
                ? 0
                : static_cast<std::uint16_t>(16384.0 + 49151.0 * double(distance) / greatest));
    return picture;
}

void put_planes(OutputSet& files, const std::filesystem::path& folder, const Planes& planes,
                const Profile& profile) {
    const int w = planes.width, h = planes.height;
    const auto put = [&](const char* name, Plane plane) {
        put_picture(files.add(folder / name), plane_picture(planes, plane, profile));
    };
    put("color.exr", Plane::Color);
    put("color.png", Plane::Color);
    put_values(files.add(folder / "depth.exr"), {w, h, {"Z"}, planes.depth});
    put("depth.png", Plane::Depth);
    put_values(files.add(folder / "stencil.exr"), {w, h, {"S"}, widened(planes.stencil)});
    put("stencil.png", Plane::Stencil);
    put_values(files.add(folder / "accum.exr"),
               {w, h, {"R", "G", "B", "A"}, as_floats(planes.accum)});
    put("accum.png", Plane::Accum);
}

void put_ids(OutputSet& files, const std::filesystem::path& folder,
             const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none) {
    put_values(files.add(folder / "ids.exr"), {width, height, {"id"}, ids});
    put_picture(files.add(folder / "ids.png"), id_colors(ids, width, height, none));
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
