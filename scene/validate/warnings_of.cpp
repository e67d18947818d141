#include "scene/validate/warnings_of.h"

#include "gw/base/arithmetic.h"
#include "scene/draw/nearest.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/validate/coincident.h"
#include "scene/validate/shadow_maps.h"

#include <algorithm>

namespace gw::scene {
namespace {

std::string name_in_quotes(const Scene& scene, std::size_t object) {
    return "'" + printable(scene.objects[object].name) + "'";
}

std::string lines_and_points(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].mesh->kind() != MeshKind::Triangles)
            return "lines and points are left out, as of object " + name_in_quotes(scene, i) +
                   "; expected renderer multipass or hardware for them";
    return {};
}

std::string coincident(const Scene& scene) {
    const auto pair = coincident_objects(scene);
    if (!pair) return {};
    return "objects " + name_in_quotes(scene, pair->first) + " and " +
           name_in_quotes(scene, pair->second) +
           " share a part of a plane: which of them is seen there depends on rounding; expected "
           "them a little apart";
}

std::string opaque_in_radiosity(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (const float d = scene.materials[scene.objects[i].material].d; d < 1)
            return "object " + name_in_quotes(scene, i) + " has opacity " + number_text(double(d)) +
                   "; radiosity takes it as opaque: expected d 1";
    return {};
}

std::string without_maps(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material& m = scene.materials[scene.objects[i].material];
        if (!m.map_Kd.empty())
            return "object " + name_in_quotes(scene, i) + " has a map of Kd, " +
                   printable(m.map_Kd[0].file.filename().string()) +
                   "; radiosity reflects the mean of its texels everywhere: expected no map";
    }
    return {};
}

}  // namespace

std::vector<std::string> warnings_of(const Scene& scene, const View& view, DrawnBy by) {
    std::vector<std::string> lines;
    const auto add = [&](std::string line) {
        if (!line.empty()) lines.push_back(std::move(line));
    };
    if (by != DrawnBy::Rays) add(near_warning(scene, view));
    if (by != DrawnBy::Passes) add(lines_and_points(scene));
    if (by == DrawnBy::Passes) add(cut_by_shadow_map(scene));
    add(coincident(scene));
    return lines;
}

std::vector<std::string> left_out_by_radiosity(const Scene& scene) {
    std::vector<std::string> lines{opaque_in_radiosity(scene), without_maps(scene)};
    std::erase(lines, "");
    return lines;
}

std::string empty_picture(const Scene& scene, std::span<const Rgba> picture, int color_bits) {
    if (scene.objects.empty() || picture.empty()) return {};
    for (const Rgba& pixel : picture)
        for (int k = 0; k < 3; ++k)
            if (pixel[std::size_t(k)] != quantize(double(scene.background[k]), color_bits))
                return {};
    return "the picture is empty: no pixel differs from the background; expected the scene before "
           "the eye, lit, and not of opacity 0";
}

}  // namespace gw::scene
