#include "hiddensurface/structures/painter.h"

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

void log_order(const Input& input, const std::vector<std::size_t>& order, StepLog& log) {
    if (!log.on()) return;
    std::vector<std::uint32_t> ids;
    for (const std::size_t i : order) ids.push_back(input.polygons[i].id);
    log.add({Level::Polygon, Action::Sort, std::move(ids), "distance", "far to near"});
}

}  // namespace

Output paint(const Input& input, StepLog& log, const std::string& pass, double Polygon::*key) {
    Output output{.list = begin_picture(input, pass)};
    const std::vector<std::size_t> given = visible_polygons(input);
    std::vector<std::size_t> order = given;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Polygon &p = input.polygons[a], &q = input.polygons[b];
        output.counts.keys += 1;
        log.compare({p.id, q.id}, "distance", p.*key > q.*key ? "farther" : "not farther");
        return p.*key > q.*key;
    });
    output.counts.sorts = 1;
    output.counts.swaps = moved(given, order);
    output.counts.peak_bytes = order.size() * (sizeof(std::size_t) + sizeof(double));
    log_order(input, order, log);
    for (const std::size_t i : order) draw_piece(input, whole(i, input.polygons[i]), output, log);
    return output;
}

}  // namespace gw::hiddensurface
