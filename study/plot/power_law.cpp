#include "gw/base/elementary.h"
#include "gw/error.h"
#include "study/plot/plot.h"

namespace gw::plot {

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
