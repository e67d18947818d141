#include "inspect/manifest/json_of.h"

#include "gw/names.h"

#include <nlohmann/json.hpp>

#include <map>

namespace gw::inspect {

static nlohmann::ordered_json json_of(const Extensions& extensions) {
    auto json = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < extension_names().size(); ++i) {
        const auto& [name, member] = extension_names()[i];
        if (i < always_named_extensions || extensions.*member) json[name] = extensions.*member;
    }
    return json;
}

nlohmann::ordered_json json_of(const Profile& p) {
    nlohmann::ordered_json json{
        {"name", p.name},
        {"color_bits", p.color_bits},
        {"depth_bits", p.depth_bits},
        {"stencil_bits", p.stencil_bits},
        {"accum_bits", p.accum_bits},
        {"subpixel_bits", p.subpixel_bits},
        {"lit_bits", p.lit_bits},
        {"max_lights", p.max_lights},
        {"fragment_fog", p.fragment_fog},
        {"perspective_color", p.perspective_color},
        {"extensions", json_of(p.extensions)},
    };
    if (p.texel_bits != 0) json["texel_bits"] = p.texel_bits;
    if (p.coverage_bits != 0) json["coverage_bits"] = p.coverage_bits;
    if (p.color_planes != 1) json["color_planes"] = p.color_planes;
    return json;
}

nlohmann::ordered_json json_of(const Counters& counters) {
    auto json = nlohmann::ordered_json::object();
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
    for (const Total& total : totals)
        by_name.push_back(
            {{"name", total.name}, {"runs", total.runs}, {"counters", json_of(total.counters)}});
    return {{"passes", passes.size()}, {"by_name", by_name}, {"sum", json_of(sum)}};
}

}  // namespace gw::inspect
