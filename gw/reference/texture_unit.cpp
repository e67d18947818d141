#include "gw/reference/texture_unit.h"

#include "gw/stages/tables.h"
#include "gw/stages/textures/layers.h"

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
    const TextureValues& values;
    int x, y;
    float w;
    bool any_size;

    int at(const PerspectiveValue& value, int size, Wrap wrap) const {
        const bool wide = !values.projective && value.exponent > largest_exponent_in_float;
        const std::int64_t u = value.plane.at(x, y), q = values.q.at(x, y),
                           k = added_part(value.offset, wrap);
        if (any_size || wrap == Wrap::MirroredRepeat)
            return any_position(wide ? double(u) / double(q) : double(value.at(x, y, w)),
                                value.exponent, k, size, wrap);
        const int log2_size = std::countr_zero(unsigned(size));
        if (wide) return wide_position(u, q, value.exponent, k, log2_size, wrap == Wrap::Repeat);
        return level_coordinate(value, value.at(x, y, w), log2_size, wrap);
    }
};

/// GL's rho in texels of the base level per pixel, with bias and limits.
float rho_at(const TextureValues& v, const TexelLevel& base, const TextureState& state,
             const ResolvedTexture& r, float w, int dx, int dy) {
    JoinedSlopes slopes{state.exact_rho};
    slopes.add(v.s.slope, dx, dy, std::ldexp(double(base.width), v.s.exponent));
    slopes.add(v.t.slope, dx, dy, std::ldexp(double(base.height), v.t.exponent));
    const float rho = (static_cast<float>(slopes.value()) * (w * w)) * (1.0f / 65536);
    return std::min(std::max(rho * r.rho_scale, r.least_rho), r.greatest_rho);
}

Rgba grey(std::uint32_t v) {
    const auto c = static_cast<std::uint16_t>(v);
    return {c, c, c, c};
}

/// r and the depth of the nearest texel.
DepthComparison compared(const Coordinates& at, const Texels& texels, const TexelLevel& level,
                         const TextureState& s, const ResolvedTexture& r) {
    const TextureValues& v = at.values;
    const int bits = texels.depth_bits;
    const Addressing how = addressing(s, texels, r.border_color);
    const double depth = std::ldexp(double(v.r.at(at.x, at.y, at.w)), v.r.exponent + bits);
    DepthComparison out;
    out.i = wrap_index(how.wrap_s, at.at(v.s, level.width, s.wrap_s) >> 8, level.width);
    out.j = wrap_index(how.wrap_t, at.at(v.t, level.height, s.wrap_t) >> 8, level.height);
    out.r = static_cast<std::uint32_t>(to_integer(std::floor(depth), 0, max_of_bits(bits)));
    out.stored = nearest_depth(texels, level, how, out.i, out.j, s.border_color.x);
    out.passes = compare(s.compare_func, out.r, out.stored);
    return out;
}

PixelCoordinates coordinates_with_r(const TextureValues& v, int x, int y, int dx, int dy) {
    const auto at = [&](const PerspectiveValue& c) {
        return PixelCoordinate{c.plane.at(x, y), c.exponent, c.plane_slope};
    };
    return {{at(v.s), at(v.t), at(v.r)}, v.q.at(x, y), v.q_slope, dx, dy};
}

/// Whether (s, t, r, q) has no quotient: q is not positive.
bool is_without_quotient(const TextureValues& v, int x, int y) {
    return v.projective && v.q.at(x, y) < 1;
}

}  // namespace

std::optional<DepthComparison> comparison_at(const Interpolants& values, std::size_t unit,
                                             const Texels& texels, const Resolved& resolved, int x,
                                             int y) {
    const TextureValues& v = values.textures[unit];
    const TextureState& s = texture_of(resolved.state, unit);
    if (!s.shadow_compare || texels.with_r || is_without_quotient(v, x, y)) return std::nullopt;
    const Coordinates at{v, x, y, reciprocal(v.q, x, y), texels.any_size};
    const int base = level_range(s, int(texels.levels.size())).base;
    DepthComparison out =
        compared(at, texels, texels.levels[std::size_t(base)], s, resolved.texture(unit));
    out.unit = unit;
    return out;
}

Rgba texel_at(const Interpolants& values, std::size_t unit, const Texels& texels,
              const Resolved& resolved, int x, int y) {
    const TextureValues& v = values.textures[unit];
    const TextureState& s = texture_of(resolved.state, unit);
    const ResolvedTexture& r = resolved.texture(unit);
    const int dx = x - values.slope_x, dy = y - values.slope_y;
    if (texels.with_r) return texel_with_r(texels, s, r, coordinates_with_r(v, x, y, dx, dy));
    const std::uint32_t one = max_of_bits(texels.bits);
    if (const auto c = comparison_at(values, unit, texels, resolved, x, y))
        return grey(c->passes ? one : 0);
    if (is_without_quotient(v, x, y)) return grey(one);
    const float w = reciprocal(v.q, x, y);
    const Coordinates at{v, x, y, w, texels.any_size};
    const int base = level_range(s, int(texels.levels.size())).base;
    const TexelLevel& first = texels.levels[std::size_t(base)];
    LevelChoice choice{.magnify = true, .level = base};
    if (needs_rho(s))
        choice = choose_level(s, rho_at(v, first, s, r, w, dx, dy), int(texels.levels.size()));

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
