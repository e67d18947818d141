#include "scene/geometry/weld.h"

#include <bit>

namespace gw::scene {
namespace {

constexpr std::uint32_t free_slot = 0xffffffff;

// Adding 0 makes 0 of -0. The result does not depend on the hash: the first of several equal
// positions always wins.
std::uint64_t hash(const dvec3& p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
        h = (h ^ std::bit_cast<std::uint64_t>(p[i] + 0.0)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return h;
}

template <class Position>
std::vector<std::uint32_t> weld_all(const std::vector<Position>& positions) {
    const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, free_slot), first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(dvec3(positions[i])) & mask;
        while (table[slot] != free_slot && positions[table[slot]] != positions[i])
            slot = (slot + 1) & mask;
        if (table[slot] == free_slot) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<vec3>& positions) { return weld_all(positions); }
std::vector<std::uint32_t> weld(const std::vector<dvec3>& positions) { return weld_all(positions); }

}  // namespace gw::scene
