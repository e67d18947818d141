#include "inspect/report/prices.h"

#include "gw/error.h"
#include "inspect/report/embedded.h"
#include "scene/toml/toml_binder.h"
#include "scene/toml/toml_value.h"

#include <algorithm>

namespace gw::report {
namespace {

using raytrace::RayCounts;
using scene::key;
using scene::TomlValue;

constexpr const char* processor = "processor";
constexpr scene::Range nanosecond_range{1e-6, 1e12}, second_range{1e-9, 1e12}, count_range{0, 1e15};

const std::vector<std::string>& count_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const PricedCount& count : priced_counts()) all.push_back(count.name);
        return all;
    }();
    return names;
}

/// Absent limits are the value itself.
void set_limits(const TomlValue& table, double value, double& low, double& high) {
    if (low == 0) low = value;
    if (high == 0) high = value;
    if (!(low <= value && value <= high))
        table.fail("limits that do not enclose the value; expected low <= value <= high");
}

Price price_from(const TomlValue& table) {
    static const std::vector<std::string> stages{"geometry", "pixels", processor};
    Price price;
    const auto count = [&](const TomlValue& v) {
        price.count = priced_counts()[scene::to_word(v, count_names())];
    };
    const auto stage = [&](const TomlValue& v) { price.stage = stages[scene::to_word(v, stages)]; };
    scene::read_table(table, {{"count", count},
                              {"stage", stage},
                              key("nanoseconds", price.nanoseconds, nanosecond_range),
                              key("low", price.low, nanosecond_range),
                              key("high", price.high, nanosecond_range),
                              key("estimate", price.estimate),
                              key("source", price.source)});
    for (const char* name : {"count", "stage", "nanoseconds", "source"})
        if (!table.find(name))
            table.fail(std::string("a price without '") + name + "'; expected one");
    if ((price.stage == processor) != (price.count.counter == nullptr))
        table.fail("the price of '" + price.count.name + "' in stage '" + price.stage +
                   "'; expected processor for rays, boxes, triangles and shaded, and geometry or "
                   "pixels for others");
    set_limits(table, price.nanoseconds, price.low, price.high);
    return price;
}

void add_prices(const TomlValue& value, PriceList& list) {
    if (value.kind != scene::TomlKind::Array) value.fail_expected("tables [[price]]");
    for (const TomlValue& table : value.elements) {
        Price price = price_from(table);
        const auto same = [&](const Price& p) { return p.count.name == price.count.name; };
        if (std::ranges::any_of(list.prices, same))
            table.fail("a second price of '" + price.count.name + "'; expected one");
        list.prices.push_back(std::move(price));
    }
}

Calibration calibration_from(const TomlValue& table) {
    Calibration c;
    double rays = 0, boxes = 0, triangles = 0, shaded = 0;
    scene::read_table(table,
                      {key("seconds", c.seconds, second_range), key("low", c.low, second_range),
                       key("high", c.high, second_range), key("rays", rays, count_range),
                       key("boxes", boxes, count_range), key("triangles", triangles, count_range),
                       key("shaded", shaded, count_range), key("source", c.source)});
    for (const char* name : {"seconds", "rays", "source"})
        if (!table.find(name))
            table.fail(std::string("a calibration without '") + name + "'; expected one");
    set_limits(table, c.seconds, c.low, c.high);
    c.rays = {.primary = std::uint64_t(rays),
              .shaded = std::uint64_t(shaded),
              .tests = {std::uint64_t(boxes), std::uint64_t(triangles)}};
    return c;
}

double nanoseconds(const RayCounts& rays, const PriceList& list) {
    double sum = 0;
    for (const Price& price : list.prices)
        if (price.count.of_rays) sum += double(price.count.of_rays(rays)) * price.nanoseconds;
    return sum;
}

PriceList prices_from(const TomlValue& toml, const std::string& name) {
    PriceList list{.name = name};
    scene::read_table(toml, {key("machine", list.machine),
                             {"price", [&](const TomlValue& value) { add_prices(value, list); }},
                             {"calibration", [&](const TomlValue& value) {
                                  list.calibration = calibration_from(value);
                              }}});
    if (list.machine.empty()) toml.fail("no machine; expected machine = \"...\"");
    if (list.prices.empty()) toml.fail("no prices; expected [[price]]");
    if (list.calibration && !(nanoseconds(list.calibration->rays, list) > 0))
        toml.fail("a calibration whose counts have no price; expected prices of the processor");
    return list;
}

template <class Estimate>
Interval interval(const PriceList& list, const Estimate& estimate) {
    const double value = estimate(list);
    Interval found{value, value, value};
    for (const PriceList& prices : extremes(list)) {
        const double at_limits = estimate(prices);
        found.low = std::min(found.low, at_limits);
        found.high = std::max(found.high, at_limits);
    }
    return found;
}

PriceList built_in(const std::string& name) {
    const std::string file = name + ".toml";
    return prices_from(scene::read_toml_text(std::string(embedded(file)), file), name);
}

}  // namespace

const std::vector<PricedCount>& priced_counts() {
    static const std::vector<PricedCount> all = [] {
        std::vector<PricedCount> counts;
        for (const CounterName& counter : counter_names())
            counts.push_back({counter.name, counter.count, nullptr});
        counts.push_back({"rays", nullptr, [](const RayCounts& c) {
                              return c.primary + c.reflected + c.transmitted + c.shadow;
                          }});
        counts.push_back({"boxes", nullptr, [](const RayCounts& c) { return c.tests.boxes; }});
        counts.push_back(
            {"triangles", nullptr, [](const RayCounts& c) { return c.tests.triangles; }});
        counts.push_back({"shaded", nullptr, [](const RayCounts& c) { return c.shaded; }});
        return counts;
    }();
    return all;
}

PriceList read_prices(const std::filesystem::path& file) {
    return prices_from(scene::read_toml_file(file), file.stem().string());
}

PriceList vgx_prices() { return built_in_prices().front(); }

const std::vector<PriceList>& built_in_prices() {
    static const std::vector<PriceList> lists{built_in("vgx"), built_in("modern_gpu"),
                                              built_in("modern_cpu")};
    return lists;
}

double estimated_seconds(const Counters& counters, const PriceList& list) {
    double geometry = 0, pixels = 0;
    for (const Price& price : list.prices)
        if (price.count.counter)
            (price.stage == "geometry" ? geometry : pixels) +=
                double(counters.*price.count.counter) * price.nanoseconds;
    return std::max(geometry, pixels) / 1e9;
}

double traced_seconds(const RayCounts& rays, const PriceList& list) {
    const double sum = nanoseconds(rays, list);
    if (!list.calibration) return sum / 1e9;
    return list.calibration->seconds * (sum / nanoseconds(list.calibration->rays, list));
}

double picture_seconds(std::span<const Counters> passes, const RayCounts& rays,
                       const PriceList& list) {
    double sum = traced_seconds(rays, list);
    for (const Counters& pass : passes) sum += estimated_seconds(pass, list);
    return sum;
}

Interval seconds_interval(const PictureWork& work, const PriceList& list) {
    return interval(list, [&](const PriceList& prices) {
        return picture_seconds(work.passes, work.rays, prices);
    });
}

Interval ratio_interval(const PictureWork& work, const PictureWork& other, const PriceList& list) {
    return interval(list, [&](const PriceList& prices) {
        const double seconds = picture_seconds(other.passes, other.rays, prices);
        return seconds > 0 ? picture_seconds(work.passes, work.rays, prices) / seconds : 0;
    });
}

std::vector<PriceList> extremes(const PriceList& list) {
    std::vector<PriceList> all{list};
    const auto split = [&](auto place) {
        const std::size_t count = all.size();
        if (count > 1u << 15)
            throw Error(list.machine + ": more than 16 prices with limits; expected fewer");
        for (std::size_t i = 0; i < count; ++i) {
            PriceList higher = all[i];
            auto [value, low, high] = place(all[i]);
            *value = low;
            auto [other, other_low, other_high] = place(higher);
            *other = other_high;
            all.push_back(std::move(higher));
        }
    };
    struct Place {
        double* value;
        double low, high;
    };
    for (std::size_t k = 0; k < list.prices.size(); ++k)
        if (list.prices[k].low < list.prices[k].high)
            split([k](PriceList& l) {
                Price& p = l.prices[k];
                return Place{&p.nanoseconds, p.low, p.high};
            });
    if (list.calibration && list.calibration->low < list.calibration->high)
        split([](PriceList& l) {
            Calibration& c = *l.calibration;
            return Place{&c.seconds, c.low, c.high};
        });
    return all;
}

}  // namespace gw::report
