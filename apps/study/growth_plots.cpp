#include "apps/study/growth_plots.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::study {
namespace {

/// The algorithms in the order of the points.
std::vector<std::string> algorithms_of(const Growth& growth, bool lines) {
    std::vector<std::string> names;
    for (const GrowthPoint& p : growth.points)
        if (p.lines == lines && std::find(names.begin(), names.end(), p.algorithm) == names.end())
            names.push_back(p.algorithm);
    return names;
}

/// The points above 0, because the axes are logarithmic.
std::vector<dvec2> points_of(const Growth& growth, const std::string& axis,
                             const std::string& algorithm, const std::string& value) {
    std::vector<dvec2> points;
    for (const GrowthPoint& p : growth.points) {
        if (p.axis != axis || p.algorithm != algorithm) continue;
        const auto found = p.values.find(value);
        if (found != p.values.end() && found->second > 0 && p.x > 0)
            points.push_back({p.x, found->second});
    }
    return points;
}

std::string caption_of(const Growth& growth, const GrowthAxis& axis, bool lines) {
    std::string text = lines ? "Hills over a grid" : "Triangles in all directions";
    text += axis.name == "polygons" ? "" : lines ? ", 256 cells" : ", 256 of them";
    if (axis.name != "resolution") text += "; 160x120 pixels";
    if (axis.name != "depth" && !lines) text += "; about 4 over each pixel";
    for (const GrowthCut& cut : growth.cuts) {
        const std::vector<std::string> names = algorithms_of(growth, lines);
        if (cut.axis == axis.name && std::count(names.begin(), names.end(), cut.algorithm) > 0)
            text += fmt::format(". {} was stopped after {:.6g}: {:.2g} s", cut.algorithm, cut.x,
                                cut.seconds);
    }
    return text + ".";
}

}  // namespace

void add_styles(plot::Plot& plot, const Growth& growth, bool lines) {
    const std::vector<std::string> names = algorithms_of(growth, lines);
    for (plot::Series& series : plot.series)
        series.style = std::size_t(std::ranges::find(names, series.name) - names.begin());
}

std::vector<GrowthPlot> growth_plots(const Growth& growth) {
    std::vector<GrowthPlot> plots;
    for (const GrowthAxis& axis : growth_axes())
        for (const bool lines : {false, true})
            for (const std::string& value : growth_values(lines)) {
                plot::Plot plot{.title = fmt::format("{}{} against {}", lines ? "Lines: " : "",
                                                     value, axis.name),
                                .caption = caption_of(growth, axis, lines),
                                .command = "",
                                .x = {axis.label, axis.log},
                                .y = {value, 10},
                                .series = {}};
                for (const std::string& name : algorithms_of(growth, lines))
                    if (auto points = points_of(growth, axis.name, name, value); !points.empty())
                        plot.series.push_back({.name = name, .points = std::move(points)});
                add_styles(plot, growth, lines);
                if (!plot.series.empty())
                    plots.push_back(
                        {fmt::format("{}{}_{}", lines ? "lines_" : "", axis.name, value), axis.name,
                         value, lines, std::move(plot)});
            }
    return plots;
}

std::vector<GrowthLaw> growth_laws(const Growth& growth) {
    std::vector<GrowthLaw> laws;
    for (const GrowthAxis& axis : growth_axes())
        for (const bool lines : {false, true})
            for (const std::string& name : algorithms_of(growth, lines))
                for (const std::string& value : growth_values(lines)) {
                    const std::vector<dvec2> points = points_of(growth, axis.name, name, value);
                    if (points.size() >= 3)
                        laws.push_back({axis.name, name, value, lines, plot::power_law(points),
                                        points.size()});
                }
    return laws;
}

std::string growth_csv(const Growth& growth) {
    std::string text = "axis,algorithm,value,x,y\n";
    for (const GrowthPoint& p : growth.points)
        for (const auto& [name, y] : p.values)
            text += fmt::format("{},{},{},{},{}\n", p.axis, p.algorithm, name, p.x, y);
    return text;
}

std::string laws_csv(const std::vector<GrowthLaw>& laws) {
    std::string text = "axis,algorithm,value,exponent,factor,points\n";
    for (const GrowthLaw& law : laws)
        text += fmt::format("{},{},{},{:.4f},{:.6g},{}\n", law.axis, law.algorithm, law.value,
                            law.law.exponent, law.law.factor, law.points);
    return text;
}

}  // namespace gw::study
