#include "apps/command/page_style.h"
#include "apps/study/passes/plots.h"
#include "image/plot/markup.h"

#include <fmt/format.h>

namespace gw::study {
namespace {

using plot::escaped;

std::string table_html(const std::vector<std::vector<std::string>>& rows) {
    std::string html = "<div class=\"wide\"><table>\n";
    const char* cell = "th";
    for (const auto& row : rows) {
        html += "<tr>";
        for (const std::string& word : row)
            html += fmt::format("<{0}>{1}</{0}>", cell, escaped(word));
        html += "</tr>\n";
        cell = "td";
    }
    return html + "</table></div>\n";
}

/// The scene itself by every method.
std::string methods_html(const PassStudy& study) {
    std::vector<std::vector<std::string>> rows{{"method", "passes", "primitives", "fragments",
                                                "rays", "boxes", "triangles", "seconds here"}};
    for (const report::PriceList& list : study.lists)
        rows[0].push_back(list.name + " s, estimated");
    const render::StudyRow& row = study.rows.front();
    for (std::size_t m = 0; m < row.costs.size(); ++m) {
        const render::Cost& c = row.costs[m];
        rows.push_back(
            {render::methods()[m].about, std::to_string(c.passes.size()),
             std::to_string(c.sum().primitives), std::to_string(c.sum().fragments),
             std::to_string(c.rays.primary + c.rays.reflected + c.rays.transmitted + c.rays.shadow),
             std::to_string(c.rays.tests.boxes), std::to_string(c.rays.tests.triangles),
             c.seconds.empty()
                 ? "-"
                 : fmt::format("{:.4f} [{:.4f}, {:.4f}]", c.median(), c.least(), c.most())});
        for (const RowEstimate& e : study.estimates.front()) {
            const Interval& s = e.seconds[m];
            rows.back().push_back(fmt::format("{:.3g} [{:.3g}, {:.3g}]", s.value, s.low, s.high));
        }
    }
    return table_html(rows);
}

std::string sweep_html(const PassStudy& study, const std::string& name) {
    std::string html = "<h2>By " + escaped(render::sweep_named(name).label) + "</h2>\n";
    for (const StudyPlot& p : plots(study, name))
        html += fmt::format("<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n", p.name,
                            escaped(p.plot.title));
    html += table_html(table_of(study, name));
    for (const std::string& line : crossings(study, name))
        html += "<p>" + escaped(line) + ".</p>\n";
    return html;
}

std::string prices_html(const PassStudy& study) {
    std::string html = "<h2>Prices</h2>\n";
    for (const report::PriceList& list : study.lists) {
        html += "<h3>" + escaped(list.name + ": " + list.machine) + "</h3>\n";
        std::vector<std::vector<std::string>> rows{{"count", "stage", "nanoseconds", "source"}};
        for (const report::Price& p : list.prices)
            rows.push_back({p.count.name, p.stage,
                            fmt::format("{:g} [{:g}, {:g}]", p.nanoseconds, p.low, p.high),
                            (p.estimate ? "estimate: " : "") + p.source});
        html += table_html(rows);
        if (list.calibration)
            html += fmt::format(
                "<p>The processor's prices are scaled so that the calibration's rays take {:g} s "
                "[{:g}, {:g}]: {}.</p>\n",
                list.calibration->seconds, list.calibration->low, list.calibration->high,
                escaped(list.calibration->source));
    }
    return html;
}

std::string measured_html(const PassStudy& study) {
    std::string html = "<h2>How it was measured</h2>\n<pre>" + escaped(study.command) + "</pre>\n";
    html +=
        "<p>Counts are those of one picture from nothing. They are the same on every computer. "
        "Estimates are counts times prices: a pass takes as long as its slowest stage, passes "
        "follow each other, and the processor traces rays after them. An interval is the least and "
        "the most over all limits of the prices. ";
    html += study.runs == 0
                ? "Times were not measured.</p>\n"
                : fmt::format(
                      "Times are processor seconds of all threads, the median [least, most] "
                      "of {} runs, the methods in turn. Hierarchies and shadow volumes were "
                      "made before.</p>\n",
                      study.runs);
    std::vector<std::vector<std::string>> rows{{"what", "value"}};
    for (const auto& [name, value] : surroundings()) rows.push_back({name, value});
    rows.push_back({"profile", study.profile});
    html += table_html(rows);
    for (const Omission& o : study.omissions)
        html += "<p>" + escaped(o.sweep + ": " + o.why) + ".</p>\n";
    return html;
}

}  // namespace

std::string page(const PassStudy& study) {
    std::string html =
        apps::page_begin("Passes and rays: " + study.scene) +
        "<style>img{width:min(100%,720px)}td,th{text-align:right}td:last-child{text-align:left}"
        "</style>\n<p>One picture by passes, by an item buffer and by ordinary ray tracing. g is the "
        "share of the pixels whose reflections are traced. The paper says 3 to 5 times faster.</p>\n"
        "<p>Numbers: <a href=\"counts.csv\">counts.csv</a>, <a "
        "href=\"estimates.csv\">estimates.csv</a>, <a href=\"times.csv\">times.csv</a>, <a "
        "href=\"errors.csv\">errors.csv</a>, <a href=\"results.json\">results.json</a></p>\n";
    html += methods_html(study) + table_html(table_of(study, render::no_sweep().name));
    for (const std::string& name : study.sweep_names())
        if (name != render::no_sweep().name) html += sweep_html(study, name);
    return html + prices_html(study) + measured_html(study) + std::string(apps::page_end);
}

}  // namespace gw::study
