#include "gw/reference/texture_unit.h"

#include <algorithm>
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

    int at(const PerspectiveValue& value, int log2_size, Wrap wrap) const {
        const bool repeats = wrap == Wrap::Repeat;
        if (!values.projective && value.exponent > largest_exponent_in_float)
            return wide_position(value.plane.at(x, y), values.texture_q.at(x, y), value.exponent,
                                 repeats ? 0 : static_cast<std::int64_t>(value.offset), log2_size,
                                 repeats);
        return level_coordinate(value, value.at(x, y, w), log2_size, wrap);
    }
};

/// GL's rho = max(m_u, m_v) in texels of level 0 per pixel.
float rho_at(const Interpolants& v, const TexelLevel& base, float w, int x, int y) {
    const int dx = x - v.slope_x, dy = y - v.slope_y;
    const double s = std::ldexp(v.s.slope.at(dx, dy), v.s.exponent + base.log2_width);
    const double t = std::ldexp(v.t.slope.at(dx, dy), v.t.exponent + base.log2_height);
    return (static_cast<float>(std::max(s, t)) * (w * w)) * (1.0f / 65536);
}

Rgba grey(std::uint32_t v) {
    const auto c = static_cast<std::uint16_t>(v);
    return {c, c, c, c};
}

/// Whether r <= the depth of the nearest texel.
bool is_lit(const Coordinates& at, const Texels& texels, const TextureState& s, int depth_bits) {
    const Interpolants& v = at.values;
    const TexelLevel& level = texels.levels[0];
    const int i = at.at(v.s, level.log2_width, s.wrap_s) >> 8;
    const int j = at.at(v.t, level.log2_height, s.wrap_t) >> 8;
    const double r = std::ldexp(double(v.r.at(at.x, at.y, at.w)), v.r.exponent + depth_bits);
    const auto incoming = to_integer(std::floor(r), 0, max_of_bits(depth_bits));
    const auto index =
        wrap_index(s.wrap_t, j, level.height) * level.width + wrap_index(s.wrap_s, i, level.width);
    return incoming <= texels.depths[std::size_t(index)];
}

}  // namespace

Rgba texel_at(const Interpolants& v, const Texels& texels, const Resolved& r, int depth_bits, int x,
              int y) {
    const TextureState& s = r.state.texture;
    const std::uint32_t one = max_of_bits(texels.bits);
    if (v.projective && v.texture_q.at(x, y) < 1) return grey(one);
    const float w = reciprocal(v.texture_q, x, y);
    const Coordinates at{v, x, y, w};
    if (s.shadow_compare) return grey(is_lit(at, texels, s, depth_bits) ? one : 0);

    LevelChoice choice{.magnify = true};
    if (needs_rho(s))
        choice = choose_level(s, rho_at(v, texels.levels[0], w, x, y), int(texels.levels.size()));

    const auto sample = [&](int index) {
        const TexelLevel& level = texels.levels[std::size_t(index)];
        return lookup(texels, level, is_linear(s, choice.magnify),
                      addressing(s, texels, r.border_color), at.at(v.s, level.log2_width, s.wrap_s),
                      at.at(v.t, level.log2_height, s.wrap_t));
    };
    if (choice.weight == 0) return sample(choice.level);
    return between_levels(sample(choice.level), sample(choice.next), choice.weight);
}

}  // namespace gw::reference
