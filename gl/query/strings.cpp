#include "gl/query/strings.h"

#include "gl/api/offer.h"
#include "gl/drawable/settings.h"

#include <map>
#include <mutex>
#include <string>

namespace gw::gl {

namespace {

struct NamedExtension {
    const char* name;
    Offer offer;
};
/// The extensions, each with the version of OpenGL that has it. Those of 1.1 are of its time, or have
/// always been here.
constexpr NamedExtension named_extensions[] = {
    {"GL_ARB_window_pos", {11, nullptr}},
    {"GL_MESA_window_pos", {11, nullptr}},
    {"GL_EXT_compiled_vertex_array", {11, nullptr}},
    {"GL_EXT_copy_texture", {11, nullptr}},
    {"GL_EXT_draw_range_elements", {11, nullptr}},
    {"GL_EXT_packed_depth_stencil", {11, nullptr}},
    {"GL_NV_packed_depth_stencil", {11, nullptr}},
    {"GL_EXT_packed_pixels", {11, nullptr}},
    {"GL_EXT_subtexture", {11, nullptr}},
    {"GL_EXT_texture", {11, nullptr}},
    {"GL_EXT_texture_object", {11, nullptr}},
    {"GL_EXT_vertex_array", {11, nullptr}},
    {"GL_SGIS_texture_edge_clamp", {11, nullptr}},
    {"GL_EXT_texture_edge_clamp", {11, nullptr}},
    {"GL_EXT_abgr", {11, nullptr}},
    {"GL_EXT_bgra", {11, nullptr}},
    {"GL_EXT_polygon_offset", {11, &Extensions::polygon_offset}},
    {"GL_EXT_blend_color", {11, &Extensions::blend_color}},
    {"GL_EXT_blend_minmax", {11, &Extensions::blend_minmax}},
    {"GL_EXT_blend_subtract", {11, &Extensions::blend_subtract}},
    {"GL_EXT_stencil_wrap", {11, &Extensions::stencil_wrap}},
    {"GL_EXT_separate_specular_color", {12, &Extensions::secondary_color}},
    {"GL_EXT_rescale_normal", {12, nullptr}},
    {"GL_SGIS_texture_lod", {12, &Extensions::texture_lod}},
    {"GL_EXT_texture3D", {12, &Extensions::texture_3d}},
    {"GL_ARB_texture_border_clamp", {13, &Extensions::texture_wraps}},
    {"GL_SGIS_texture_border_clamp", {13, &Extensions::texture_wraps}},
    {"GL_ARB_texture_compression", {13, &Extensions::texture_formats}},
    {"GL_EXT_texture_compression_s3tc", {13, &Extensions::texture_formats}},
    {"GL_EXT_texture_compression_dxt1", {13, &Extensions::texture_formats}},
    {"GL_ARB_texture_env_add", {13, &Extensions::texture_combine}},
    {"GL_ARB_texture_env_combine", {13, &Extensions::texture_combine}},
    {"GL_ARB_texture_env_dot3", {13, &Extensions::texture_combine}},
    {"GL_EXT_texture_env_add", {13, &Extensions::texture_combine}},
    {"GL_EXT_texture_env_combine", {13, &Extensions::texture_combine}},
    {"GL_ARB_transpose_matrix", {13, nullptr}},
    {"GL_ARB_multisample", {13, &Extensions::multisample}},
    {"GL_ARB_multitexture", {13, &Extensions::texture_units}},
    {"GL_ARB_texture_cube_map", {13, &Extensions::texture_cube}},
    {"GL_EXT_texture_cube_map", {13, &Extensions::texture_cube}},
    {"GL_NV_texgen_reflection", {13, &Extensions::texture_cube}},
    {"GL_ARB_depth_texture", {14, &Extensions::texture_depth}},
    {"GL_ARB_shadow", {14, &Extensions::texture_depth}},
    {"GL_ARB_texture_env_crossbar", {14, &Extensions::texture_units}},
    {"GL_EXT_shadow_funcs", {15, &Extensions::texture_depth}},
    {"GL_ARB_seamless_cube_map", {15, &Extensions::texture_seamless}},
    {"GL_ARB_texture_mirrored_repeat", {14, &Extensions::texture_wraps}},
    {"GL_IBM_texture_mirrored_repeat", {14, &Extensions::texture_wraps}},
    {"GL_EXT_texture_lod_bias", {14, &Extensions::texture_lod}},
    {"GL_SGIS_generate_mipmap", {14, nullptr}},
    {"GL_EXT_multi_draw_arrays", {14, nullptr}},
    {"GL_SUN_multi_draw_arrays", {14, nullptr}},
    {"GL_EXT_blend_func_separate", {14, &Extensions::blend_separate}},
    {"GL_INGR_blend_func_separate", {14, &Extensions::blend_separate}},
    {"GL_ARB_point_parameters", {14, &Extensions::point_parameters}},
    {"GL_EXT_point_parameters", {14, &Extensions::point_parameters}},
    {"GL_EXT_fog_coord", {14, &Extensions::fog_coordinate}},
    {"GL_EXT_secondary_color", {14, &Extensions::secondary_color}},
    {"GL_NV_blend_square", {14, &Extensions::blend_square}},
    {"GL_ARB_clip_control", {15, &Extensions::clip_control}},
    {"GL_ARB_point_sprite", {15, &Extensions::point_sprite}},
    {"GL_ARB_occlusion_query", {15, &Extensions::occlusion_query}},
    {"GL_ARB_vertex_buffer_object", {15, nullptr}},
    {"GL_ARB_pixel_buffer_object", {15, nullptr}},
    {"GL_EXT_pixel_buffer_object", {15, nullptr}},
    {"GL_ARB_map_buffer_range", {15, nullptr}},
    {"GL_ARB_copy_buffer", {15, nullptr}},
    {"GL_ARB_texture_non_power_of_two", {15, &Extensions::texture_sizes}},
    {"GL_ARB_texture_rectangle", {15, &Extensions::texture_sizes}},
    {"GL_EXT_texture_rectangle", {15, &Extensions::texture_sizes}},
    {"GL_NV_texture_rectangle", {15, &Extensions::texture_sizes}},
    {"GL_ARB_framebuffer_object", {15, &Extensions::surfaces}},
    {"GL_EXT_framebuffer_blit", {15, &Extensions::surfaces}},
    {"GL_EXT_framebuffer_multisample", {15, &Extensions::multisample}},
    {"GL_EXT_framebuffer_object", {15, &Extensions::surfaces}},
    {"GL_EXT_texture_sRGB", {15, &Extensions::texture_srgb}},
    {"GL_EXT_blend_equation_separate", {15, &Extensions::blend_separate}},
    {"GL_ATI_blend_equation_separate", {15, &Extensions::blend_separate}},
};

std::string extensions(const Profile& profile, int version) {
    std::string names;
    for (const NamedExtension& extension : named_extensions)
        if (is_offered(extension.offer, profile, version))
            names.append(names.empty() ? "" : " ").append(extension.name);
    return names;
}

}  // namespace

const char* implementation_string(const Profile& profile, GLenum name) {
    static std::mutex mutex;
    static auto& texts = *new std::map<std::string, std::string>;  // programs keep them
    const auto keep = [&](const std::string& key, const std::string& text) {
        const std::lock_guard lock(mutex);
        return texts.try_emplace(key, text).first->second.c_str();
    };
    switch (name) {
        case GL_VENDOR: return "GW";
        case GL_RENDERER:
            return keep("renderer " + profile.name, "GW " + profile.name + ", exact to the bit");
        case GL_VERSION: {
            const int version = whole_version(profile, settings().version);
            return keep("version " + std::to_string(version), "1." + std::to_string(version % 10));
        }
        case GL_EXTENSIONS: {
            const std::string names = extensions(profile, settings().version);
            return keep(names, names);
        }
    }
    return nullptr;
}

}  // namespace gw::gl
