#include "apps/hidden/comparison.h"

#include "apps/hidden/pictures.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

/// `values`: bottom row first.
template <class Value>
Json runs_of(const std::vector<Value>& values, const scene::View& view) {
    Json runs = Json::array();
    std::uint32_t last = 0;
    std::size_t count = 0;
    const auto close = [&] {
        if (count == 0) return;
        runs.push_back(count);
        runs.push_back(last);
    };
    for (int y = view.height; y-- > 0;)
        for (int x = 0; x < view.width; ++x) {
            const auto value = std::uint32_t(values[pixel_index(x, y, view.width)]);
            if (value != last) {
                close();
                count = 0;
            }
            last = value;
            ++count;
        }
    close();
    return runs;
}

Json run_json(const Compared& run, const scene::View& view) {
    Json counts = Json::object();
    for (const auto& [name, count] : hs::count_names()) counts[name] = run.result.counts.*count;
    return {{"name", run.algorithm->name},
            {"title", run.algorithm->title},
            {"counts", counts},
            {"ids", runs_of(run.result.ids, view)},
            {"difference", runs_of(run.result.difference, view)},
            {"writes", runs_of(run.result.writes, view)}};
}

}  // namespace

std::string comparison_json(const hs::Input& input, const std::vector<Compared>& all,
                            const std::map<std::uint32_t, Color>& colors) {
    Json polygons = Json::array(), runs = Json::array();
    for (const hs::Polygon& polygon : input.polygons)
        polygons.push_back({{"id", polygon.id},
                            {"part", input.scene.objects[polygon.object].name},
                            {"color", hex_of(colors.at(polygon.id))}});
    for (const Compared& run : all) runs.push_back(run_json(run, input.view));
    const Json json{{"data", "gw hidden comparison"},
                    {"version", 1},
                    {"scene", input.scene.name},
                    {"size", {input.view.width, input.view.height}},
                    {"background", hex_of(colors.at(0))},
                    {"polygons", polygons},
                    {"complexity", runs_of(hs::depth_complexity(input), input.view)},
                    {"algorithms", runs}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gw::apps
