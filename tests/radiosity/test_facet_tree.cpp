// The tree of facets' spheres against a comparison of all of them.
#include "radiosity/model/facet_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace gw::radiosity {
namespace {

TEST(FacetTree, VisitsEachSphereThatMeetsAnotherOnce) {
    std::mt19937 random(1991);
    std::uniform_real_distribution<double> place(-1, 1), size(0, 0.2);
    for (const int count : {0, 1, 8, 9, 300}) {
        std::vector<Facet> facets(std::size_t(count), Facet{});
        for (Facet& facet : facets) {
            facet.center = {place(random), place(random), place(random)};
            facet.radius = size(random);
        }
        if (count > 20) facets[3].radius = 5;  // a floor under all others
        const FacetTree tree(facets);
        std::size_t visits = 0;
        for (const Facet& facet : facets) {
            std::set<std::uint32_t> visited;
            tree.for_each_near(facet.center, facet.radius, [&](std::uint32_t i) {
                visits += 1;
                EXPECT_TRUE(visited.insert(i).second) << i;
            });
            for (std::uint32_t i = 0; i < facets.size(); ++i) {
                const dvec3 between = facets[i].center - facet.center;
                if (dot3(between, between) > std::pow(facets[i].radius + facet.radius, 2)) continue;
                EXPECT_TRUE(visited.count(i)) << i;
            }
        }
        if (count > 20) {
            EXPECT_LT(visits, facets.size() * facets.size() / 3);
        }
    }
}

}  // namespace
}  // namespace gw::radiosity
