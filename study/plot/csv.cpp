#include "study/plot/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gw::plot {
namespace {

/// A name may hold anything but is one field.
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

}  // namespace gw::plot
