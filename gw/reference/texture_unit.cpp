#include "gw/reference/texture_unit.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::reference {
// Scaling by powers of two is exact.
int level_coordinate(const PerspectiveValue& value, float uw, int log2_size, Wrap wrap) {
    constexpr float largest_coordinate = 1073741824.0f;  // 2^30 units of 1/256 texel
    const float scaled = std::ldexp(uw, value.exponent + log2_size + 8);
    const float u = std::floor(std::clamp(scaled, -largest_coordinate, largest_coordinate));
    const int k = wrap == Wrap::Repeat ? 0 : static_cast<int>(value.offset) << (log2_size + 8);
    return static_cast<int>(u) + k;
}

namespace {

/// One pixel's texel positions.
struct Coordinates {
    const Interpolants& values;
    int x, y;
    float w;
    bool any_size;

    int at(const PerspectiveValue& value, int size, Wrap wrap) const {
        const bool wide = !values.projective && value.exponent > largest_exponent_in_float;
        const std::int64_t u = value.plane.at(x, y), q = values.texture_q.at(x, y),
                           k = added_part(value.offset, wrap);
        if (any_size || wrap == Wrap::MirroredRepeat)
            return any_position(wide ? double(u) / double(q) : double(value.at(x, y, w)),
                                value.exponent, k, size, wrap);
        const int log2_size = std::countr_zero(unsigned(size));
        if (wide) return wide_position(u, q, value.exponent, k, log2_size, wrap == Wrap::Repeat);
        return level_coordinate(value, value.at(x, y, w), log2_size, wrap);
    }
};

/// GL's rho = max(m_u, m_v) in texels of the base level per pixel, with bias and limits.
float rho_at(const Interpolants& v, const TexelLevel& base, const Resolved& r, float w, int x,
             int y) {
    const int dx = x - v.slope_x, dy = y - v.slope_y;
    const double s = std::ldexp(v.s.slope.at(dx, dy), v.s.exponent) * base.width;
    const double t = std::ldexp(v.t.slope.at(dx, dy), v.t.exponent) * base.height;
    const float rho = (static_cast<float>(std::max(s, t)) * (w * w)) * (1.0f / 65536);
    return std::min(std::max(rho * r.rho_scale, r.least_rho), r.greatest_rho);
}

Rgba grey(std::uint32_t v) {
    const auto c = static_cast<std::uint16_t>(v);
    return {c, c, c, c};
}

/// Whether r <= the depth of the nearest texel.
bool is_lit(const Coordinates& at, const Texels& texels, const TexelLevel& level, const Resolved& r,
            int depth_bits) {
    const Interpolants& v = at.values;
    const TextureState& s = r.state.texture;
    const int i = at.at(v.s, level.width, s.wrap_s) >> 8;
    const int j = at.at(v.t, level.height, s.wrap_t) >> 8;
    const double depth = std::ldexp(double(v.r.at(at.x, at.y, at.w)), v.r.exponent + depth_bits);
    return to_integer(std::floor(depth), 0, max_of_bits(depth_bits)) <=
           nearest_depth(texels, level, addressing(s, texels, r.border_color), i, j,
                         r.border_depth);
}

}  // namespace

Rgba texel_at(const Interpolants& v, const Texels& texels, const Resolved& r, int depth_bits, int x,
              int y) {
    const TextureState& s = r.state.texture;
    const std::uint32_t one = max_of_bits(texels.bits);
    if (v.projective && v.texture_q.at(x, y) < 1) return grey(one);
    const float w = reciprocal(v.texture_q, x, y);
    const Coordinates at{v, x, y, w, texels.any_size};
    const int base = level_range(s, int(texels.levels.size())).base;
    const TexelLevel& first = texels.levels[std::size_t(base)];
    if (s.shadow_compare) return grey(is_lit(at, texels, first, r, depth_bits) ? one : 0);

    LevelChoice choice{.magnify = true, .level = base};
    if (needs_rho(s))
        choice = choose_level(s, rho_at(v, first, r, w, x, y), int(texels.levels.size()));

    const auto sample = [&](int index) {
        const TexelLevel& level = texels.levels[std::size_t(index)];
        return lookup(texels, level, is_linear(s, choice.magnify),
                      addressing(s, texels, r.border_color), at.at(v.s, level.width, s.wrap_s),
                      at.at(v.t, level.height, s.wrap_t));
    };
    if (choice.weight == 0) return sample(choice.level);
    return between_levels(sample(choice.level), sample(choice.next), choice.weight);
}

}  // namespace gw::reference
