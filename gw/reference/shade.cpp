// [GL11] 3.8 to 3.10: texture, then fog; between them the colour sum of OpenGL 1.2.
#include "gw/reference/shade.h"

#include "gw/reference/texture_unit.h"
#include "gw/stages/area.h"
#include "gw/stages/fog.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::reference {
namespace {

std::uint32_t fog_factor_at(const Shader& s, int x, int y) {
    const Interpolants& v = s.values;
    const Resolved& r = s.context.state;
    if (!r.fragment_fog) return static_cast<std::uint32_t>(v.fog.at(x, y));
    if (fog_is_direct(r.state.fog, true)) {
        const double u = v.fog_coordinate.at(x, y, reciprocal(v.q, x, y));
        return direct_fog_factor(r.state.fog, v.fog_coordinate.offset, u, v.fog_coordinate.exponent,
                                 r.bits);
    }
    // Table position in 1/256 steps.
    const std::vector<std::uint32_t>& table = s.context.fog_table;
    const int log2_steps = fog_table_log2(r.bits), steps = 1 << log2_steps;
    const float t = std::ldexp(v.fog_coordinate.at(x, y, reciprocal(v.q, x, y)),
                               v.fog_coordinate.exponent + log2_steps + 8);
    const int position = static_cast<int>(std::min(t, float(steps * 256)));
    const std::size_t i = std::size_t(position >> 8);
    if (int(i) >= steps) return table.back();
    const std::int32_t a = std::int32_t(table[i]), b = std::int32_t(table[i + 1]);
    return static_cast<std::uint32_t>(a + (((b - a) * (position & 255) + 128) >> 8));
}

/// Tells the observer what the pixel's units compare.
void tell_comparisons(const Shader& s, int x, int y) {
    Observer* const observer = s.context.target.observer;
    if (!observer) return;
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (const Texels* const of = s.context.texels[unit])
            if (const auto c = comparison_at(s.values, unit, *of, s.context.state, x, y))
                observer->comparison(x, y, s.primitive, *c);
}

/// All units' texels, then their environments in the order of the units.
Rgba textured_color(const Shader& s, const Rgba& primary, int x, int y) {
    const Resolved& r = s.context.state;
    UnitTexels texels;
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (const Texels* const of = s.context.texels[unit])
            texels.set(unit, of->format, texel_at(s.values, unit, *of, r, x, y));
    Rgba color = primary;
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (texels.has(unit))
            color = unit_environment(texture_of(r.state, unit), texels, unit, primary, color,
                                     r.texture(unit).env_color, r.bits);
    return color;
}

Rgba shaded_color(const Shader& s, int x, int y) {
    const Resolved& r = s.context.state;
    Rgba color = color_at(s.values, s.values.color, x, y, r.bits);
    if (r.state.color_source == ColorSource::PolygonId) return color;  // identifiers are exact
    tell_comparisons(s, x, y);
    color = textured_color(s, color, x, y);
    if (sums_colors(r.state))
        color = sum_of_colors(color, color_at(s.values, s.values.secondary, x, y, r.bits), r.bits);
    if (r.state.fog.enable) color = apply_fog(color, fog_factor_at(s, x, y), r.fog_color, r.bits);
    return color;
}

}  // namespace

std::uint32_t Shader::depth_of(const PlaneEquation& plane, int x, int y) const {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(
        plane.at(x, y) + depth_offset, 0, max_of_bits(context.profile->depth_bits)));
}

void Shader::pixel(int x, int y, std::uint32_t coverage) const {
    const std::uint32_t depth = depth_of(values.depth, x, y);
    Rgba color = shaded_color(*this, x, y);
    if (coverage != 0) color[3] = covered_alpha(color[3], coverage, context.profile->coverage_bits);
    process_fragment(context.state, context.target,
                     {x, y, color, depth, front, primitive, coverage});
}

void Shader::outside_pixel(int x, int y, std::uint32_t coverage) const {
    Shader limited = *this;
    limited.values = limited_to_pixel(values, x, y);
    limited.pixel(x, y, coverage);
}

void Shader::samples(int x, int y, SampleMask mask, bool covered) const {
    const auto shift = [&](int k) {
        return sample_shift(context.state.samples, k, context.profile->subpixel_bits);
    };
    Shader one = *this;
    if (!covered) one.values = moved(values, shift(std::countr_zero(mask)));
    Covered samples{mask, {}};
    for (int k = 0; k < context.state.samples; ++k)
        if (mask >> k & 1)
            samples.depth[std::size_t(k)] = depth_of(moved(values.depth, shift(k)), x, y);
    process_fragment(context.state, context.target,
                     {x, y, shaded_color(one, x, y), 0, front, primitive}, samples);
}

}  // namespace gw::reference
