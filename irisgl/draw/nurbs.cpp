#include "irisgl/draw/nurbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gw::irisgl {

namespace {

/// The basis functions that are not 0 at a parameter, with their slopes.
struct Basis {
    std::size_t first = 0;  ///< the control point of the first
    std::vector<double> value, slope;
};

// N(i, k) = (u - t(i)) / (t(i+k-1) - t(i)) N(i, k-1) + (t(i+k) - u) / (t(i+k) - t(i+1)) N(i+1, k-1)
// [de Boor 1972]
Basis basis_at(const std::vector<double>& knots, std::size_t order, double u) {
    const std::size_t count = knots.size() - order;
    std::size_t span = order - 1;
    while (span + 1 < count && u >= knots[span + 1]) ++span;
    std::vector<double> n{1}, before;
    for (std::size_t k = 2; k <= order; ++k) {
        before = n;
        n.assign(k, 0);
        for (std::size_t i = 0; i + 1 < k; ++i) {  // before[i] is of control point span - k + 2 + i
            const std::size_t at = span + 2 + i - k;
            const double left = knots[at], right = knots[at + k - 1], width = right - left;
            if (!(width > 0)) continue;
            n[i] += before[i] * (right - u) / width;
            n[i + 1] += before[i] * (u - left) / width;
        }
    }
    std::vector<double> slope(order, 0);
    for (std::size_t i = 0; i + 1 < order; ++i) {
        const std::size_t at = span + 2 + i - order;
        const double width = knots[at + order - 1] - knots[at];
        if (!(width > 0)) continue;
        const double d = double(order - 1) * before[i] / width;
        slope[i] -= d;
        slope[i + 1] += d;
    }
    return {span + 1 - order, std::move(n), std::move(slope)};
}

void add(ControlPoint& sum, const ControlPoint& p, double weight) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += p[i] * weight;
}

dvec4 divided(const ControlPoint& p) {
    const double w = p[4] != 0 ? p[4] : 1;
    return {p[0] / w, p[1] / w, p[2] / w, p[3] / w};
}

/// (P / w)' = (P' - (P / w) w') / w.
dvec4 slope_of(const ControlPoint& p, const ControlPoint& d) {
    const dvec4 at = divided(p);
    const double w = p[4] != 0 ? p[4] : 1;
    dvec4 out;
    for (int i = 0; i < 4; ++i) out[i] = (d[std::size_t(i)] - at[i] * d[4]) / w;
    return out;
}

}  // namespace

dvec4 point_of(const NurbsCurve& curve, double u) {
    const Basis b = basis_at(curve.knots, curve.order, u);
    ControlPoint sum{};
    for (std::size_t i = 0; i < curve.order; ++i) add(sum, curve.control[b.first + i], b.value[i]);
    return divided(sum);
}

SurfacePoint point_of(const NurbsSurface& surface, double s, double t) {
    const Basis a = basis_at(surface.s_knots, surface.s_order, s),
                b = basis_at(surface.t_knots, surface.t_order, t);
    ControlPoint p{}, ds{}, dt{};
    for (std::size_t i = 0; i < surface.s_order; ++i)
        for (std::size_t k = 0; k < surface.t_order; ++k) {
            const ControlPoint& c =
                surface.control[(a.first + i) * surface.t_count() + b.first + k];
            add(p, c, a.value[i] * b.value[k]);
            add(ds, c, a.slope[i] * b.value[k]);
            add(dt, c, a.value[i] * b.slope[k]);
        }
    return {divided(p), slope_of(p, ds), slope_of(p, dt)};
}

std::vector<double> parameters(const std::vector<double>& knots, std::size_t order,
                               std::size_t steps) {
    std::vector<double> out{knots[order - 1]};
    for (std::size_t i = order; i + order <= knots.size(); ++i) {
        const double from = out.back(), to = knots[i];
        if (!(to > from)) continue;
        for (std::size_t k = 1; k < steps; ++k)
            out.push_back(from + (to - from) * double(k) / double(steps));
        out.push_back(to);
    }
    return out;
}

namespace {

/// A side of a loop inside a strip of t, as s at its lower and upper end.
struct Side {
    double lower = 0, upper = 0;
    bool rises = false;  ///< what stays is on its left: at smaller s
    double middle() const { return lower + upper; }
};

double s_at(const dvec2& a, const dvec2& b, double t) {
    return a.x + (b.x - a.x) * (t - a.y) / (b.y - a.y);
}

std::vector<Side> sides_in(double low, double high, const TrimLoops& loops) {
    std::vector<Side> out;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if (std::min(a.y, b.y) > low || std::max(a.y, b.y) < high || a.y == b.y) continue;
            out.push_back({s_at(a, b, low), s_at(a, b, high), b.y > a.y});
        }
    std::sort(out.begin(), out.end(),
              [](const Side& a, const Side& b) { return a.middle() < b.middle(); });
    return out;
}

/// Whether the surface beyond all loops stays: the outermost loop runs clockwise.
bool stays_outside(const TrimLoops& loops) {
    double s = std::numeric_limits<double>::infinity(), area = 0;
    for (const auto& loop : loops) {
        double least = std::numeric_limits<double>::infinity(), twice = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            least = std::min(least, a.x);
            twice += a.x * b.y - a.y * b.x;
        }
        if (least >= s) continue;
        s = least;
        area = twice;
    }
    return area <= 0;
}

using Polygon = std::vector<dvec2>;

/// The part of a convex polygon on one side of a line of constant s.
Polygon cut(const Polygon& p, double s, bool keeps_greater) {
    Polygon out;
    const auto inside = [&](const dvec2& v) { return keeps_greater ? v.x >= s : v.x <= s; };
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
        if (inside(a)) out.push_back(a);
        if (inside(a) != inside(b)) out.push_back({s, a.y + (b.y - a.y) * (s - a.x) / (b.x - a.x)});
    }
    return out;
}

void add_cells(std::vector<Polygon>& out, const Polygon& strip, const std::vector<double>& s) {
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        const Polygon cell = cut(cut(strip, s[i], true), s[i + 1], false);
        if (cell.size() >= 3) out.push_back(cell);
    }
}

}  // namespace

std::vector<Polygon> trimmed(const std::vector<double>& s, const std::vector<double>& t,
                             const TrimLoops& loops) {
    std::vector<double> levels = t;
    for (const auto& loop : loops)
        for (const dvec2& p : loop)
            if (p.y > t.front() && p.y < t.back()) levels.push_back(p.y);
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    const bool outside = stays_outside(loops);
    std::vector<Polygon> out;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        const double low = levels[i], high = levels[i + 1];
        std::vector<Side> sides = sides_in(low, high, loops);
        if (outside) sides.insert(sides.begin(), {s.front(), s.front(), false});
        if (outside) sides.push_back({s.back(), s.back(), true});
        for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
            const Side &a = sides[k], &b = sides[k + 1];
            if (a.rises || !b.rises) continue;
            add_cells(out, {{a.lower, low}, {b.lower, low}, {b.upper, high}, {a.upper, high}}, s);
        }
    }
    return out;
}

}  // namespace gw::irisgl
