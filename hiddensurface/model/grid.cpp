#include "hiddensurface/model/grid.h"

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

/// The corners counter-clockwise, from the lowest (of those the leftmost): rounding starts there.
std::array<GridPoint, 3> canonical(std::array<GridPoint, 3> p) {
    const std::int64_t area2 =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area2 < 0) std::swap(p[1], p[2]);
    const auto lower = [](const GridPoint& a, const GridPoint& b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    };
    std::rotate(p.begin(), std::min_element(p.begin(), p.end(), lower), p.end());
    return p;
}

/// A triangle's normal on the grid; n.z > 0 if its corners run counter-clockwise.
struct Normal {
    int128 x, y, z;
};
Normal normal_of(const std::array<GridPoint, 3>& p) {
    const auto& [p0, p1, p2] = p;
    const int128 ux = p1.x - p0.x, uy = p1.y - p0.y, uz = p1.z - p0.z;
    const int128 vx = p2.x - p0.x, vy = p2.y - p0.y, vz = p2.z - p0.z;
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

/// z n.z on the plane at (px, py).
int128 scaled_depth(const GridPoint& p0, const Normal& n, std::int64_t px, std::int64_t py) {
    return n.z * p0.z - n.x * (px - p0.x) - n.y * (py - p0.y);
}

}  // namespace

DepthPlane depth_plane(const std::array<GridPoint, 3>& triangle, int s, int depth_bits) {
    const std::array<GridPoint, 3> p = canonical(triangle);
    const Normal n = normal_of(p);
    const int128 one = int128{1} << (16 + s);
    return {divide_round_even(-n.x * one, n.z),
            divide_round_even(-n.y * one, n.z),
            p[0].z,
            p[0].x,
            p[0].y,
            s,
            (std::int64_t{1} << depth_bits) - 1};
}

int exact_order(const std::array<GridPoint, 3>& a, const std::array<GridPoint, 3>& b, int x, int y,
                int s) {
    const std::array<GridPoint, 3> pa = canonical(a), pb = canonical(b);
    const Normal na = normal_of(pa), nb = normal_of(pb);
    const std::int64_t px = center(x, s), py = center(y, s);
    // Below 2^120 on windows of 4096 pixels with 8 sub-pixel bits and 32 of depth.
    const int128 za = scaled_depth(pa[0], na, px, py) * nb.z,
                 zb = scaled_depth(pb[0], nb, px, py) * na.z;
    return za < zb ? -1 : za > zb ? 1 : 0;
}

bool is_on_plane(const std::array<GridPoint, 3>& triangle, const GridPoint& p) {
    const GridPoint& p0 = triangle[0];
    const Normal n = normal_of(triangle);
    return n.x * (p.x - p0.x) + n.y * (p.y - p0.y) + n.z * (p.z - p0.z) == 0;
}

int128 DepthPlane::value(int x, int y) const {
    const int128 dx = center(x, subpixel_bits) - x0, dy = center(y, subpixel_bits) - y0;
    return int128{a0} * 65536 + 32768 + ((gx * dx + gy * dy) >> subpixel_bits);
}

std::int64_t DepthPlane::depth(int128 value) const {
    return static_cast<std::int64_t>(std::clamp<int128>(value >> 16, 0, largest));
}

}  // namespace gw::hiddensurface
