#include "bench/peers/strips.h"

#include <cstdint>
#include <unordered_map>

namespace gw::peers {
namespace {

struct Walk {
    std::span<const Triangle> triangles;
    std::unordered_map<std::uint64_t, std::uint32_t>
        across{};  ///< directed edge -> the triangle it belongs to
    std::vector<bool> taken{};

    static std::uint64_t edge(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{a} << 32 | b;
    }

    explicit Walk(std::span<const Triangle> t) : triangles(t), taken(t.size()) {
        for (std::uint32_t i = 0; i < t.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                across.emplace(edge(t[i].vertex[k], t[i].vertex[(k + 1) % 3]), i);
    }
    /// The corner opposite the directed edge of a triangle not yet taken, which it takes.
    bool step(std::uint32_t a, std::uint32_t b, std::uint32_t& opposite) {
        const auto found = across.find(edge(a, b));
        if (found == across.end() || taken[found->second]) return false;
        taken[found->second] = true;
        for (const std::uint32_t v : triangles[found->second].vertex)
            if (v != a && v != b) opposite = v;
        return true;
    }
    /// From one triangle on: every second triangle of a strip is turned round.
    std::vector<unsigned> strip_from(std::uint32_t first) {
        const auto& v = triangles[first].vertex;
        std::vector<unsigned> strip{v[0], v[1], v[2]};
        taken[first] = true;
        for (std::uint32_t next = 0;; strip.push_back(next)) {
            const std::size_t n = strip.size();
            const bool turned = n % 2 != 0;
            if (!step(strip[turned ? n - 1 : n - 2], strip[turned ? n - 2 : n - 1], next))
                return strip;
        }
    }
};

/// Appends a strip at an even place, so that it keeps its winding.
void join(std::vector<unsigned>& all, const std::vector<unsigned>& strip) {
    if (!all.empty()) {
        all.push_back(all.back());
        if (all.size() % 2 == 0) all.push_back(all.back());
        all.push_back(strip.front());
    }
    all.insert(all.end(), strip.begin(), strip.end());
}

}  // namespace

std::vector<unsigned> one_strip(const Mesh& mesh) {
    Walk walk(mesh.triangles());
    std::vector<unsigned> all;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i)
        if (!walk.taken[i]) join(all, walk.strip_from(i));
    return all;
}

}  // namespace gw::peers
