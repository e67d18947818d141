// Texturing lane by lane: projective and wide coordinates, shadow comparison, textures of any size,
// wraps and levels beyond OpenGL 1.1. docs/manual.md, "Textures". Shares the integer filters of gw/stages/texels.h
// with the reference machine.
#include "gw/fast/raster/primitive.h"

#include "gw/base/arithmetic.h"
#include "gw/base/powers.h"
#include "gw/base/prefetch.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/texels.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/profile.h"
#include "gw/stages/tables.h"
#include "gw/stages/textures/layers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::fast {
namespace {

int level_coordinate(const TexturePlane& t, float uw, int log2_size) {
    constexpr float limit = 1073741824.0f;
    const auto scaled_u = static_cast<float>(times_power_of_two(uw, t.exponent + log2_size + 8));
    const float u = std::floor(std::clamp(scaled_u, -limit, limit));
    return static_cast<int>(u) + t.k * (1 << (log2_size + 8));
}

/// One pixel of the tile.
struct PixelSampler {
    const TexturePlanes& p;
    const TileDraw& draw;
    const TextureState& state;
    const ResolvedTexture& resolved;
    const FastTexels& fast;
    bool projective;
    int i, j;
    std::int32_t q, s, t, r;
    float w = 1;
    const Texels& texels = fast.texels;

    float over_q(std::int32_t u) const { return static_cast<float>(u) * w; }
    int position(const TexturePlane& of, std::int32_t u, int size, Wrap wrap) const {
        const bool wide = !projective && of.exponent > largest_exponent_in_float;
        if (texels.any_size || wrap == Wrap::MirroredRepeat)
            return any_position(wide ? double(u) / double(q) : double(over_q(u)), of.exponent, of.k,
                                size, wrap);
        const int log2_size = std::countr_zero(unsigned(size));
        if (wide) return wide_position(u, q, of.exponent, of.k, log2_size, wrap == Wrap::Repeat);
        return level_coordinate(of, over_q(u), log2_size);
    }
    int position_s(const TexelLevel& level) const {
        return position(p.s, s, level.width, state.wrap_s);
    }
    int position_t(const TexelLevel& level) const {
        return position(p.t, t, level.height, state.wrap_t);
    }

    Rgba grey(bool lit) const {
        const auto c = static_cast<std::uint16_t>(lit ? max_of_bits(texels.bits) : 0);
        return {c, c, c, c};
    }

    Addressing how() const { return addressing(state, texels, resolved.border_color); }
    int base_level() const { return level_range(state, int(texels.levels.size())).base; }

    bool is_lit() const {
        const TexelLevel& level = texels.levels[std::size_t(base_level())];
        const int bits = texels.depth_bits;
        const double scaled = times_power_of_two(over_q(r), p.r.exponent + bits);
        const auto incoming =
            static_cast<std::uint32_t>(to_integer(std::floor(scaled), 0, max_of_bits(bits)));
        return compare(state.compare_func, incoming,
                       stored_depth(level, position_s(level) >> 8, position_t(level) >> 8));
    }
    std::uint32_t stored_depth(const TexelLevel& level, int u, int v) const {
        const double border = state.border_color.x;
        if (!fast.frame) return nearest_depth(texels, level, how(), u, v, border);
        return nearest_depth(level, how(), u, v, texels.depth_bits, border, [&](int x, int y) {
            return fast.frame->depth_at(fast.frame->depth_place(x, y));
        });
    }

    float rho() const {
        const int dx = draw.tile.x + i - p.slope_x, dy = draw.tile.y + j - p.slope_y;
        const TexelLevel& base = texels.levels[std::size_t(base_level())];
        JoinedSlopes slopes{state.exact_rho};
        slopes.add(p.s.slope, dx, dy, times_power_of_two(base.width, p.s.exponent));
        slopes.add(p.t.slope, dx, dy, times_power_of_two(base.height, p.t.exponent));
        const float found = (static_cast<float>(slopes.value()) * (w * w)) * (1.0f / 65536);
        return std::min(std::max(found * resolved.rho_scale, resolved.least_rho),
                        resolved.greatest_rho);
    }

    Rgba sample(int index, bool linear) const {
        const TexelLevel& level = texels.levels[std::size_t(index)];
        return lookup(texels, level, linear, how(), position_s(level), position_t(level));
    }

    Rgba with_r() const {
        const auto at = [](const TexturePlane& of, std::int32_t u) {
            return PixelCoordinate{u, of.exponent, of.plane_slope};
        };
        return texel_with_r(texels, state, resolved,
                            {{at(p.s, s), at(p.t, t), at(p.r, r)},
                             q,
                             p.q_slope,
                             draw.tile.x + i - p.slope_x,
                             draw.tile.y + j - p.slope_y});
    }

    Rgba texel() {
        if (texels.with_r) return with_r();
        if (projective && q < 1) return grey(true);
        w = 1.0f / static_cast<float>(q);
        if (state.shadow_compare) return grey(is_lit());
        LevelChoice choice{.magnify = true, .level = base_level()};
        if (needs_rho(state)) choice = choose_level(state, rho(), int(texels.levels.size()));
        const Rgba first = sample(choice.level, is_linear(state, choice.magnify));
        if (choice.weight == 0) return first;
        return between_levels(first, sample(choice.next, is_linear(state, false)), choice.weight);
    }
};

Rgba lane_of(const ColorBlock& b, std::size_t i) {
    return {b.channel[0][i], b.channel[1][i], b.channel[2][i], b.channel[3][i]};
}

}  // namespace

void sample_by_pixel(const TexturePlanes& planes, const TexelValues& values, const TileDraw& draw,
                     std::size_t unit, const UnitOp& op, int bx, int by, std::uint32_t mask,
                     ColorBlock& out) {
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        PixelSampler pixel{planes,
                           draw,
                           texture_of(draw.op->state.state, unit),
                           draw.op->state.texture(unit),
                           *op.texels,
                           op.projective,
                           bx * block_side + lane % block_side,
                           by * block_side + lane / block_side,
                           values.q[lane],
                           values.s[lane],
                           values.t[lane],
                           values.r[lane]};
        const Rgba texel = pixel.texel();
        for (std::size_t c = 0; c < 4; ++c) out.channel[c][lane] = texel[c];
    }
}

namespace {

/// Fetches depths that a map has in different places of memory, all at once.
class DepthFetch {
public:
    DepthFetch(const FastTexels& from, const TexelLevel& level) : from_(from), level_(level) {}

    void begin(std::size_t lane, int i, int j) {
        if (!from_.frame) return void(texel_[lane] = level_.index(i, j));
        place_[lane] = from_.frame->depth_place(i, j);
        const Frame::DepthPlace& at = place_[lane];
        prefetch(&at.group->one_depth, 1);
        prefetch(&at.group->depth[at.in_group], 1);
        prefetch(&from_.frame->depth_planes(at), 1);
    }
    /// Of a uniform block only the one value or the one plane is needed.
    void find(std::size_t lane) {
        if (!from_.frame) return;
        const Frame::DepthPlace& at = place_[lane];
        if (at.group->one_plane >> at.in_group & 1)
            prefetch(&from_.frame->depth_planes(at)[at.group->depth[at.in_group]], 1);
        else if (!(at.group->one_depth >> at.in_group & 1))
            prefetch(&at.block->value[at.lane], 1);
    }
    std::uint32_t end(std::size_t lane) const {
        if (from_.frame) return from_.frame->depth_at(place_[lane]);
        return from_.texels.depths[texel_[lane]];
    }

private:
    const FastTexels& from_;
    const TexelLevel& level_;
    std::array<std::size_t, block_pixels> texel_;
    std::array<Frame::DepthPlace, block_pixels> place_;
};

std::uint32_t as_depth(float r, int bits) {
    if (!(r >= 1)) return 0;
    if (r >= static_cast<float>(power_of_two(bits))) return max_of_bits(bits);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(r));
}

}  // namespace

void compare_depths(const ComparedLanes& lanes, const TileDraw& draw, std::size_t unit,
                    const FastTexels& fast, std::uint32_t mask, ColorBlock& out) {
    const TextureState& state = texture_of(draw.op->state.state, unit);
    const Texels& texels = fast.texels;
    const int base = level_range(state, int(texels.levels.size())).base;
    const TexelLevel& level = texels.levels[std::size_t(base)];
    const Addressing how = addressing(state, texels, draw.op->state.texture(unit).border_color);
    DepthFetch fetch(fast, level);
    std::uint32_t inside = 0;
    for (std::uint32_t rest = mask & ~lanes.outside; rest != 0; rest &= rest - 1) {
        const auto lane = std::size_t(std::countr_zero(rest));
        const int i = wrap_index(how.wrap_s, lanes.i[lane], level.width),
                  j = wrap_index(how.wrap_t, lanes.j[lane], level.height);
        if (i < 0 || j < 0 || i >= level.width || j >= level.height) continue;
        fetch.begin(lane, i, j);
        inside |= 1u << lane;
    }
    for (std::uint32_t rest = inside; rest != 0; rest &= rest - 1)
        fetch.find(std::size_t(std::countr_zero(rest)));
    const std::uint32_t border = quantize(state.border_color.x, texels.depth_bits),
                        one = max_of_bits(texels.bits);
    for (std::uint32_t rest = mask; rest != 0; rest &= rest - 1) {
        const auto lane = std::size_t(std::countr_zero(rest));
        const auto passes = [&] {
            const std::uint32_t stored = (inside >> lane & 1) != 0 ? fetch.end(lane) : border;
            return compare(state.compare_func, as_depth(lanes.r[lane], texels.depth_bits), stored);
        };
        const bool lit = (lanes.outside >> lane & 1) != 0 || passes();
        for (auto& channel : out.channel) channel[lane] = static_cast<std::uint16_t>(lit ? one : 0);
    }
}

void apply_units(const TileDraw& draw, const ColorBlock& color, const TexelBlocks& texels,
                 ColorBlock& out) {
    const DrawOp& op = *draw.op;
    for (std::size_t i = 0; i < block_pixels; ++i) {
        UnitTexels at;
        for (std::size_t unit = 0; unit < max_texture_units; ++unit)
            if (const FastTexels* const of = (*op.units)[unit].texels)
                at.set(unit, of->texels.format, lane_of(texels[unit], i));
        const Rgba primary = lane_of(color, i);
        Rgba shaded = primary;
        for (std::size_t unit = 0; unit < max_texture_units; ++unit)
            if (at.has(unit))
                shaded = unit_environment(texture_of(op.state.state, unit), at, unit, primary,
                                          shaded, op.state.texture(unit).env_color, op.state.bits);
        for (std::size_t c = 0; c < 4; ++c) out.channel[c][i] = shaded[c];
    }
}

}  // namespace gw::fast
