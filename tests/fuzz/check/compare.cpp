#include "tests/fuzz/check/compare.h"

#include "gw/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gw::fuzz {
namespace {

template <typename Vector>
std::optional<std::size_t> first_unequal(const Vector& a, const Vector& b) {
    if (a == b) return std::nullopt;
    if (a.size() != b.size()) return 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i]) return i;
    return std::nullopt;
}

std::optional<std::size_t> first_unequal(const Planes& a, const Planes& b, Plane plane) {
    switch (plane) {
        case Plane::Color: return first_unequal(a.color, b.color);
        case Plane::Depth: return first_unequal(a.depth, b.depth);
        case Plane::Stencil: return first_unequal(a.stencil, b.stencil);
        case Plane::Accum: return first_unequal(a.accum, b.accum);
        case Plane::Back: return first_unequal(a.back, b.back);
    }
    return std::nullopt;
}

std::optional<Difference> compare_planes(const Planes& a, const Planes& b) {
    if (a.width != b.width || a.height != b.height)
        return Difference{"size of the planes",
                          {},
                          {},
                          fmt::format("{}x{}", a.width, a.height),
                          fmt::format("{}x{}", b.width, b.height)};
    for (const Plane plane :
         {Plane::Depth, Plane::Stencil, Plane::Color, Plane::Back, Plane::Accum}) {
        const auto i = first_unequal(a, b, plane);
        if (!i) continue;
        const int x = static_cast<int>(*i) % a.width, y = static_cast<int>(*i) / a.width;
        return Difference{fmt::format("plane {}", name_of(plane)),
                          plane,
                          {x, y},
                          value_at(a, plane, x, y),
                          value_at(b, plane, x, y)};
    }
    return std::nullopt;
}

std::optional<Difference> compare_pass(std::size_t i, const PassReport& a, const PassReport& b) {
    if (a == b) return std::nullopt;
    const std::string pass = fmt::format("pass {} '{}'", i, a.name);
    if (a.name != b.name) return Difference{pass + ", name", {}, {}, a.name, b.name};
    for (const CounterName& c : counter_names())
        if (a.counters.*c.count != b.counters.*c.count)
            return Difference{fmt::format("{}, counter {}", pass, c.name),
                              {},
                              {},
                              std::to_string(a.counters.*c.count),
                              std::to_string(b.counters.*c.count)};
    for (const Plane plane : every_plane)
        if (a.digests[std::size_t(plane)] != b.digests[std::size_t(plane)])
            return Difference{fmt::format("{}, digest of {}", pass, name_of(plane)),
                              {},
                              {},
                              to_string(a.digests[std::size_t(plane)]),
                              to_string(b.digests[std::size_t(plane)])};
    if (a.queries != b.queries)
        return Difference{pass + ", queries",
                          {},
                          {},
                          std::to_string(a.queries.size()),
                          std::to_string(b.queries.size())};
    return Difference{
        pass + ", planes digested", {}, {}, std::to_string(a.digested), std::to_string(b.digested)};
}

std::optional<Difference> compare_passes(const std::vector<PassReport>& a,
                                         const std::vector<PassReport>& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (const auto difference = compare_pass(i, a[i], b[i])) return difference;
    if (a.size() == b.size()) return std::nullopt;
    return Difference{
        "number of passes", {}, {}, std::to_string(a.size()), std::to_string(b.size())};
}

std::string first_value(const Readback& r, std::size_t i) {
    if (i < r.color.size()) return fmt::format("{}", fmt::join(r.color[i], " "));
    if (i < r.accum.size()) return fmt::format("{}", fmt::join(r.accum[i], " "));
    return i < r.values.size() ? std::to_string(r.values[i]) : "nothing";
}

std::optional<Difference> compare_readbacks(const std::map<std::uint32_t, Readback>& a,
                                            const std::map<std::uint32_t, Readback>& b) {
    if (a == b) return std::nullopt;
    for (const auto& [key, ra] : a) {
        const std::string what = fmt::format("read-back {}", key);
        const auto found = b.find(key);
        if (found == b.end()) return Difference{what, {}, {}, "present", "missing"};
        const Readback& rb = found->second;
        if (ra == rb) continue;
        for (const auto& i :
             {first_unequal(ra.color, rb.color), first_unequal(ra.values, rb.values),
              first_unequal(ra.accum, rb.accum)})
            if (i)
                return Difference{fmt::format("{}, value {}", what, *i),
                                  {},
                                  {},
                                  first_value(ra, *i),
                                  first_value(rb, *i)};
        return Difference{what + ", plane or rectangle", {}, {}, "", ""};
    }
    return Difference{
        "number of read-backs", {}, {}, std::to_string(a.size()), std::to_string(b.size())};
}

}  // namespace

std::optional<Difference> first_difference(Machine& a, Machine& b) {
    if (auto difference = compare_planes(a.planes(), b.planes())) return difference;
    if (auto difference = compare_passes(a.passes(), b.passes())) return difference;
    return compare_readbacks(a.readbacks(), b.readbacks());
}

}  // namespace gw::fuzz
