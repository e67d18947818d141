// The floating horizon: H. Williamson, "Algorithm 420: Hidden-line plotting program", CACM 15(2),
// 1972; T. J. Wright, "A two-space solution to the hidden line problem for plotting functions of
// two variables", IEEE Trans. Computers C-22(1), 1973. Cells are visited from near to far as in D.
// P. Anderson, "Hidden line elimination in projected grid surfaces", ACM Trans. Graphics 1(4),
// 1982.
//
// The lines of a surface y = f(x, z) are drawn from near to far. In every column of the picture,
// the lines drawn so far cover everything from their lowest to their highest point. A farther line
// is visible above the upper horizon and below the lower one, and there becomes the horizon.
// Williamson keeps the horizon as pieces of lines, Wright as a height for each column of the
// plotter; this file follows Williamson. Heights are compared on a picture plane that stands upright
// along the rows, on which the horizons are functions. Visibility does not depend on the plane, so
// the camera may be turned in any way.
//
// Claims: right for a height field (every cell of a grid along x and z covered once, by a
// quadrilateral or two triangles; a bent quadrilateral counts as the two triangles that the machine
// draws), seen from an eye outside its extent in x or in z. Other scenes are refused. Decides in the
// world, before the snap.
#include "hiddensurface/lines/height_field.h"
#include "hiddensurface/lines/horizon.h"
#include "hiddensurface/lines/world_lines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace gw::hiddensurface {
namespace {

/// A point on the upright picture plane, and its distance along the sweep from the eye (1 if sight
/// is parallel).
struct Upright {
    dvec2 at;
    double depth = 1;
};

class FloatingHorizon {
public:
    FloatingHorizon(const Input& input, StepLog& log)
        : field_(height_field(input)), window_(input), eye_(eye_of(input.view)), log_(log) {
        log.watch(watched(output_.counts));
    }

    LineOutput run() {
        const std::size_t strips = field_.strips.size() - 1;
        const bool ascending =
            eye_.w == 0 ? eye_[field_.sweep] < 0 : eye_[field_.sweep] < field_.strips[0];
        for (std::size_t i = 0; i < strips; ++i)
            for (const std::size_t column : columns_in_order()) {
                draw(field_.at(ascending ? i : strips - 1 - i, column));
                output_.counts.faces += 1;
            }
        output_.counts.peak_bytes = largest_ * 4 * sizeof(double);
        return std::move(output_);
    }

private:
    /// A strip's cells from near to far: away from the eye to both sides, or in the direction of
    /// parallel sight.
    std::vector<std::size_t> columns_in_order() const {
        std::vector<std::size_t> order(field_.columns.size() - 1);
        const double e = eye_[field_.across];
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto away = [&](std::size_t i) {
            if (eye_.w == 0) return e > 0 ? -double(i) : double(i);
            return std::max({0.0, field_.columns[i] - e, e - field_.columns[i + 1]});
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
        return order;
    }

    Upright upright(const dvec3& p) const {
        const double e_across = eye_[field_.across], e_sweep = eye_[field_.sweep];
        const double across = p[field_.across], sweep = p[field_.sweep];
        if (eye_.w == 0)
            return {{across - sweep * e_across / e_sweep, p.y - sweep * eye_.y / e_sweep}, 1};
        const double depth = std::abs(sweep - e_sweep);
        return {{(across - e_across) / depth, (p.y - eye_.y) / depth}, depth};
    }

    /// Draws the loop on the eye's side of the diagonal first, and the near sides of each loop first.
    void draw(const FieldCell& cell) {
        std::vector<Loop> loops = cell.loops;
        if (loops.size() == 2 && !is_nearer(loops[0], loops[1])) std::swap(loops[0], loops[1]);
        for (const Loop& loop : loops)
            for (const bool near : {true, false})
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const dvec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
                    if (is_near_side(loop, p, q) != near || !is_new(p, q)) continue;
                    const bool drawn =
                        std::any_of(cell.sides.begin(), cell.sides.end(), [&](const auto& s) {
                            return (s.first == p && s.second == q) ||
                                   (s.first == q && s.second == p);
                        });
                    draw(p, q, drawn ? cell.id : 0);
                }
    }

    /// The side of p -> q on which the (homogeneous) point lies, seen from above.
    double side_of(const dvec3& p, const dvec3& q, const dvec4& point) const {
        const dvec3 along = q - p, to = dvec3(point) - point.w * p;
        return along[field_.across] * to[field_.sweep] - along[field_.sweep] * to[field_.across];
    }
    bool is_near_side(const Loop& loop, const dvec3& p, const dvec3& q) const {
        return side_of(p, q, eye_) * side_of(p, q, dvec4(middle_of(loop), 1)) < 0;
    }
    /// True if the line that separates two loops of a cell has `a` and the eye on one side.
    bool is_nearer(const Loop& a, const Loop& b) const {
        for (std::size_t k = 0; k < a.size(); ++k) {
            const dvec3 &p = a[k], &q = a[(k + 1) % a.size()];
            if (side_of(p, q, dvec4(middle_of(a), 1)) * side_of(p, q, dvec4(middle_of(b), 1)) < 0 &&
                std::count(b.begin(), b.end(), p) > 0 && std::count(b.begin(), b.end(), q) > 0)
                return !is_near_side(a, p, q);
        }
        return true;
    }
    static dvec3 middle_of(const Loop& loop) {
        dvec3 sum(0);
        for (const dvec3& p : loop) sum += p;
        return sum / double(loop.size());
    }

    bool is_new(const dvec3& p, const dvec3& q) {
        const auto key = [](const dvec3& v) { return std::tuple(v.x, v.y, v.z); };
        return done_.insert(std::minmax(key(p), key(q))).second;
    }

    /// Draws p -> q and raises the horizons. `id` 0: only raises them.
    void draw(dvec3 p, dvec3 q, std::uint32_t id) {
        Upright a = upright(p), b = upright(q);
        if (a.at.x > b.at.x) {
            std::swap(p, q);
            std::swap(a, b);
        }
        const bool end_on = b.at.x - a.at.x < 1e-12;
        Values horizons = log_.on() ? horizons_at(a.at, b.at) : Values();
        std::vector<Part> seen = end_on ? beyond_at(a.at, b.at) : beyond_both(a.at, b.at);
        if (!end_on) {
            upper_.raise(a.at, b.at);
            lower_.raise(a.at, b.at);
        }
        largest_ = std::max(largest_, upper_.size() + lower_.size());
        if (id == 0) return;
        for (Part& part : seen) part = {in_world(part.first, a, b), in_world(part.second, a, b)};
        const auto line = window_.to_window(id, p, q, seen);
        if (!line) return;
        output_.counts.lines += 1;
        output_.counts.parts += line->visible.size();
        log_line(*line, "horizon", std::move(horizons), log_);
        output_.lines.push_back(*line);
    }

    /// The heights of the line's ends on the upright plane, and of the horizons there, if any.
    Values horizons_at(const dvec2& a, const dvec2& b) const {
        Values values{{"heights", std::vector{a.y, b.y}}};
        const auto add = [&](const char* name, const Horizon& horizon) {
            const auto at_a = horizon.at(a.x), at_b = horizon.at(b.x);
            if (at_a && at_b) values.emplace_back(name, std::vector{*at_a, *at_b});
        };
        add("upper", upper_);
        add("lower", lower_);
        return values;
    }

    static double in_world(double s, const Upright& a, const Upright& b) {
        return s * a.depth / ((1 - s) * b.depth + s * a.depth);
    }

    std::vector<Part> beyond_both(const dvec2& a, const dvec2& b) {
        std::vector<Part> hidden = rest_of(upper_.beyond(a, b, output_.counts));
        const std::vector<Part> under = rest_of(lower_.beyond(a, b, output_.counts));
        // A part is hidden if it is neither above nor below.
        std::vector<Part> both;
        for (const Part& p : hidden)
            for (const Part& q : under) {
                const Part common{std::max(p.first, q.first), std::min(p.second, q.second)};
                if (common.first < common.second) both.push_back(common);
            }
        return rest_of(std::move(both));
    }

    /// The visible parts of a line that is one column of the picture.
    std::vector<Part> beyond_at(const dvec2& a, const dvec2& b) {
        output_.counts.crossings += 1;
        const auto top = upper_.at(a.x), bottom = lower_.at(a.x);
        if (!top || !bottom || a.y == b.y) return {{0, 1}};
        const double at_top = (*top - a.y) / (b.y - a.y), at_bottom = (*bottom - a.y) / (b.y - a.y);
        return rest_of({{std::min(at_top, at_bottom), std::max(at_top, at_bottom)}});
    }

    HeightField field_;
    WorldLines window_;
    dvec4 eye_;
    StepLog& log_;
    LineOutput output_;
    Horizon upper_{true}, lower_{false};
    std::size_t largest_ = 0;
    std::set<std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>>
        done_;
};

}  // namespace

LineAlgorithm floating_horizon() {
    return {
        .name = "floating-horizon",
        .title = "Floating horizon (Williamson 1972, Wright 1973), for height fields",
        .claim =
            "right for height fields over a grid along x and z, seen from beside; refuses other scenes",
        .run = [](const Input& input, StepLog& log) { return FloatingHorizon(input, log).run(); }};
}

}  // namespace gw::hiddensurface
