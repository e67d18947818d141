#include "radiosity/model/facet_tree.h"

#include <cstddef>
#include <numeric>

namespace gw::radiosity {

namespace {

constexpr std::uint32_t most_in_leaf = 8;

}  // namespace

FacetTree::FacetTree(const std::vector<Facet>& facets) : order_(facets.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!facets.empty()) build(facets, 0, static_cast<std::uint32_t>(facets.size()));
}

/// Divides at the median of the centres, along their longest extent.
std::uint32_t FacetTree::build(const std::vector<Facet>& facets, std::uint32_t first,
                               std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    const Facet& any = facets[order_[first]];
    dvec3 low = any.center, high = any.center;  // of the centres
    Node node{any.center, any.center, first, end, 0};
    for (std::uint32_t i = first; i < end; ++i) {
        const Facet& facet = facets[order_[i]];
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], facet.center[k]);
            high[k] = std::max(high[k], facet.center[k]);
            node.low[k] = std::min(node.low[k], facet.center[k] - facet.radius);
            node.high[k] = std::max(node.high[k], facet.center[k] + facet.radius);
        }
    }
    nodes_.push_back(node);
    if (end - first <= most_in_leaf) return index;
    const dvec3 extent = high - low;
    int axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    const std::uint32_t middle = first + (end - first) / 2;
    const auto at = [&](std::uint32_t i) { return order_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
        return facets[a].center[axis] < facets[b].center[axis];
    });
    build(facets, first, middle);
    const std::uint32_t right = build(facets, middle, end);
    nodes_[index].right = right;
    return index;
}

}  // namespace gw::radiosity
