#include "image/plot/plot.h"

#include "gw/base/elementary.h"
#include "gw/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gw::plot {
namespace {

/// A name with any characters as one field.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string out = "\"";
    for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

}  // namespace

std::string csv(const Plot& plot) {
    std::string out = field(plot.x.label);
    std::set<double> xs;
    for (const Series& s : plot.series) {
        out += "," + field(s.name);
        for (const dvec2& p : s.points) xs.insert(p.x);
    }
    out += "\n";
    for (const double x : xs) {
        out += fmt::format("{}", x);
        for (const Series& s : plot.series) {
            const auto at = std::find_if(s.points.begin(), s.points.end(),
                                         [x](const dvec2& p) { return p.x == x; });
            out += at == s.points.end() ? "," : fmt::format(",{}", at->y);
        }
        out += "\n";
    }
    return out;
}

double PowerLaw::operator()(double x) const { return factor * gw::pow(x, exponent); }

PowerLaw power_law(const std::vector<dvec2>& points) {
    dvec2 mean(0);
    std::vector<dvec2> logs;
    for (const dvec2& p : points) {
        if (!(p.x > 0 && p.y > 0))
            throw Error("a power law: a coordinate is not above 0; expected points above 0");
        logs.push_back({gw::log(p.x), gw::log(p.y)});
        mean += logs.back() / double(points.size());
    }
    double xx = 0, xy = 0;
    for (const dvec2& p : logs) {
        xx += (p.x - mean.x) * (p.x - mean.x);
        xy += (p.x - mean.x) * (p.y - mean.y);
    }
    if (!(xx > 0)) throw Error("a power law: fewer than two different x; expected two or more");
    const double exponent = xy / xx;
    return {gw::exp(mean.y - exponent * mean.x), exponent};
}

}  // namespace gw::plot
