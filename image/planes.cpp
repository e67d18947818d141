#include "image/planes.h"

#include "image/plane_pictures.h"
#include "image/write.h"

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

void put_planes(OutputSet& files, const std::filesystem::path& folder, const Planes& planes,
                const Profile& profile, const Picture* shown) {
    const int w = planes.width, h = planes.height;
    const auto put = [&](const char* name, Plane plane) {
        put_picture(files.add(folder / name), plane_picture(planes, plane, profile));
    };
    put("color.exr", Plane::Color);
    put_picture(files.add(folder / "color.png"),
                shown != nullptr ? *shown : plane_picture(planes, Plane::Color, profile));
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
