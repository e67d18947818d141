#include "scene/geometry/weld.h"

#include <bit>

namespace gw::scene {
namespace {

constexpr std::uint32_t free_slot = 0xffffffff;

// Adding 0 makes 0 of -0. The result does not depend on the hash: the first of several equal
// positions always wins.
std::uint64_t hash(vec3 p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
        h = (h ^ std::bit_cast<std::uint32_t>(p[i] + 0.0f)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return h;
}

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<vec3>& positions) {
    const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, free_slot), first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & mask;
        while (table[slot] != free_slot && positions[table[slot]] != positions[i])
            slot = (slot + 1) & mask;
        if (table[slot] == free_slot) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

}  // namespace gw::scene
