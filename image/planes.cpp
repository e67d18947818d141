#include "image/planes.h"

#include "image/false_color.h"
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

}  // namespace

Picture plane_picture(const Planes& planes, Plane plane, const Profile& profile) {
    const int w = planes.width, h = planes.height;
    switch (plane) {
        case Plane::Color: return picture_of(planes.color, w, h, profile.color_bits);
        case Plane::Depth: return depth_colors(planes.depth, w, h, profile.depth_bits);
        case Plane::Stencil: return stencil_colors(planes.stencil, w, h);
        case Plane::Accum: return accum_colors(planes.accum, w, h);
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

}  // namespace gw::image
