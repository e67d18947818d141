// [GL11] 3.6.4 and 3.7: rectangles of pixels and bitmaps, zoomed.
#include "gw/stages/pixels/draw_pixels.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/fog.h"
#include "gw/stages/tables.h"
#include "gw/stages/textures/layers.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

/// The first pixel whose centre is not before the edge in front of row or column n.
int pixel_at_edge(double start, double zoom, int n) {
    constexpr double far_away = 1 << 20;
    return int(to_integer(std::ceil((start + zoom * n) - 0.5), -far_away, far_away));
}

/// The run of pixels that the columns (or rows) of a rectangle cover, and the column of each.
struct Zoomed {
    int first = 0;
    std::vector<int> source;
};
Zoomed zoomed(double start, double zoom, int count, int box_first, int box_size) {
    const auto edge = [&](int n) {
        return std::clamp(pixel_at_edge(start, zoom, n), box_first, box_first + box_size);
    };
    Zoomed z{std::min(edge(0), edge(count)), {}};
    for (int i = 0; i < count; ++i) {
        const int n = zoom >= 0 ? i : count - 1 - i;
        z.source.insert(z.source.end(), std::size_t(std::abs(edge(n + 1) - edge(n))), n);
    }
    return z;
}

/// A coordinate in 1/256 texel of a level.
int texel_position(double coordinate, int size) {
    constexpr double largest = 1 << 30;
    return int(to_integer(std::floor(coordinate * (256.0 * size)), -largest, largest));
}

Rgba grey_texel(std::uint32_t v) {
    const auto c = static_cast<std::uint16_t>(v);
    return {c, c, c, c};
}

/// The one texel of a rectangle. Its coordinates do not change, so the filter magnifies.
Rgba raster_texel(const vec4& strq, const Texels& texels, const TextureState& s,
                  const ResolvedTexture& r) {
    if (texels.with_r) return texel_in_place(texels, s, r, strq);
    const std::uint32_t one = max_of_bits(texels.bits);
    const double q = strq.w;
    if (q <= 0) return grey_texel(one);
    const int base = level_range(s, int(texels.levels.size())).base;
    const TexelLevel& level = texels.levels[std::size_t(base)];
    const int u = texel_position(strq.x / q, level.width),
              v = texel_position(strq.y / q, level.height);
    const Addressing how = addressing(s, texels, r.border_color);
    if (!s.shadow_compare) return lookup(texels, level, is_linear(s, true), how, u, v);
    const int bits = texels.depth_bits;
    const auto incoming = static_cast<std::uint32_t>(
        to_integer(std::floor(std::ldexp(strq.z / q, bits)), 0, max_of_bits(bits)));
    const std::uint32_t stored =
        nearest_depth(texels, level, how, u >> 8, v >> 8, s.border_color.x);
    return grey_texel(compare(s.compare_func, incoming, stored) ? one : 0);
}

}  // namespace

PlacedPixels::PlacedPixels(const DrawPixels& pixels, const Resolved& state,
                           const BoundTexels& texels)
    : pixels_(&pixels), state_(&state) {
    const RasterPosition& raster = pixels.raster;
    const Rect& box = state.pixel_box;
    Zoomed columns = zoomed(raster.x, pixels.zoom_x, pixels.width, box.x, box.width),
           rows = zoomed(raster.y, pixels.zoom_y, pixels.height, box.y, box.height);
    box_ = {columns.first, rows.first, int(columns.source.size()), int(rows.source.size())};
    columns_ = std::move(columns.source);
    rows_ = std::move(rows.source);
    for (std::size_t unit = 0; unit < texels.size(); ++unit) {
        if (!texels[unit]) continue;
        const TextureState& s = texture_of(state.state, unit);
        const vec4& strq = unit == 0 ? raster.texcoord : raster.more_texcoords[unit - 1];
        texels_.set(unit, texels[unit]->format,
                    raster_texel(strq, *texels[unit], s, state.texture(unit)));
        look_ups_ += gw::look_ups(s.min_filter, texels[unit]->dimensions);
    }
    const FogState& fog = state.state.fog;
    if (fog.enable)
        fog_factor_ = fog_factor(
            fog,
            bounded(fog.source == FogSource::Coordinate ? raster.fog_coordinate : raster.distance,
                    largest_coordinate),
            state.bits);
    is_plain_ = texels_.on == 0 && !sums_colors(state.state) && !state.state.fog.enable;
    raster_color_ = shaded(raster.color);
}

Rgba PlacedPixels::shaded(const Rgba& color) const {
    const State& s = state_->state;
    Rgba out = color;
    for (std::size_t unit = 0; texels_.on >> unit != 0; ++unit)
        if (texels_.has(unit))
            out = unit_environment(texture_of(s, unit), texels_, unit, color, out,
                                   state_->texture(unit).env_color, state_->bits);
    if (sums_colors(s)) out = sum_of_colors(out, pixels_->raster.secondary_color, state_->bits);
    return s.fog.enable ? apply_fog(out, fog_factor_, state_->fog_color, state_->bits) : out;
}

Rect source_box(const DrawPixels& command, int width, int height) {
    return intersect({command.source->x, command.source->y, command.width, command.height},
                     {0, 0, width, height});
}

DrawPixels with_values(const DrawPixels& command, ReadBuffer buffer, const Planes& planes) {
    DrawPixels out = command;
    const std::vector<Rgba>& colors = buffer == ReadBuffer::Front ? planes.color : planes.back;
    const PixelSource from = *command.source;
    const Rect box = source_box(command, planes.width, planes.height);
    out.source.reset();
    out.bits.assign(out.bit_row() * std::size_t(out.height), 0);
    if (from.plane == Plane::Color) out.colors.resize(out.area());
    if (from.plane == Plane::Depth) out.depths.resize(out.area());
    if (from.plane == Plane::Stencil) out.stencils.resize(out.area());
    for (int y = box.y; y < box.y + box.height; ++y) {
        const std::size_t first = planes.index(box.x, y),
                          to = pixel_index(box.x - from.x, y - from.y, out.width);
        const auto copy = [&](const auto& values, auto& row) {
            std::copy_n(values.begin() + std::ptrdiff_t(first), box.width,
                        row.begin() + std::ptrdiff_t(to));
        };
        if (from.plane == Plane::Color) copy(colors, out.colors);
        if (from.plane == Plane::Depth) copy(planes.depth, out.depths);
        if (from.plane == Plane::Stencil) copy(planes.stencil, out.stencils);
        const std::size_t row = std::size_t(y - from.y) * out.bit_row();
        for (int x = box.x - from.x; x < box.x - from.x + box.width; ++x) {
            const std::size_t byte = row + std::size_t(x) / 8;
            const unsigned bit = 128u >> x % 8;
            if (command.bits.empty() || command.bits[byte] & bit)
                out.bits[byte] = static_cast<std::uint8_t>(out.bits[byte] | bit);
        }
    }
    return out;
}

}  // namespace gw
