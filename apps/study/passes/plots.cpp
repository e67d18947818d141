#include "apps/study/passes/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace gw::study {
namespace {

using render::StudyRow;

using Places = std::vector<std::size_t>;
using Value = std::function<double(std::size_t row)>;

plot::Series series(const PassStudy& study, const Places& places, std::string name,
                    const Value& value, std::size_t style, bool dashed = false) {
    plot::Series s{.name = std::move(name),
                   .points = {},
                   .markers = !dashed,
                   .dashed = dashed,
                   .style = style};
    std::set<double> seen;
    for (const std::size_t i : places)
        if (value(i) > 0 && study.rows[i].x > 0 && seen.insert(study.rows[i].x).second)
            s.points.push_back({study.rows[i].x, value(i)});
    std::ranges::sort(s.points, {}, &dvec2::x);
    return s;
}

plot::Plot empty_plot(const PassStudy& study, const render::Sweep& sweep, const std::string& title,
                      const std::string& label, int log) {
    const StudyRow& first = study.rows.front();
    return {.title = fmt::format("{}: {} by {}", study.scene, title, sweep.label),
            .caption = fmt::format("{}x{}, {} sample{} a pixel, {} lights, {} rays in a path, "
                                   "unless the axis says otherwise.",
                                   first.size.width, first.size.height, first.samples,
                                   first.samples == 1 ? "" : "s", first.lights, first.depth),
            .command = study.command,
            .x = {sweep.label, sweep.log},
            .y = {label, log},
            .series = {}};
}

void add(plot::Plot& plot, plot::Series s) {
    if (!s.points.empty()) plot.series.push_back(std::move(s));
}

plot::Plot counts_plot(const PassStudy& study, const render::Sweep& sweep, const Places& places) {
    plot::Plot p = empty_plot(study, sweep, "counts", "count", 10);
    const auto row = [&](std::size_t i) -> const StudyRow& { return study.rows[i]; };
    const auto rays = [](const raytrace::RayCounts& c) {
        return double(c.primary + c.reflected + c.transmitted + c.shadow);
    };
    add(p, series(
               study, places, "passes",
               [&](std::size_t i) { return double(row(i).cost("item-buffer").passes.size()); }, 0));
    add(p,
        series(
            study, places, "primitives of passes",
            [&](std::size_t i) { return double(row(i).cost("item-buffer").sum().primitives); }, 1));
    add(p,
        series(
            study, places, "fragments of passes",
            [&](std::size_t i) { return double(row(i).cost("item-buffer").sum().fragments); }, 2));
    add(p, series(
               study, places, "rays, item buffer",
               [&](std::size_t i) { return rays(row(i).cost("item-buffer").rays); }, 3));
    add(p, series(
               study, places, "rays, ordinary",
               [&](std::size_t i) { return rays(row(i).cost("ray-tracing").rays); }, 4));
    return p;
}

plot::Plot times_plot(const PassStudy& study, const render::Sweep& sweep, const Places& places) {
    plot::Plot p = empty_plot(study, sweep, "processor seconds", "seconds", 10);
    p.caption += fmt::format(" Medians of {} runs on this computer, in turn.", study.runs);
    for (std::size_t m = 0; m < render::methods().size(); ++m)
        add(p, series(
                   study, places, render::methods()[m].about,
                   [&](std::size_t i) { return study.rows[i].costs[m].median(); }, m));
    return p;
}

plot::Plot estimates_plot(const PassStudy& study, const render::Sweep& sweep,
                          const Places& places) {
    const report::PriceList& list = study.lists.front();
    plot::Plot p = empty_plot(study, sweep, "estimated seconds", "seconds", 10);
    p.caption += " Estimated: " + list.machine + ". Dashed: the limits of the prices.";
    const auto seconds = [&](std::size_t i, std::size_t m) -> const Interval& {
        return study.estimates[i].front().seconds[m];
    };
    for (std::size_t m = 0; m < render::methods().size(); ++m) {
        const std::string& name = render::methods()[m].name;
        add(p, series(
                   study, places, render::methods()[m].about,
                   [&](std::size_t i) { return seconds(i, m).value; }, m));
        if (name != "item-buffer" && name != "ray-tracing") continue;
        add(p, series(
                   study, places, name + ", least",
                   [&](std::size_t i) { return seconds(i, m).low; }, m, true));
        add(p, series(
                   study, places, name + ", most",
                   [&](std::size_t i) { return seconds(i, m).high; }, m, true));
    }
    return p;
}

constexpr double most_bound = 15;  ///< above it, the plot would show nothing else

double bound(const StudyRow& row) {
    return row.share() > 0 ? std::min(1 + 1 / row.share(), most_bound) : 0;
}

plot::Plot gain_plot(const PassStudy& study, const render::Sweep& sweep, const Places& places) {
    plot::Plot p =
        empty_plot(study, sweep, "ordinary ray tracing over item buffer", "times faster", 0);
    std::size_t style = 0;
    for (std::size_t l = 0; l < study.lists.size(); ++l, ++style)
        add(p, series(
                   study, places, "at prices of " + study.lists[l].name,
                   [&](std::size_t i) { return study.estimates[i][l].gain.value; }, style));
    add(p, series(
               study, places, study.lists[0].name + ", least",
               [&](std::size_t i) { return study.estimates[i][0].gain.low; }, 0, true));
    add(p, series(
               study, places, study.lists[0].name + ", most",
               [&](std::size_t i) { return study.estimates[i][0].gain.high; }, 0, true));
    add(p, series(
               study, places, "measured here",
               [&](std::size_t i) { return study.measured_gain(i); }, style++));
    const bool cut = std::ranges::any_of(
        places, [&](std::size_t i) { return bound(study.rows[i]) == most_bound; });
    add(p, series(
               study, places, cut ? fmt::format("1 + 1/g, cut at {}", most_bound) : "1 + 1/g",
               [&](std::size_t i) { return bound(study.rows[i]); }, style++, true));
    add(p, series(
               study, places, "the paper's 3", [](std::size_t) { return 3; }, style, true));
    add(p, series(
               study, places, "the paper's 5", [](std::size_t) { return 5; }, style, true));
    return p;
}

plot::Plot errors_plot(const PassStudy& study) {
    plot::Plot p{.title = study.scene + ": error by estimated time",
                 .caption =
                     "Root mean square against ordinary ray tracing with the most samples, "
                     "in 255ths of white. Estimated: " +
                     study.lists.front().machine + ".",
                 .command = study.command,
                 .x = {"estimated seconds", 10},
                 .y = {"error", 10},
                 .series = {}};
    for (std::size_t m = 0; m < render::methods().size(); ++m) {
        plot::Series s{.name = render::methods()[m].about, .points = {}, .style = m};
        for (const ErrorRow& e : errors(study)) {
            const double x = study.estimates[e.row].front().seconds[m].value;
            if (e.method == m && e.error > 0 && x > 0) s.points.push_back({x, e.error});
        }
        add(p, std::move(s));
    }
    return p;
}

/// The x at which a gain becomes 1, between neighbouring rows.
void add_crossings(const PassStudy& study, const Places& places, const std::string& label,
                   const std::string& where, const Value& gain, std::vector<std::string>& lines) {
    std::size_t found = 0;
    for (std::size_t k = 1; k < places.size(); ++k) {
        const double a = gain(places[k - 1]) - 1, b = gain(places[k]) - 1;
        const double x0 = study.rows[places[k - 1]].x, x1 = study.rows[places[k]].x;
        if ((a < 0) == (b < 0)) continue;
        ++found;
        lines.push_back(fmt::format("{}: the curves cross at about {:.3g} {}", where,
                                    x0 + (x1 - x0) * a / (a - b), label));
    }
    if (found == 0)
        lines.push_back(fmt::format("{}: the curves do not cross; the item buffer is {}", where,
                                    gain(places.front()) >= 1 ? "faster" : "slower"));
}

}  // namespace

std::vector<StudyPlot> plots(const PassStudy& study, const std::string& name) {
    const render::Sweep& sweep = render::sweep_named(name);
    const Places places = study.rows_of(name);
    std::vector<StudyPlot> all;
    if (places.size() < 2) return all;
    all.push_back({name + "_counts", counts_plot(study, sweep, places)});
    all.push_back({name + "_estimated", estimates_plot(study, sweep, places)});
    if (study.runs > 0) all.push_back({name + "_seconds", times_plot(study, sweep, places)});
    all.push_back({name + "_gain", gain_plot(study, sweep, places)});
    if (name == "samples") all.push_back({name + "_error", errors_plot(study)});
    std::erase_if(all, [](const StudyPlot& p) { return p.plot.series.empty(); });
    return all;
}

std::vector<std::string> crossings(const PassStudy& study, const std::string& name) {
    std::vector<std::string> lines;
    const Places places = study.rows_of(name);
    if (places.size() < 2) return lines;
    const std::string& label = render::sweep_named(name).label;
    for (std::size_t l = 0; l < study.lists.size(); ++l)
        add_crossings(
            study, places, label, "at prices of " + study.lists[l].name,
            [&](std::size_t i) { return study.estimates[i][l].gain.value; }, lines);
    if (study.runs > 0)
        add_crossings(
            study, places, label, "measured here",
            [&](std::size_t i) { return study.measured_gain(i); }, lines);
    return lines;
}

std::vector<std::vector<std::string>> table_of(const PassStudy& study, const std::string& name) {
    std::vector<std::vector<std::string>> lines{{render::sweep_named(name).label, "g %", "passes",
                                                 "fragments", "rays, item buffer", "ordinary",
                                                 "1 + 1/g"}};
    for (const report::PriceList& list : study.lists) lines[0].push_back("gain " + list.name);
    lines[0].insert(lines[0].end(), {"item buffer s", "ordinary s", "gain here"});
    const auto rays = [](const raytrace::RayCounts& c) {
        return c.primary + c.reflected + c.transmitted + c.shadow;
    };
    const auto timed = [&](const std::string& text) { return study.runs > 0 ? text : "-"; };
    for (const std::size_t i : study.rows_of(name)) {
        const StudyRow& row = study.rows[i];
        const render::Cost &item = row.cost("item-buffer"), &ordinary = row.cost("ray-tracing");
        std::vector<std::string> line{
            fmt::format("{:.6g}", row.x),
            fmt::format("{:.1f}", 100 * row.share()),
            std::to_string(item.passes.size()),
            std::to_string(item.sum().fragments),
            std::to_string(rays(item.rays)),
            std::to_string(rays(ordinary.rays)),
            row.share() > 0 ? fmt::format("{:.2f}", 1 + 1 / row.share()) : "-"};
        for (const RowEstimate& e : study.estimates[i])
            line.push_back(
                fmt::format("{:.2f} [{:.2f}, {:.2f}]", e.gain.value, e.gain.low, e.gain.high));
        line.push_back(timed(fmt::format("{:.4f}", item.median())));
        line.push_back(timed(fmt::format("{:.4f}", ordinary.median())));
        line.push_back(timed(fmt::format("{:.2f}", study.measured_gain(i))));
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace gw::study
