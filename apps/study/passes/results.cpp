#include "apps/study/passes/results.h"

#include "apps/command/command.h"
#include "gw/base/arithmetic.h"
#include "gw/machine.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace gw::study {
namespace {

using render::StudyRow;

std::size_t place_of(const std::string& method) {
    const auto& all = render::methods();
    return std::size_t(std::ranges::find(all, method, &render::Method::name) - all.begin());
}

/// The first processor's name; empty if the system does not say.
std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line))
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "";
}

std::string place(const StudyRow& row, const render::Cost& cost) {
    return fmt::format("{},{},{},{}", row.sweep, row.value, row.x, cost.method);
}

}  // namespace

RowEstimate estimate(const StudyRow& row, const report::PriceList& list) {
    const auto work = [](const render::Cost& cost) {
        return report::PictureWork{cost.passes, cost.rays};
    };
    RowEstimate estimate;
    for (const render::Cost& cost : row.costs)
        estimate.seconds.push_back(report::seconds_interval(work(cost), list));
    estimate.gain =
        report::ratio_interval(work(row.cost("ray-tracing")), work(row.cost("item-buffer")), list);
    return estimate;
}

void PassStudy::add(StudyRow row) {
    if (row.sweep != "samples")  // the others are not compared
        for (render::Cost& cost : row.costs) cost.color.clear();
    std::vector<RowEstimate> all;
    for (const report::PriceList& list : lists) all.push_back(estimate(row, list));
    estimates.push_back(std::move(all));
    rows.push_back(std::move(row));
}

std::vector<std::size_t> PassStudy::rows_of(const std::string& sweep) const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].sweep == sweep) places.push_back(i);
    return places;
}

std::vector<std::string> PassStudy::sweep_names() const {
    std::vector<std::string> names;
    for (const StudyRow& row : rows)
        if (std::ranges::find(names, row.sweep) == names.end()) names.push_back(row.sweep);
    return names;
}

double PassStudy::measured_gain(std::size_t row) const {
    const double item_buffer = rows[row].cost("item-buffer").median();
    return item_buffer > 0 ? rows[row].cost("ray-tracing").median() / item_buffer : 0;
}

// NOLINTNEXTLINE(readability-function-size): a table
const std::vector<CountColumn>& count_columns() {
    static const std::vector<CountColumn> all{
        {"width",
         [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.size.width); }},
        {"height",
         [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.size.height); }},
        {"samples",
         [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.samples); }},
        {"lights", [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.lights); }},
        {"depth", [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.depth); }},
        {"triangles",
         [](const StudyRow& r, const render::Cost&) { return std::uint64_t(r.triangles); }},
        {"passes",
         [](const StudyRow&, const render::Cost& c) { return std::uint64_t(c.passes.size()); }},
        {"draws", [](const StudyRow&, const render::Cost& c) { return c.sum().draws; }},
        {"primitives", [](const StudyRow&, const render::Cost& c) { return c.sum().primitives; }},
        {"fragments", [](const StudyRow&, const render::Cost& c) { return c.sum().fragments; }},
        {"written", [](const StudyRow&, const render::Cost& c) { return c.sum().written; }},
        {"texels", [](const StudyRow&, const render::Cost& c) { return c.sum().texels; }},
        {"pixels", [](const StudyRow&, const render::Cost& c) { return c.sum().pixels; }},
        {"bytes", [](const StudyRow&, const render::Cost& c) { return c.sum().bytes; }},
        {"primary", [](const StudyRow&, const render::Cost& c) { return c.rays.primary; }},
        {"reflected", [](const StudyRow&, const render::Cost& c) { return c.rays.reflected; }},
        {"transmitted", [](const StudyRow&, const render::Cost& c) { return c.rays.transmitted; }},
        {"shadow", [](const StudyRow&, const render::Cost& c) { return c.rays.shadow; }},
        {"shaded", [](const StudyRow&, const render::Cost& c) { return c.rays.shaded; }},
        {"boxes_tested", [](const StudyRow&, const render::Cost& c) { return c.rays.tests.boxes; }},
        {"triangles_tested",
         [](const StudyRow&, const render::Cost& c) { return c.rays.tests.triangles; }}};
    return all;
}

double rms(const std::vector<Rgba>& a, const std::vector<Rgba>& b, int color_bits) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = double(a[i][k]) - double(b[i][k]);
            sum += d * d;
        }
    return a.empty() ? 0
                     : 255.0 / max_of_bits(color_bits) * std::sqrt(sum / (3 * double(a.size())));
}

std::vector<ErrorRow> errors(const PassStudy& study) {
    std::vector<ErrorRow> all;
    const std::vector<std::size_t> places = study.rows_of("samples");
    if (places.size() < 2) return all;
    const std::size_t most =
        *std::ranges::max_element(places, {}, [&](std::size_t i) { return study.rows[i].samples; });
    const std::size_t reference = place_of("ray-tracing");
    for (const std::size_t i : places)
        for (std::size_t m = 0; m < study.rows[i].costs.size(); ++m)
            if (i != most || m != reference)
                all.push_back({i, m,
                               rms(study.rows[i].costs[m].color,
                                   study.rows[most].costs[reference].color, study.color_bits)});
    return all;
}

std::vector<std::pair<std::string, std::string>> surroundings() {
    return {
        {"program", "gw " + apps::version()}, {"commit", apps::commit()},
#if defined(__clang__)
            {"compiler", fmt::format("clang {}", __clang_version__)},
#else
            {"compiler", fmt::format("gcc {}", __VERSION__)},
#endif
            {"processor", processor_name()}, {
            "vectors", simd_target()
        }
    };
}

std::string counts_csv(const PassStudy& study) {
    std::string text = "sweep,value,x,method";
    for (const CountColumn& column : count_columns()) text += "," + column.name;
    text += ",picture\n";
    for (const StudyRow& row : study.rows)
        for (const render::Cost& cost : row.costs) {
            text += place(row, cost);
            for (const CountColumn& column : count_columns())
                text += fmt::format(",{}", column.of(row, cost));
            text += "," + to_string(cost.picture) + "\n";
        }
    return text;
}

std::string times_csv(const PassStudy& study) {
    std::string where;
    std::string text = "sweep,value,x,method,seconds,least,most,runs,first_seconds";
    for (const auto& [name, value] : surroundings()) {
        text += "," + name;
        where += ",\"" + value + "\"";
    }
    text += "\n";
    for (const StudyRow& row : study.rows)
        for (const render::Cost& cost : row.costs)
            if (!cost.seconds.empty())
                text += fmt::format("{},{:.6f},{:.6f},{:.6f},{},{:.6f}{}\n", place(row, cost),
                                    cost.median(), cost.least(), cost.most(), cost.seconds.size(),
                                    cost.first_seconds, where);
    return text;
}

std::string estimates_csv(const PassStudy& study) {
    std::string text = "prices,sweep,value,x,method,seconds,low,high,gain,gain_low,gain_high\n";
    for (std::size_t l = 0; l < study.lists.size(); ++l)
        for (std::size_t i = 0; i < study.rows.size(); ++i)
            for (std::size_t m = 0; m < study.rows[i].costs.size(); ++m) {
                const RowEstimate& e = study.estimates[i][l];
                text += fmt::format(
                    "{},{},{:.6g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}\n", study.lists[l].name,
                    place(study.rows[i], study.rows[i].costs[m]), e.seconds[m].value,
                    e.seconds[m].low, e.seconds[m].high, e.gain.value, e.gain.low, e.gain.high);
            }
    return text;
}

std::string errors_csv(const PassStudy& study) {
    std::string text = "samples,method,error,seconds";
    for (const report::PriceList& list : study.lists) text += "," + list.name + "_seconds";
    text += "\n";
    for (const ErrorRow& e : errors(study)) {
        const render::Cost& cost = study.rows[e.row].costs[e.method];
        text += fmt::format("{},{},{:.6f},{:.6f}", study.rows[e.row].samples, cost.method, e.error,
                            cost.median());
        for (const RowEstimate& list : study.estimates[e.row])
            text += fmt::format(",{:.6g}", list.seconds[e.method].value);
        text += "\n";
    }
    return text;
}

std::string results_json(const PassStudy& study) {
    using Json = nlohmann::ordered_json;
    Json rows = Json::array(), omitted = Json::array(), about;
    for (const auto& [name, value] : surroundings()) about[name] = value;
    for (std::size_t i = 0; i < study.rows.size(); ++i) {
        const StudyRow& row = study.rows[i];
        for (std::size_t m = 0; m < row.costs.size(); ++m) {
            const render::Cost& cost = row.costs[m];
            Json counts, estimates;
            for (const CountColumn& column : count_columns())
                counts[column.name] = column.of(row, cost);
            for (std::size_t l = 0; l < study.lists.size(); ++l) {
                const Interval& s = study.estimates[i][l].seconds[m];
                const Interval& g = study.estimates[i][l].gain;
                estimates[study.lists[l].name] = {{"seconds", {s.low, s.value, s.high}},
                                                  {"gain", {g.low, g.value, g.high}}};
            }
            rows.push_back({{"sweep", row.sweep},
                            {"value", row.value},
                            {"x", row.x},
                            {"method", cost.method},
                            {"counts", counts},
                            {"picture", to_string(cost.picture)},
                            {"seconds", cost.seconds},
                            {"first_seconds", cost.first_seconds},
                            {"estimated", estimates}});
        }
    }
    for (const Omission& o : study.omissions)
        omitted.push_back({{"sweep", o.sweep}, {"why", o.why}});
    return Json{
               {"command", study.command}, {"scene", study.scene}, {"scene_hash", study.scene_hash},
               {"profile", study.profile}, {"measured_by", about}, {"rows", rows},
               {"omitted", omitted}}
               .dump(1) +
           "\n";
}

}  // namespace gw::study
