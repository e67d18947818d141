#include "scene/obj/origins.h"

#include "scene/geometry/far.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gw::scene {
namespace {

double side_of(const Bounds& box) {
    const dvec3 sides = box.high - box.low;
    return std::max({sides.x, sides.y, sides.z});
}

double reach_from(const Bounds& box, const dvec3& origin) {
    double reach = 0;
    for (int k = 0; k < 3; ++k)
        reach =
            std::max({reach, std::abs(box.low[k] - origin[k]), std::abs(box.high[k] - origin[k])});
    return reach;
}

Bounds box_of(const ObjData& obj, const Element& element) {
    Bounds box;
    for (const Corner& corner : std::span(obj.corners).subspan(element.first, element.count))
        extend(box, obj.positions[corner.v]);
    return box;
}

/// A v that no element uses does not count: some files begin with one at 0.
std::vector<Bounds> boxes_of_parts(const ObjData& obj) {
    std::vector<Bounds> boxes(obj.parts.size());
    for (const Element& element : obj.elements)
        for (const Corner& corner : std::span(obj.corners).subspan(element.first, element.count))
            extend(boxes[element.part], obj.positions[corner.v]);
    return boxes;
}

/// Where most of a file's corners are: the box without a sixteenth of them at each end of each axis. A
/// few may lie elsewhere, as marks of an origin do.
Bounds box_of_most(const ObjData& obj) {
    Bounds box{.empty = obj.corners.empty()};
    const auto end = std::ptrdiff_t(obj.corners.size() / 16);
    for (int k = 0; k < 3 && !box.empty; ++k) {
        std::vector<double> along;
        for (const Corner& corner : obj.corners) along.push_back(obj.positions[corner.v][k]);
        std::nth_element(along.begin(), along.begin() + end, along.end());
        box.low[k] = along[std::size_t(end)];
        std::nth_element(along.begin(), along.end() - 1 - end, along.end());
        box.high[k] = *(along.end() - 1 - end);
    }
    return box;
}

dvec3 origin_of_file(const ObjData& obj, const std::vector<Bounds>& parts) {
    Bounds box;
    for (const Bounds& part : parts) {
        extend(box, part.low);
        extend(box, part.high);
    }
    const dvec3 origin = far_origin(box);
    return origin != dvec3(0) ? origin : far_origin(box_of_most(obj), very_far_ratio);
}

/// Each part looks through all of them.
constexpr std::size_t most_origins = 64;

/// The first of the origins that is near enough; adds one if there is none.
dvec3 choose_origin(const Bounds& box, std::vector<dvec3>& origins) {
    const double side = side_of(box);
    for (const dvec3& origin : origins)
        if (!(side > 0) || reach_from(box, origin) <= very_far_ratio * side) return origin;
    return origins.size() < most_origins ? origins.emplace_back(far_origin(box)) : origins[0];
}

/// float32 has steps of this size at a distance.
double step_at(double distance) { return std::ldexp(1.0, std::ilogb(distance) - 23); }

/// An element that is this many steps wide or less is visibly deformed.
constexpr double fewest_steps = 64;

}  // namespace

std::vector<dvec3> origins_of_parts(const ObjData& obj) {
    const std::vector<Bounds> boxes = boxes_of_parts(obj);
    std::vector<dvec3> known{origin_of_file(obj, boxes)}, origins;
    for (const Bounds& box : boxes) origins.push_back(choose_origin(box, known));
    if (std::ranges::all_of(origins, [](const dvec3& origin) { return origin == dvec3(0); }))
        return {};
    return origins;
}

void warn_rounded(const ObjData& obj, Warnings& warnings) {
    struct Count {
        std::size_t all = 0, rounded = 0;
        const Element* first = nullptr;
    };
    std::vector<Count> counts(obj.parts.size());
    for (const Element& element : obj.elements) {
        const Bounds box = box_of(obj, element);
        const double side = side_of(box);
        if (!(side > 0)) continue;
        Count& count = counts[element.part];
        ++count.all;
        if (side > fewest_steps * step_at(reach_from(box, obj.parts[element.part].origin)))
            continue;
        if (++count.rounded == 1) count.first = &element;
    }
    for (std::size_t p = 0; p < counts.size(); ++p) {
        if (counts[p].rounded * 16 <= counts[p].all) continue;
        const Bounds box = box_of(obj, *counts[p].first);
        const double reach = reach_from(box, obj.parts[p].origin);
        warnings.add(obj.file, counts[p].first->line, "rounded",
                     "object '" + printable(obj.parts[p].name) + "' has parts " +
                         number_text(std::round(reach)) +
                         " from its middle, where float32 has steps of " +
                         number_text(step_at(reach)) +
                         "; expected objects (o, g) of their own for places so far apart");
    }
}

}  // namespace gw::scene
