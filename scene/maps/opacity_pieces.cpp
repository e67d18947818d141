#include "scene/maps/opacity_pieces.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

constexpr int steps = 16;

/// The index of a texel in a row of `size`.
std::int64_t wrapped(std::int64_t i, std::int64_t size, Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat: return (i % size + size) % size;
        case Wrap::MirroredRepeat: {
            const std::int64_t k = (i % (2 * size) + 2 * size) % (2 * size);
            return k < size ? k : 2 * size - 1 - k;
        }
        case Wrap::Clamp:
        case Wrap::BorderClamp:
        case Wrap::ClampToBorder: break;
    }
    return std::clamp<std::int64_t>(i, 0, size - 1);
}

OpacityCorner between_corners(const OpacityCorner& p, const OpacityCorner& q, double t) {
    return {between(p.p, q.p, t), p.opacity + t * (q.opacity - p.opacity)};
}

}  // namespace

std::size_t OpacityLevels::of(double opacity) const {
    return std::size_t(std::ranges::upper_bound(bounds, opacity) - bounds.begin());
}

OpacityLevels mask_levels(double cutoff) { return {{cutoff}, {0, 1}}; }

OpacityLevels blend_levels() {
    OpacityLevels levels;
    for (int k = 0; k <= steps; ++k) {
        levels.values.push_back(double(k) / steps);
        if (k < steps) levels.bounds.push_back((k + 0.5) / steps);
    }
    return levels;
}

void add_pieces(const std::array<OpacityCorner, 3>& triangle, const OpacityLevels& levels,
                std::vector<OpacityPiece>& pieces) {
    const auto [low, high] = std::ranges::minmax(triangle, {}, &OpacityCorner::opacity);
    const std::size_t first = levels.of(low.opacity), last = levels.of(high.opacity);
    for (std::size_t level = first; level <= last; ++level) {
        std::vector<OpacityCorner> part(triangle.begin(), triangle.end());
        if (level > first)
            part = clipped(
                part, [&](const auto& c) { return c.opacity - levels.bounds[level - 1]; },
                between_corners);
        if (level < last)
            part = clipped(
                part, [&](const auto& c) { return levels.bounds[level] - c.opacity; },
                between_corners);
        OpacityPiece piece{{}, level};
        for (const OpacityCorner& corner : part) piece.corners.push_back(corner.p);
        if (piece.corners.size() >= 3) pieces.push_back(std::move(piece));
    }
}

OpacityPlane::OpacityPlane(const Map& map) : map_(map), level_(map.texture->levels.front()) {}

dvec2 OpacityPlane::at_texcoord(const vec2& st) const {
    const dvec2 at = dvec2(st) * dvec2(map_.scale) + dvec2(map_.offset);
    return at * dvec2(level_.width, level_.height) - 0.5;
}

double OpacityPlane::texel(std::int64_t i, std::int64_t j) const {
    const std::int64_t x = wrapped(i, level_.width, map_.wrap_s),
                       y = wrapped(j, level_.height, map_.wrap_t);
    return level_.rgba[std::size_t(4 * (y * level_.width + x) + 3)] / 65535.0;
}

bool OpacityPlane::add_pieces(const std::array<dvec2, 3>& triangle, const Slope& factor,
                              const OpacityLevels& levels, std::size_t most,
                              std::vector<OpacityPiece>& pieces) const {
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const std::vector<dvec2> whole(triangle.begin(), triangle.end());
    const auto first = std::int64_t(std::floor(low)), last = std::int64_t(std::ceil(high));
    for (std::int64_t j = first; j < std::max(last, first + 1); ++j) {
        auto row = clipped(
            whole, [&](const dvec2& p) { return p.y - double(j); }, between);
        row = clipped(
            row, [&](const dvec2& p) { return double(j + 1) - p.y; }, between);
        if (row.empty()) continue;
        const auto [left, right] = std::ranges::minmax(row, {}, &dvec2::x);
        const auto begin = std::int64_t(std::floor(left.x)), end = std::int64_t(std::ceil(right.x));
        add_row(j, begin, std::max(end, begin + 1), factor, levels, pieces);
        if (pieces.size() > most) return false;
    }
    return true;
}

void OpacityPlane::add_row(std::int64_t j, std::int64_t first, std::int64_t last,
                           const Slope& factor, const OpacityLevels& levels,
                           std::vector<OpacityPiece>& pieces) const {
    const auto at = [&](std::int64_t x, std::int64_t y) {
        const dvec2 p{double(x), double(y)};
        return OpacityCorner{p, texel(x, y) * std::clamp(factor.at(p), 0.0, 1.0)};
    };
    const double bottom = double(j), top = double(j + 1);
    bool is_open = false;
    OpacityCorner left[2] = {at(first, j), at(first, j + 1)};
    for (std::int64_t i = first; i < last; ++i) {
        const OpacityCorner right[2] = {at(i + 1, j), at(i + 1, j + 1)};
        const std::size_t level = levels.of(left[0].opacity);
        const bool is_even = level == levels.of(left[1].opacity) &&
                             level == levels.of(right[0].opacity) &&
                             level == levels.of(right[1].opacity);
        const double x = double(i), next = double(i + 1);
        if (is_even && is_open && pieces.back().level == level) {
            pieces.back().corners[1].x = pieces.back().corners[2].x = next;
        } else if (is_even) {
            pieces.push_back({{{x, bottom}, {next, bottom}, {next, top}, {x, top}}, level});
        } else {
            const OpacityCorner middle{
                {x + 0.5, bottom + 0.5},
                (left[0].opacity + left[1].opacity + right[0].opacity + right[1].opacity) / 4};
            const OpacityCorner* const round[] = {&left[0], &right[0], &right[1], &left[1]};
            for (std::size_t k = 0; k < 4; ++k)
                scene::add_pieces({*round[k], *round[(k + 1) % 4], middle}, levels, pieces);
        }
        is_open = is_even;
        left[0] = right[0];
        left[1] = right[1];
    }
}

}  // namespace gw::scene
