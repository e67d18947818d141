// The painter's algorithm [L5]: polygons sorted by one distance each and drawn far to near.
// Three variants: by the farthest corner, the nearest corner, the centroid.
//
// Does not claim to be right: the distance of one point does not always say which polygon hides
// which. Never splits.
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/structures/merge_sort.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

std::vector<std::size_t> visible_polygons(const Input& input) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < input.polygons.size(); ++i)
        if (input.polygons[i].visible()) order.push_back(i);
    return order;
}

std::uint64_t moved(const std::vector<std::size_t>& before, const std::vector<std::size_t>& after) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < before.size(); ++i) count += before[i] != after[i] ? 1 : 0;
    return count;
}

void log_order(const Input& input, const std::vector<std::size_t>& order, double Polygon::*key,
               StepLog& log) {
    if (!log.on()) return;
    Step step{.action = Action::Sort, .test = "distance", .result = "sorted", .decisive = true};
    std::vector<double> keys;
    for (const std::size_t i : order) {
        step.pieces.push_back(name_of(input.polygons[i]));
        keys.push_back(input.polygons[i].*key);
    }
    step.values = {{"keys", keys}};
    log.add(std::move(step));
}

/// `key`: Polygon::farthest, nearest or centroid. Equal distances keep the scene's order.
Output paint(const Input& input, StepLog& log, const std::string& pass, double Polygon::*key) {
    Output output{.list = begin_picture(input, pass)};
    const std::vector<std::size_t> given = visible_polygons(input);
    std::vector<std::size_t> order = given;
    log.watch(watched(output.counts));
    merge_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Polygon &p = input.polygons[a], &q = input.polygons[b];
        output.counts.keys += 1;
        if (log.on())
            log.add({.test = "distance",
                     .result = p.*key > q.*key ? "farther" : "not-farther",
                     .pieces = {name_of(p), name_of(q)},
                     .values = {{"first_key", p.*key}, {"second_key", q.*key}}});
        return p.*key > q.*key;
    });
    output.counts.sorts = 1;
    output.counts.swaps = moved(given, order);
    output.counts.peak_bytes = order.size() * (sizeof(std::size_t) + sizeof(double));
    log_order(input, order, key, log);
    for (const std::size_t i : order) draw_piece(input, whole(i, input.polygons[i]), output, log);
    return output;
}

Algorithm painter(const std::string& variant, const std::string& point, double Polygon::*key) {
    return {.name = "painter-" + variant,
            .title = "Painter's algorithm by the " + point + " [L5]",
            .run = [=](const Input& input, StepLog& log) {
                return paint(input, log, "painter's, " + variant, key);
            }};
}

}  // namespace

Algorithm painter_farthest() { return painter("farthest", "farthest corner", &Polygon::farthest); }

Algorithm painter_nearest() { return painter("nearest", "nearest corner", &Polygon::nearest); }

Algorithm painter_centroid() { return painter("centroid", "centroid", &Polygon::centroid); }

}  // namespace gw::hiddensurface
