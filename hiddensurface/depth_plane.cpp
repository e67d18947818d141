#include "hiddensurface/depth_plane.h"

#include <algorithm>
#include <utility>

namespace gw::hiddensurface {

namespace {

/// Nearest integer to n / d, ties to even; d > 0.
int128 divide_round_even(int128 n, int128 d) {
    int128 q = n / d, r = n % d;
    if (r < 0) {
        q -= 1;
        r += d;
    }
    if (2 * r > d || (2 * r == d && (q & 1) != 0)) q += 1;
    return q;
}

/// Counter-clockwise, from the lowest corner (of those the leftmost): the corner that rounding starts from.
std::array<GridPoint, 3> canonical(std::array<GridPoint, 3> p) {
    const std::int64_t area2 = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area2 < 0) std::swap(p[1], p[2]);
    const auto lower = [](const GridPoint& a, const GridPoint& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    };
    std::rotate(p.begin(), std::min_element(p.begin(), p.end(), lower), p.end());
    return p;
}

}  // namespace

DepthPlane depth_plane(const std::array<GridPoint, 3>& triangle, int s, int depth_bits) {
    const auto [p0, p1, p2] = canonical(triangle);
    const int128 ux = p1.x - p0.x, uy = p1.y - p0.y, uz = p1.z - p0.z;
    const int128 vx = p2.x - p0.x, vy = p2.y - p0.y, vz = p2.z - p0.z;
    const int128 nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const int128 one = int128{1} << (16 + s);
    return {divide_round_even(-nx * one, nz),   divide_round_even(-ny * one, nz), p0.z, p0.x, p0.y, s,
            (std::int64_t{1} << depth_bits) - 1};
}

int128 DepthPlane::value(int x, int y) const {
    const int128 dx = center(x, subpixel_bits) - x0, dy = center(y, subpixel_bits) - y0;
    return int128{a0} * 65536 + 32768 + ((gx * dx + gy * dy) >> subpixel_bits);
}

std::int64_t DepthPlane::depth(int128 value) const {
    return static_cast<std::int64_t>(std::clamp<int128>(value >> 16, 0, largest));
}

}  // namespace gw::hiddensurface
