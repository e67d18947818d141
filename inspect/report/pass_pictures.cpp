#include "inspect/report/pass_pictures.h"

#include "image/picture.h"
#include "image/plane_pictures.h"
#include "inspect/replay/plane_values.h"
#include "scene/draw/draw_commands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace gw::report {

/// A plane of the machine, or one of the two that are made of identifiers.
struct PassPictures::Shown {
    const char* name;
    std::optional<Plane> plane;
    std::vector<std::uint32_t> (*ids)(const Snapshot&) = nullptr;
};

namespace {

constexpr int small_side = 240;

std::vector<std::uint32_t> polygons_of(const Snapshot& s) { return s.polygons; }

std::vector<std::uint32_t> colors_as_ids(const Snapshot& s) {
    std::vector<std::uint32_t> ids;
    for (const Rgba& color : s.planes.color) ids.push_back(scene::id_of(color));
    return ids;
}

constexpr PassPictures::Shown usual_planes[] = {
    {"color", Plane::Color}, {"depth", Plane::Depth}, {"stencil", Plane::Stencil},
    {"back", Plane::Back},   {"accum", Plane::Accum}, {"polygons", {}, polygons_of}};
constexpr PassPictures::Shown shown_identifiers{"identifiers", {}, colors_as_ids};

bool is_of_colors(const PassPictures::Shown& shown) {
    return shown.plane == Plane::Color || shown.plane == Plane::Back;
}

/// As a screen shows it.
image::Picture mapped_picture(const std::vector<Rgba>& colors, const Snapshot& s) {
    return image::picture_of(inspect::through_map(colors, *s.map), s.planes.width, s.planes.height,
                             8);
}

image::Picture picture_of(const PassPictures::Shown& shown, const Snapshot& s,
                          const Profile& profile) {
    if (s.map != nullptr && is_of_colors(shown))
        return mapped_picture(shown.plane == Plane::Back ? s.planes.back : s.planes.color, s);
    if (shown.plane) return image::plane_picture(s.planes, *shown.plane, profile);
    return image::id_colors(shown.ids(s), s.planes.width, s.planes.height, 0);
}

bool same_map(const inspect::ColorMap* a, const inspect::ColorMap* b) {
    return a == b || (a != nullptr && b != nullptr && *a == *b);
}

/// Of pictures: the sums of their channels' distances, bottom row first.
std::vector<std::uint64_t> distances(const image::Picture& before, const image::Picture& after) {
    std::vector<std::uint64_t> apart(after.values.size() / std::size_t(after.channels));
    for (std::size_t i = 0; i < after.values.size(); ++i)
        apart[i / std::size_t(after.channels)] +=
            std::uint64_t(std::abs(int(after.values[i]) - int(before.values[i])));
    return apart;
}

/// Of values; of colours through another map, as they are shown.
std::vector<std::uint64_t> distances(const PassPictures::Shown& shown, const Snapshot& before,
                                     const Snapshot& after, const Profile& profile) {
    if (is_of_colors(shown) && !same_map(before.map, after.map))
        return distances(picture_of(shown, before, profile), picture_of(shown, after, profile));
    if (shown.plane) return inspect::distances(before.planes, after.planes, *shown.plane);
    const auto a = shown.ids(before), b = shown.ids(after);
    std::vector<std::uint64_t> apart;
    for (std::size_t i = 0; i < a.size(); ++i) apart.push_back(a[i] != b[i]);
    return apart;
}

}  // namespace

PassPictures::PassPictures(ReportFolder& folder, const Profile& profile, Snapshot start)
    : folder_(folder),
      profile_(profile),
      reduction_((std::max(start.planes.width, start.planes.height) + small_side - 1) / small_side),
      last_(std::move(start)) {}

std::string PassPictures::put(const std::string& name, const image::Picture& picture) {
    folder_.write("pictures/" + name + ".png", picture);
    if (with_small())
        folder_.write("pictures/" + name + "_small.png", image::downscaled(picture, reduction_));
    return name;
}

nlohmann::ordered_json PassPictures::plane_json(const Shown& shown, std::size_t pass,
                                                const Snapshot& after) {
    std::string& file = files_[shown.name];
    const std::string name = fmt::format("{:04}_{}", pass, shown.name);
    if (file.empty()) file = put(name + "_before", picture_of(shown, last_, profile_));
    nlohmann::ordered_json json{{"before", file}};
    const auto apart = distances(shown, last_, after, profile_);
    const auto changed = std::ranges::count_if(apart, [](std::uint64_t d) { return d != 0; });
    if (changed > 0) {
        const image::Picture picture = picture_of(shown, after, profile_);
        image::Change change{
            image::distance_picture(apart, after.planes.width, after.planes.height)};
        if (shown.plane == Plane::Color) {
            change = image::change_picture(picture_of(shown, last_, profile_), picture);
            json["times"] = change.times;
        }
        file = put(name, picture);
        json["change"] = put(name + "_change", change.picture);
        json["pixels"] = changed;
    }
    json["after"] = file;
    return json;
}

nlohmann::ordered_json PassPictures::add(std::size_t pass, Snapshot after, bool with_identifiers) {
    auto all = nlohmann::ordered_json::object();
    for (const Shown& shown : usual_planes)
        if (shown.plane != Plane::Back || profile_.color_planes == 2)
            all[shown.name] = plane_json(shown, pass, after);
    if (with_identifiers)
        all[shown_identifiers.name] = plane_json(shown_identifiers, pass, after);
    else
        files_.erase(shown_identifiers.name);
    last_ = std::move(after);
    return all;
}

}  // namespace gw::report
