#include "scene/maps/map_lists.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gw::scene {
namespace {

/// The pictures that one file names in vain, and where it does so first.
struct Missing {
    Origin origin;
    std::string first;
    std::set<std::filesystem::path> files;
};

std::string text_of(const Missing& m) {
    const std::string what = m.first + ": no such file; expected a picture file, so it is left out";
    const std::size_t others = m.files.size() - 1;
    return others == 0 ? what : what + ", beside " + std::to_string(others) + " more";
}

}  // namespace

std::string map_words(const Map& map, std::string_view statement) {
    const std::string place = map.place.empty() ? std::string(statement) : map.place;
    return map.bytes ? place : place + " " + map.file.string();
}

void leave_out_missing(Scene& scene, Warnings& warnings) {
    std::vector<Missing> all;
    for (Material& material : scene.materials)
        for_each_map_list(material, [&](std::string_view statement, std::vector<Map>& maps) {
            std::erase_if(maps, [&](const Map& map) {
                if (map.texture || !map.may_lack) return false;
                const auto of_its_file = [&](const Missing& m) {
                    return m.origin.file == map.origin.file;
                };
                auto found = std::ranges::find_if(all, of_its_file);
                if (found == all.end())
                    found = all.insert(found, {map.origin, map_words(map, statement), {}});
                found->files.insert(map.file);
                return true;
            });
        });
    for (const Missing& m : all) warnings.add(m.origin.file, m.origin.line, "picture", text_of(m));
}

}  // namespace gw::scene
