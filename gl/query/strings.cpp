#include "gl/query/strings.h"

#include <map>
#include <mutex>
#include <string>

namespace gw::gl {

namespace {

/// The extensions that every machine has, and those of the profile.
std::string extensions(const Profile& profile) {
    std::string names =
        "GL_ARB_window_pos GL_EXT_copy_texture GL_EXT_draw_range_elements "
        "GL_EXT_packed_depth_stencil GL_EXT_packed_pixels GL_EXT_subtexture GL_EXT_texture "
        "GL_EXT_texture_object GL_EXT_vertex_array GL_SGIS_texture_edge_clamp";
    const auto add = [&](bool has, const char* name) {
        if (has) names.append(" ").append(name);
    };
    const Extensions& has = profile.extensions;
    add(true, "GL_EXT_bgra");
    add(has.polygon_offset, "GL_EXT_polygon_offset");
    add(has.blend_color, "GL_EXT_blend_color");
    add(has.blend_minmax, "GL_EXT_blend_minmax");
    add(has.blend_subtract, "GL_EXT_blend_subtract");
    add(has.stencil_wrap, "GL_EXT_stencil_wrap");
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
        case GL_VERSION: return "1.1";
        case GL_EXTENSIONS: return keep("extensions " + profile.name, extensions(profile));
    }
    return nullptr;
}

}  // namespace gw::gl
