#include "inspect/manifest/json_of.h"

#include "gw/names.h"

#include <nlohmann/json.hpp>

#include <map>

namespace gw::inspect {

static nlohmann::ordered_json json_of(const Extensions& extensions) {
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < extension_names().size(); ++i) {
        const auto& [name, member] = extension_names()[i];
        if (i < always_named_extensions || extensions.*member) json[name] = extensions.*member;
    }
    return json;
}

// Members are assigned one by one: if memory is missing within a nested initializer list, code by g++
// 12 destroys elements that were not made yet.
nlohmann::ordered_json json_of(const Profile& p) {
    nlohmann::ordered_json json;
    json["name"] = p.name;
    json["color_bits"] = p.color_bits;
    json["depth_bits"] = p.depth_bits;
    json["stencil_bits"] = p.stencil_bits;
    json["accum_bits"] = p.accum_bits;
    json["subpixel_bits"] = p.subpixel_bits;
    json["lit_bits"] = p.lit_bits;
    json["max_lights"] = p.max_lights;
    json["fragment_fog"] = p.fragment_fog;
    json["perspective_color"] = p.perspective_color;
    json["extensions"] = json_of(p.extensions);
    if (p.texel_bits != 0) json["texel_bits"] = p.texel_bits;
    if (p.coverage_bits != 0) json["coverage_bits"] = p.coverage_bits;
    if (p.color_planes != 1) json["color_planes"] = p.color_planes;
    return json;
}

nlohmann::ordered_json json_of(const Counters& counters) {
    nlohmann::ordered_json json;
    for (const auto& [name, count] : counter_names()) json[name] = counters.*count;
    return json;
}

nlohmann::ordered_json totals_json(const std::vector<PassReport>& passes) {
    struct Total {
        std::string name;
        int runs = 0;
        Counters counters;
    };
    std::vector<Total> totals;
    std::map<std::string, std::size_t> places;
    Counters sum;
    for (const PassReport& pass : passes) {
        const auto [place, is_new] = places.try_emplace(pass.name, totals.size());
        if (is_new) totals.push_back({pass.name});
        Total& total = totals[place->second];
        ++total.runs;
        total.counters += pass.counters;
        sum += pass.counters;
    }
    auto by_name = nlohmann::ordered_json::array();
    for (const Total& total : totals) {
        nlohmann::ordered_json json;
        json["name"] = total.name;
        json["runs"] = total.runs;
        json["counters"] = json_of(total.counters);
        by_name.push_back(std::move(json));
    }
    nlohmann::ordered_json json;
    json["passes"] = passes.size();
    json["by_name"] = std::move(by_name);
    json["sum"] = json_of(sum);
    return json;
}

}  // namespace gw::inspect
