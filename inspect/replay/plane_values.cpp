#include "inspect/replay/plane_values.h"

#include <algorithm>

namespace gw::inspect {
namespace {

/// Calls `f` with the plane of both.
auto with_plane(const Planes& a, const Planes& b, Plane plane, const auto& f) {
    switch (plane) {
        case Plane::Color: return f(a.color, b.color);
        case Plane::Depth: return f(a.depth, b.depth);
        case Plane::Stencil: return f(a.stencil, b.stencil);
        case Plane::Back: return f(a.back, b.back);
        case Plane::Accum: break;
    }
    return f(a.accum, b.accum);
}

std::uint64_t apart(std::int64_t a, std::int64_t b) { return std::uint64_t(a < b ? b - a : a - b); }
template <typename T>
std::uint64_t apart(const std::array<T, 4>& a, const std::array<T, 4>& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += apart(std::int64_t{a[i]}, std::int64_t{b[i]});
    return sum;
}

}  // namespace

std::uint64_t distance(const Planes& a, const Planes& b, Plane plane, int x, int y) {
    const std::size_t i = a.index(x, y);
    return with_plane(a, b, plane, [i](const auto& p, const auto& q) { return apart(p[i], q[i]); });
}

std::vector<std::uint64_t> distances(const Planes& a, const Planes& b, Plane plane) {
    return with_plane(a, b, plane, [](const auto& p, const auto& q) {
        std::vector<std::uint64_t> result(p.size());
        std::transform(p.begin(), p.end(), q.begin(), result.begin(),
                       [](const auto& v, const auto& w) { return apart(v, w); });
        return result;
    });
}

bool same(const Planes& a, const Planes& b, Plane plane) {
    if (plane == Plane::Back && a.back.size() != b.back.size()) return true;
    return with_plane(a, b, plane, [](const auto& p, const auto& q) { return p == q; });
}

std::optional<ivec2> first_difference(const Planes& a, const Planes& b, Plane plane) {
    if (same(a, b, plane)) return {};
    for (int y = a.height - 1; y >= 0; --y)
        for (int x = 0; x < a.width; ++x)
            if (distance(a, b, plane, x, y) != 0) return ivec2(x, y);
    return {};
}

std::vector<WrongPixel> wrong_pixels(const Planes& a, const Planes& b, Plane plane) {
    std::vector<WrongPixel> wrong;
    if (same(a, b, plane)) return wrong;
    for (int y = a.height - 1; y >= 0; --y)
        for (int x = 0; x < a.width; ++x)
            if (const std::uint64_t d = distance(a, b, plane, x, y)) wrong.push_back({x, y, d});
    std::stable_sort(wrong.begin(), wrong.end(), [](const WrongPixel& p, const WrongPixel& q) {
        return p.distance > q.distance;
    });
    return wrong;
}

}  // namespace gw::inspect
