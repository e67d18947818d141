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

/// Divides the rectangle of cells around a triangle into squares, until they have one level or are one
/// cell.
class BlockDivider {
public:
    BlockDivider(const OpacityPlane& plane, const std::array<dvec2, 3>& triangle,
                 const Slope& factor, const OpacityLevels& levels, std::size_t most,
                 std::vector<OpacityPiece>& pieces)
        : plane_(plane),
          triangle_(triangle),
          factor_(factor),
          levels_(levels),
          most_(most),
          pieces_(pieces) {
        for (int k = 0; k < 2; ++k) {
            const auto [low, high] = std::minmax({triangle[0][k], triangle[1][k], triangle[2][k]});
            low_[k] = std::int64_t(std::floor(low));
            high_[k] = std::max(std::int64_t(std::ceil(high)), low_[k] + 1);
        }
        for (std::int64_t y = low_.y; y <= high_.y; ++y)
            for (std::int64_t x = low_.x; x <= high_.x; ++x)
                at_.push_back(std::uint8_t(levels.of(corner(x, y).opacity)));
    }

    bool divide() {
        const auto begin = [](std::int64_t v) { return v - (v % largest + largest) % largest; };
        for (std::int64_t y = begin(low_.y); y < high_.y; y += largest)
            for (std::int64_t x = begin(low_.x); x < high_.x; x += largest)
                if (!add_block(x, y, largest)) return false;
        return true;
    }

private:
    using Cell = glm::vec<2, std::int64_t>;
    static constexpr std::int64_t largest = 64;

    OpacityCorner corner(std::int64_t x, std::int64_t y) const {
        const dvec2 p{double(x), double(y)};
        return {p, plane_.texel(x, y) * std::clamp(factor_.at(p), 0.0, 1.0)};
    }
    std::uint8_t level_at(std::int64_t x, std::int64_t y) const {
        return at_[std::size_t((y - low_.y) * (high_.x - low_.x + 1) + x - low_.x)];
    }

    bool add_block(std::int64_t x, std::int64_t y, std::int64_t size) {
        const Cell low{std::max(x, low_.x), std::max(y, low_.y)},
            high{std::min(x + size, high_.x), std::min(y + size, high_.y)};
        if (low.x >= high.x || low.y >= high.y || is_outside(low, high)) return true;
        if (is_even(low, high)) {
            const double a = double(low.x), b = double(low.y), c = double(high.x),
                         d = double(high.y);
            pieces_.push_back({{{a, b}, {c, b}, {c, d}, {a, d}}, level_at(low.x, low.y)});
        } else if (size == 1) {
            add_cell(x, y);
        } else {
            const std::int64_t half = size / 2;
            for (const std::int64_t v : {y, y + half})
                for (const std::int64_t u : {x, x + half})
                    if (!add_block(u, v, half)) return false;
        }
        return pieces_.size() <= most_;
    }

    bool is_even(const Cell& low, const Cell& high) const {
        const std::uint8_t level = level_at(low.x, low.y);
        for (std::int64_t y = low.y; y <= high.y; ++y)
            for (std::int64_t x = low.x; x <= high.x; ++x)
                if (level_at(x, y) != level) return false;
        return true;
    }

    /// Whether a side of the triangle has all of it on its other side.
    bool is_outside(const Cell& low, const Cell& high) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec2 &a = triangle_[k], &b = triangle_[(k + 1) % 3], &c = triangle_[(k + 2) % 3];
            const dvec2 n{a.y - b.y, b.x - a.x};
            const double inner = n.x * (c.x - a.x) + n.y * (c.y - a.y), sign = inner > 0 ? 1 : -1;
            const double x = double(sign * n.x > 0 ? high.x : low.x),
                         y = double(sign * n.y > 0 ? high.y : low.y);
            if (sign * (n.x * (x - a.x) + n.y * (y - a.y)) < -1e-9 * std::abs(inner)) return true;
        }
        return false;
    }

    void add_cell(std::int64_t x, std::int64_t y) {
        const std::array<OpacityCorner, 4> round{corner(x, y), corner(x + 1, y),
                                                 corner(x + 1, y + 1), corner(x, y + 1)};
        OpacityCorner middle{{double(x) + 0.5, double(y) + 0.5}, 0};
        for (const OpacityCorner& c : round) middle.opacity += c.opacity / 4;
        for (std::size_t k = 0; k < 4; ++k)
            add_pieces({round[k], round[(k + 1) % 4], middle}, levels_, pieces_);
    }

    const OpacityPlane& plane_;
    const std::array<dvec2, 3>& triangle_;
    const Slope& factor_;
    const OpacityLevels& levels_;
    std::size_t most_;
    std::vector<OpacityPiece>& pieces_;
    Cell low_{0}, high_{0};         ///< of the rectangle, in cells
    std::vector<std::uint8_t> at_;  ///< levels at the corners of its cells, row by row
};

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
    return BlockDivider(*this, triangle, factor, levels, most, pieces).divide();
}

}  // namespace gw::scene
