#include "inspect/report/prices.h"

#include "inspect/report/embedded.h"
#include "scene/toml/toml_binder.h"
#include "scene/toml/toml_value.h"

#include <algorithm>
#include <map>

namespace gw::report {
namespace {

using scene::key;
using scene::TomlValue;

std::size_t counter_from(const TomlValue& value) {
    std::vector<std::string> names;
    for (const CounterName& counter : counter_names()) names.push_back(counter.name);
    return scene::to_word(value, names);
}

Price price_from(const TomlValue& table) {
    static const std::vector<std::string> stages{"geometry", "pixels"};
    Price price;
    const auto counter = [&](const TomlValue& v) {
        price.counter = counter_names()[counter_from(v)];
    };
    const auto stage = [&](const TomlValue& v) { price.stage = stages[scene::to_word(v, stages)]; };
    scene::read_table(table, {{"count", counter},
                              {"stage", stage},
                              key("nanoseconds", price.nanoseconds, scene::Range{1e-6, 1e12}),
                              key("estimate", price.estimate),
                              key("source", price.source)});
    for (const char* name : {"count", "stage", "nanoseconds", "source"})
        if (!table.find(name))
            table.fail(std::string("a price without '") + name + "'; expected one");
    return price;
}

void add_prices(const TomlValue& value, PriceList& list) {
    if (value.kind != scene::TomlKind::Array) value.fail_expected("tables [[price]]");
    for (const TomlValue& table : value.elements) {
        Price price = price_from(table);
        const auto same = [&](const Price& p) { return p.counter.count == price.counter.count; };
        if (std::ranges::any_of(list.prices, same))
            table.fail(std::string("a second price of '") + price.counter.name + "'; expected one");
        list.prices.push_back(std::move(price));
    }
}

PriceList prices_from(const TomlValue& toml) {
    PriceList list;
    scene::read_table(toml, {key("machine", list.machine),
                             {"price", [&](const TomlValue& value) { add_prices(value, list); }}});
    if (list.machine.empty()) toml.fail("no machine; expected machine = \"...\"");
    if (list.prices.empty()) toml.fail("no prices; expected [[price]]");
    return list;
}

}  // namespace

PriceList read_prices(const std::filesystem::path& file) {
    return prices_from(scene::read_toml_file(file));
}

PriceList vgx_prices() {
    return prices_from(scene::read_toml_text(std::string(embedded("vgx.toml")), "vgx.toml"));
}

double estimated_seconds(const Counters& counters, const PriceList& list) {
    std::map<std::string, double> stages;
    for (const Price& price : list.prices)
        stages[price.stage] += double(counters.*price.counter.count) * price.nanoseconds;
    double slowest = 0;
    for (const auto& [stage, nanoseconds] : stages) slowest = std::max(slowest, nanoseconds);
    return slowest / 1e9;
}

}  // namespace gw::report
