#include "inspect/recording/file_values.h"

#include <algorithm>

namespace gw::inspect {

Profile from_file(const gwt::Profile& p) {
    return {.color_bits = p.color_bits(),
            .depth_bits = p.depth_bits(),
            .stencil_bits = p.stencil_bits(),
            .accum_bits = p.accum_bits(),
            .subpixel_bits = p.subpixel_bits(),
            .lit_bits = p.lit_bits(),
            .max_lights = p.max_lights(),
            .texel_bits = p.texel_bits(),
            .coverage_bits = p.coverage_bits(),
            .color_planes = p.color_planes(),
            .fragment_fog = p.fragment_fog(),
            .perspective_color = p.perspective_color(),
            .extensions = {p.polygon_offset(),   p.shadow_texture(),
                           p.stencil_wrap(),     p.two_sided_stencil(),
                           p.texture_border(),   p.texture_formats(),
                           p.stipple(),          p.two_sided_polygon_mode(),
                           p.logic_op(),         p.blend_color(),
                           p.blend_minmax(),     p.blend_subtract(),
                           p.draw_pixels(),      p.blend_separate(),
                           p.blend_square(),     p.texture_sizes(),
                           p.texture_wraps(),    p.texture_lod(),
                           p.texture_combine(),  p.texture_srgb(),
                           p.secondary_color(),  p.fog_coordinate(),
                           p.occlusion_query(),  p.clip_control(),
                           p.texture_units(),    p.texture_depth(),
                           p.texture_cube(),     p.texture_seamless(),
                           p.texture_3d(),       p.surfaces(),
                           p.point_parameters(), p.point_sprite(),
                           p.multisample()}};
}

TextureRef given_texture(const gwt::Texture& t, const std::string& name,
                         const std::vector<std::uint8_t>& texels8,
                         const std::vector<std::uint16_t>& texels16) {
    constexpr int most_levels = 14;  // of 8192 texels
    if (t.level_count() < 1 || t.level_count() > most_levels)
        throw Error(fmt::format("{} levels; expected 1 to {}", t.level_count(), most_levels));
    for (const int side : {t.width(), t.height()})
        if (side < 1 || side > max_texture_side)
            throw Error(fmt::format("{} x {} texels; expected sides of 1 to {}", t.width(),
                                    t.height(), max_texture_side));
    Texture texture{.name = name,
                    .format = our_enum<TextureFormat>(t.format()),
                    .dimensions = t.dimensions(),
                    .border = t.border(),
                    .srgb = t.srgb(),
                    .cube = t.cube(),
                    .depths = t.depths()};
    const int most_layers = texture.dimensions == 3 ? max_volume_side : 1;
    if (t.layers() < 1 || t.layers() > most_layers)
        throw Error(fmt::format("{} layers; expected 1 to {}", t.layers(), most_layers));
    const std::size_t values = texels8.empty() ? texels16.size() : texels8.size();
    std::size_t next = 0;
    for (int i = 0; i < t.level_count(); ++i) {
        TextureLevel level{std::max(1, t.width() >> i),
                           std::max(1, t.height() >> i),
                           {},
                           t.cube() ? 6 : std::max(1, t.layers() >> i)};
        const std::size_t more = t.border() ? 2 : 0;
        const std::size_t size = 4 * (std::size_t(level.width) + more) *
                                 (std::size_t(level.height) + (t.dimensions() == 1 ? 0 : more)) *
                                 std::size_t(level.layers);
        if (size > values - next)
            throw Error(fmt::format("level {} of {} values; {} are left", i, size, values - next));
        std::vector<std::uint16_t>& rgba = level.rgba.edit();
        for (const std::size_t end = next + size; next < end; ++next)
            rgba.push_back(texels8.empty() ? texels16[next]
                                           : static_cast<std::uint16_t>(257 * texels8[next]));
        texture.levels.push_back(std::move(level));
    }
    if (next < values)
        throw Error(
            fmt::format("{} values of {} levels; expected {}", values, t.level_count(), next));
    return make_texture(std::move(texture));
}

bool needs_version_2(const Profile& p) {
    Extensions of_version_1;
    of_version_1.polygon_offset = p.extensions.polygon_offset;
    of_version_1.shadow_texture = p.extensions.shadow_texture;
    of_version_1.stencil_wrap = p.extensions.stencil_wrap;
    of_version_1.two_sided_stencil = p.extensions.two_sided_stencil;
    return p.extensions != of_version_1 || p.texel_bits != 0 || p.coverage_bits != 0 ||
           p.color_planes != 1;
}

flatbuffers::Offset<gwt::ColorMap> to_file(flatbuffers::FlatBufferBuilder& out,
                                           const ColorMap& map) {
    return gwt::CreateColorMapDirect(out, file_enum<gwt::IndexPlanes>(map.planes),
                                     std::uint8_t(map.bits), std::uint8_t(map.bits_in_r),
                                     &map.entries);
}

ColorMap from_file(const gwt::ColorMap& stored) {
    ColorMap map{.planes = our_enum<IndexPlanes>(stored.planes()),
                 .bits = stored.bits(),
                 .bits_in_r = stored.bits_in_r()};
    if (stored.entries()) map.entries.assign(stored.entries()->begin(), stored.entries()->end());
    check_color_map(map);
    return map;
}

}  // namespace gw::inspect
