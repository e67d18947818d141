#include "gw/profile.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <iterator>

namespace gw {

Profile vgx() { return {}; }

Profile reality() {
    Profile p{
        .name = "reality", .color_bits = 12, .depth_bits = 32, .accum_bits = 24, .lit_bits = 12};
    p.fragment_fog = true;
    p.extensions = {.polygon_offset = true, .shadow_texture = true};
    return p;
}

Profile ideal() {
    Profile p{.name = "ideal",
              .color_bits = 16,
              .depth_bits = 32,
              .accum_bits = 32,
              .subpixel_bits = 8,
              .lit_bits = 16,
              .max_lights = 64};
    p.fragment_fog = true;
    p.perspective_color = true;
    p.extensions = {.polygon_offset = true,
                    .shadow_texture = true,
                    .stencil_wrap = true,
                    .two_sided_stencil = true};
    return p;
}

Profile opengl() {
    Profile p{.name = "opengl",
              .accum_bits = 32,
              .subpixel_bits = 8,
              .coverage_bits = 8,
              .color_planes = 2};
    p.fragment_fog = true;
    p.perspective_color = true;
    p.extensions = {.polygon_offset = true,
                    .stencil_wrap = true,
                    .texture_border = true,
                    .texture_formats = true,
                    .stipple = true,
                    .two_sided_polygon_mode = true,
                    .logic_op = true,
                    .blend_color = true,
                    .blend_minmax = true,
                    .blend_subtract = true,
                    .draw_pixels = true,
                    .blend_separate = true,
                    .blend_square = true,
                    .texture_sizes = true,
                    .texture_wraps = true,
                    .texture_lod = true,
                    .texture_combine = true,
                    .texture_srgb = true,
                    .secondary_color = true,
                    .fog_coordinate = true,
                    .occlusion_query = true,
                    .clip_control = true,
                    .texture_units = true,
                    .texture_depth = true,
                    .texture_cube = true,
                    .texture_seamless = true,
                    .texture_3d = true,
                    .surfaces = true,
                    .point_parameters = true,
                    .point_sprite = true,
                    .multisample = true};
    return p;
}

Profile profile_of(const Profile& profile, const Surface& surface) {
    Profile p = profile;
    p.depth_bits = depth_bits(profile, surface);
    return p;
}

std::span<const ExtensionName> extension_names() {
    static constexpr ExtensionName names[] = {
        {"polygon_offset", &Extensions::polygon_offset},
        {"shadow_texture", &Extensions::shadow_texture},
        {"stencil_wrap", &Extensions::stencil_wrap},
        {"two_sided_stencil", &Extensions::two_sided_stencil},
        {"texture_border", &Extensions::texture_border},
        {"texture_formats", &Extensions::texture_formats},
        {"stipple", &Extensions::stipple},
        {"two_sided_polygon_mode", &Extensions::two_sided_polygon_mode},
        {"logic_op", &Extensions::logic_op},
        {"blend_color", &Extensions::blend_color},
        {"blend_minmax", &Extensions::blend_minmax},
        {"blend_subtract", &Extensions::blend_subtract},
        {"draw_pixels", &Extensions::draw_pixels},
        {"blend_separate", &Extensions::blend_separate},
        {"blend_square", &Extensions::blend_square},
        {"texture_sizes", &Extensions::texture_sizes},
        {"texture_wraps", &Extensions::texture_wraps},
        {"texture_lod", &Extensions::texture_lod},
        {"texture_combine", &Extensions::texture_combine},
        {"texture_srgb", &Extensions::texture_srgb},
        {"secondary_color", &Extensions::secondary_color},
        {"fog_coordinate", &Extensions::fog_coordinate},
        {"occlusion_query", &Extensions::occlusion_query},
        {"clip_control", &Extensions::clip_control},
        {"texture_units", &Extensions::texture_units},
        {"texture_depth", &Extensions::texture_depth},
        {"texture_cube", &Extensions::texture_cube},
        {"texture_seamless", &Extensions::texture_seamless},
        {"texture_3d", &Extensions::texture_3d},
        {"surfaces", &Extensions::surfaces},
        {"point_parameters", &Extensions::point_parameters},
        {"point_sprite", &Extensions::point_sprite},
        {"multisample", &Extensions::multisample},
    };
    static_assert(std::size(names) == sizeof(Extensions));
    return names;
}

const std::vector<Profile>& paper_profiles() {
    static const std::vector<Profile> three{vgx(), reality(), ideal()};
    return three;
}

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> all{vgx(), reality(), ideal(), opengl()};
    return all;
}

const Profile& profile_named(std::string_view name) {
    for (const Profile& p : profiles())
        if (p.name == name) return p;
    throw Error(fmt::format("unknown profile '{}'; expected vgx, reality, ideal or opengl", name));
}

void validate(const Profile& p) {
    const auto check = [&](const char* field, int value, int low, int high) {
        if (value < low || value > high)
            throw Error(fmt::format("profile '{}': {} = {}; expected {} to {}", p.name, field,
                                    value, low, high));
    };
    check("color_bits", p.color_bits, 8, 16);
    check("depth_bits", p.depth_bits, 16, 32);
    check("stencil_bits", p.stencil_bits, 1, 8);
    check("accum_bits", p.accum_bits, 16, 32);
    check("subpixel_bits", p.subpixel_bits, 1, 8);
    check("lit_bits", p.lit_bits, 4, p.color_bits);
    check("max_lights", p.max_lights, 1, 1024);
    check("texel_bits", p.texel_bits, 0, 16);
    check("coverage_bits", p.coverage_bits, 0, 16);
    check("color_planes", p.color_planes, 1, 2);
}

}  // namespace gw
