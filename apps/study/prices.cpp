#include "apps/study/prices.h"

#include "gw/base/elementary.h"
#include "scene/toml/toml_binder.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::study {
namespace {

using scene::key;
using scene::Key;
using scene::TomlValue;

const std::vector<std::string> operations{"add", "compare", "multiply", "divide", "load", "store"};
constexpr double seconds_a_month = 30.0 * 24 * 3600, megabyte = 1048576;

/// A key that is an array of tables.
Key tables_key(const std::string& name, const std::function<void(const TomlValue&)>& read) {
    return {name, [read](const TomlValue& value) {
                if (value.kind != scene::TomlKind::Array)
                    value.fail_expected("tables [[" + value.key + "]]");
                for (const TomlValue& table : value.elements) read(table);
            }};
}

void read_price(const TomlValue& table, PriceList& list) {
    Price price;
    std::size_t what = 0;
    std::vector<std::string> names = operations;
    names.insert(names.end(), {"machine", "memory"});
    const TomlValue* named = table.find("what");
    if (!named) table.fail("a price without 'what'; expected what = \"add\" or another operation");
    scene::read_table(
        table, {{"what", [&](const TomlValue& value) { what = scene::to_word(value, names); }},
                key("value", price.value, scene::Range{1e-12, 1e12}),
                key("estimate", price.estimate),
                key("source", price.source)});
    if (price.value == 0)
        table.fail("the price of '" + names[what] + "' has no value; expected value = a number");
    if (price.source.empty())
        table.fail("the price of '" + names[what] + "' has no source; expected source = \"...\"");
    if (!list.prices.emplace(names[what], price).second)
        table.fail("a second price of '" + names[what] + "'; expected one");
}

std::vector<std::string> counter_names() {
    std::vector<std::string> names = growth_values(false);
    for (const std::string& name : growth_values(true)) names.push_back("lines." + name);
    return names;
}

void read_recipe(const TomlValue& table, Recipes& recipes) {
    static const std::vector<std::string> counters = counter_names();
    std::size_t counter = 0;
    std::string why;
    std::map<std::string, double> recipe;
    if (!table.find("count"))
        table.fail("a recipe without 'count'; expected count = \"depths\" or another counter");
    std::vector<Key> keys{
        {"count", [&](const TomlValue& value) { counter = scene::to_word(value, counters); }},
        key("why", why)};
    for (const std::string& name : operations)
        keys.push_back(key(name, recipe[name], scene::Range{0, 1e6}));
    scene::read_table(table, keys);
    if (!recipes.emplace(counters[counter], recipe).second)
        table.fail("a second recipe for '" + counters[counter] + "'; expected one");
}

/// The x at which two power laws between x0 and x1 meet.
double meeting(double x0, double x1, dvec2 costs_a, dvec2 costs_b) {
    const double before = gw::log(costs_a.x / costs_b.x), after = gw::log(costs_a.y / costs_b.y);
    const double t = before == after ? 0.5 : std::clamp(before / (before - after), 0.0, 1.0);
    return x0 * gw::pow(x1 / x0, t);
}

const Cost* cost_in(const Ranking& ranking, const std::string& name) {
    for (const auto& [algorithm, cost] : ranking.algorithms)
        if (algorithm == name) return &cost;
    return nullptr;
}

}  // namespace

PriceList read_prices(const std::filesystem::path& file) {
    const TomlValue toml = scene::read_toml_file(file);
    PriceList list;
    scene::read_table(
        toml, {key("name", list.name), key("machine", list.machine),
               tables_key("price", [&](const TomlValue& table) { read_price(table, list); })});
    if (list.name.empty()) toml.fail("no name; expected name = \"...\"");
    std::vector<std::string> names = operations;
    names.insert(names.end(), {"machine", "memory"});
    for (const std::string& name : names)
        if (list.prices.count(name) == 0)
            toml.fail("no price of '" + name + "'; expected a [[price]] of it");
    return list;
}

Recipes read_recipes(const std::filesystem::path& file) {
    Recipes recipes;
    const TomlValue toml = scene::read_toml_file(file);
    scene::read_table(
        toml, {tables_key("recipe", [&](const TomlValue& table) { read_recipe(table, recipes); })});
    if (recipes.empty()) toml.fail("no recipe; expected [[recipe]]");
    return recipes;
}

Cost cost_of(const GrowthPoint& point, const PriceList& list, const Recipes& recipes) {
    double microseconds = 0;
    for (const auto& [name, count] : point.values) {
        const auto recipe = recipes.find((point.lines ? "lines." : "") + name);
        if (recipe == recipes.end()) continue;
        for (const auto& [operation, times] : recipe->second)
            microseconds += count * times * list.prices.at(operation).value;
    }
    const double seconds = microseconds / 1e6;
    const double rent = list.prices.at("machine").value +
                        list.prices.at("memory").value * point.values.at("peak_bytes") / megabyte;
    return {seconds, seconds * rent / seconds_a_month};
}

std::vector<Ranking> rankings(const Growth& growth, const std::string& axis, bool lines,
                              const PriceList& list, const Recipes& recipes) {
    const std::vector<std::string> right = right_algorithms();
    std::vector<Ranking> all;
    for (const GrowthPoint& p : growth.points) {
        if (p.axis != axis || p.lines != lines) continue;
        if (!lines && std::find(right.begin(), right.end(), p.algorithm) == right.end()) continue;
        if (all.empty() || all.back().x != p.x) all.push_back({p.x, {}});
        all.back().algorithms.emplace_back(p.algorithm, cost_of(p, list, recipes));
    }
    for (Ranking& ranking : all)
        std::stable_sort(
            ranking.algorithms.begin(), ranking.algorithms.end(),
            [](const auto& a, const auto& b) { return a.second.dollars < b.second.dollars; });
    return all;
}

std::vector<Flip> flips(const std::vector<Ranking>& rankings, std::size_t places) {
    std::vector<Flip> found;
    for (std::size_t i = 0; i + 1 < rankings.size(); ++i) {
        const Ranking &from = rankings[i], &to = rankings[i + 1];
        const auto in_front = [&](const Ranking& r, const std::string& name) {
            const auto end =
                r.algorithms.begin() + std::ptrdiff_t(std::min(places, r.algorithms.size()));
            return std::any_of(r.algorithms.begin(), end,
                               [&](const auto& a) { return a.first == name; });
        };
        for (std::size_t a = 0; a < from.algorithms.size(); ++a)
            for (std::size_t b = a + 1; b < from.algorithms.size(); ++b) {
                const auto& [name_a, cost_a] = from.algorithms[a];
                const auto& [name_b, cost_b] = from.algorithms[b];
                const Cost *later_a = cost_in(to, name_a), *later_b = cost_in(to, name_b);
                if (!later_a || !later_b || later_b->dollars >= later_a->dollars ||
                    cost_a.dollars <= 0)
                    continue;
                if ((in_front(from, name_a) && in_front(from, name_b)) ||
                    (in_front(to, name_a) && in_front(to, name_b)))
                    found.push_back({name_a, name_b,
                                     meeting(from.x, to.x, {cost_a.dollars, later_a->dollars},
                                             {cost_b.dollars, later_b->dollars})});
            }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Flip& a, const Flip& b) { return a.x < b.x; });
    return found;
}

plot::Plot cost_plot(const std::vector<Ranking>& rankings, const GrowthAxis& axis,
                     const PriceList& list, bool lines) {
    plot::Plot plot{
        .title = fmt::format("{}cost of a picture against {}, prices of {}", lines ? "Lines: " : "",
                             axis.name, list.name),
        .caption = list.machine +
                   ". Estimated: counters times operations times prices; machine and memory "
                   "rented for the time of a picture.",
        .command = "",
        .x = {axis.label, axis.log},
        .y = {"dollars", 10},
        .series = {}};
    for (const Ranking& ranking : rankings)
        for (const auto& algorithm : ranking.algorithms) {
            const std::string& name = algorithm.first;
            const Cost& cost = algorithm.second;
            auto series = std::find_if(plot.series.begin(), plot.series.end(),
                                       [&](const plot::Series& s) { return s.name == name; });
            if (series == plot.series.end()) {
                plot.series.push_back({.name = name, .points = {}});
                series = plot.series.end() - 1;
            }
            if (cost.dollars > 0) series->points.push_back({ranking.x, cost.dollars});
        }
    std::sort(plot.series.begin(), plot.series.end(),
              [](const plot::Series& a, const plot::Series& b) { return a.name < b.name; });
    return plot;
}

}  // namespace gw::study
