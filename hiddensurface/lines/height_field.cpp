#include "hiddensurface/lines/height_field.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace gw::hiddensurface {
namespace {

constexpr const char* expected =
    "; expected a height field for floating-horizon: y over a grid along x and z, such as "
    "scenes/hidden/hills.toml";

std::vector<double> coordinates(const std::vector<Polygon>& polygons, int axis) {
    std::vector<double> values;
    for (const Polygon& polygon : polygons)
        for (const dvec3& p : polygon.world) values.push_back(p[axis]);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// The cell along an axis that the polygon spans; none: not exactly one.
std::optional<std::size_t> cell_along(const std::vector<double>& values, const Loop& loop,
                                      int axis) {
    double low = loop[0][axis], high = low;
    for (const dvec3& p : loop) {
        low = std::min(low, p[axis]);
        high = std::max(high, p[axis]);
    }
    const auto at = std::lower_bound(values.begin(), values.end(), low);
    if (at == values.end() || at + 1 == values.end() || *(at + 1) != high) return std::nullopt;
    return std::size_t(at - values.begin());
}

double area_from_above(const Loop& loop) {
    double sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const dvec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
        sum += p.x * q.z - q.x * p.z;
    }
    return std::abs(sum) / 2;
}

void add_polygon(const Polygon& polygon, FieldCell& cell) {
    for (const WorldFacet& facet : polygon.world_facets)
        cell.loops.insert(cell.loops.end(), facet.parts.begin(), facet.parts.end());
    for (std::size_t k = 0; k < polygon.world.size(); ++k)
        cell.sides.emplace_back(polygon.world[k], polygon.world[(k + 1) % polygon.world.size()]);
    cell.id = polygon.id;
}

/// The axis along which the eye is outside the field; if both, the one along which it is farther.
int sweep_axis(const dvec4& eye, const std::vector<double>& xs, const std::vector<double>& zs) {
    if (eye.w == 0) {
        if (eye.x == 0 && eye.z == 0)
            throw Error("the eye looks straight down" + std::string(expected) +
                        ", seen from beside");
        return std::abs(eye.z) >= std::abs(eye.x) ? 2 : 0;
    }
    const auto beyond = [](double e, const std::vector<double>& v) {
        return std::max(v.front() - e, e - v.back());
    };
    const double x = beyond(eye.x, xs), z = beyond(eye.z, zs);
    if (x <= 0 && z <= 0)
        throw Error("the eye is above the field, so its lines have no order from near to far" +
                    std::string(expected) + ", seen from beside");
    return z >= x ? 2 : 0;
}

void check_heights(const std::vector<Polygon>& polygons) {
    std::map<std::pair<double, double>, double> heights;
    for (const Polygon& polygon : polygons)
        for (const dvec3& p : polygon.world) {
            const auto [found, is_new] = heights.try_emplace({p.x, p.z}, p.y);
            if (!is_new && found->second != p.y)
                throw Error(fmt::format("there are heights {} and {} at x {}, z {}{}",
                                        found->second, p.y, p.x, p.z, expected));
        }
}

}  // namespace

HeightField height_field(const Input& input) {
    const std::vector<double> xs = coordinates(input.polygons, 0),
                              zs = coordinates(input.polygons, 2);
    if (xs.size() < 2 || zs.size() < 2)
        throw Error("the scene has no polygon seen from above" + std::string(expected));
    check_heights(input.polygons);
    HeightField field;
    field.sweep = sweep_axis(eye_of(input.view), xs, zs);
    field.across = 2 - field.sweep;
    field.columns = field.across == 0 ? xs : zs;
    field.strips = field.across == 0 ? zs : xs;
    field.cells.resize((xs.size() - 1) * (zs.size() - 1));
    std::vector<double> covered(field.cells.size());
    for (const Polygon& polygon : input.polygons) {
        const auto column = cell_along(field.columns, polygon.world, field.across),
                   strip = cell_along(field.strips, polygon.world, field.sweep);
        if (!column || !strip)
            throw Error(fmt::format("polygon {} is not within one cell of the grid{}", polygon.id,
                                    expected));
        const std::size_t cell = *strip * (field.columns.size() - 1) + *column;
        covered[cell] += area_from_above(polygon.world);
        add_polygon(polygon, field.cells[cell]);
    }
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const std::size_t strip = i / (field.columns.size() - 1),
                          column = i % (field.columns.size() - 1);
        const double area = (field.columns[column + 1] - field.columns[column]) *
                            (field.strips[strip + 1] - field.strips[strip]);
        if (std::abs(covered[i] - area) > 1e-6 * area)
            throw Error(fmt::format("its cell at {} {}, {} {} is not covered once{}",
                                    "xyz"[field.across], field.columns[column], "xyz"[field.sweep],
                                    field.strips[strip], expected));
    }
    return field;
}

}  // namespace gw::hiddensurface
