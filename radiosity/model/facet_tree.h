// A binary tree of the spheres around facets, to find those that meet a sphere. Does not know why.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gw::radiosity {

class FacetTree {
public:
    explicit FacetTree(const std::vector<Facet>& facets);

    /// Calls visit(facet) for each facet whose sphere meets this one, and for others close by.
    template <class Visit>
    void for_each_near(const dvec3& center, double radius, const Visit& visit) const {
        if (!nodes_.empty()) visit_below(0, center, radius, visit);
    }

private:
    /// A box around the spheres of order_[first] to order_[end - 1].
    struct Node {
        dvec3 low{0}, high{0};
        std::uint32_t first = 0, end = 0;
        std::uint32_t right = 0;  ///< the left child is the next node; 0: a leaf
    };

    std::uint32_t build(const std::vector<Facet>& facets, std::uint32_t first, std::uint32_t end);

    template <class Visit>
    void visit_below(std::uint32_t index, const dvec3& center, double radius,
                     const Visit& visit) const {
        const Node& node = nodes_[index];
        double square = 0;  // of the distance to the box
        for (int i = 0; i < 3; ++i) {
            const double d = std::max({node.low[i] - center[i], center[i] - node.high[i], 0.0});
            square += d * d;
        }
        if (square > radius * radius) return;
        if (node.right != 0) {
            visit_below(index + 1, center, radius, visit);
            visit_below(node.right, center, radius, visit);
            return;
        }
        for (std::uint32_t i = node.first; i < node.end; ++i) visit(order_[i]);
    }

    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace gw::radiosity
