// Texture units, objects and parameters. [GL11] 3.8.3 to 3.8.9, [GL13] 2.7, 3.8
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include "gw/describe/opengl.h"

#include <algorithm>

namespace gw::gl {

namespace {

bool is_min_filter(GLenum f, std::size_t target) {
    const bool uses_levels = f >= GL_NEAREST_MIPMAP_NEAREST && f <= GL_LINEAR_MIPMAP_LINEAR;
    return f == GL_NEAREST || f == GL_LINEAR || (uses_levels && target != rectangular);
}

vec4 clamped_color(const Params& p) {
    vec4 out = p.as_vec4();
    for (int i = 0; i < 4; ++i) out[i] = clamped(out[i], 0.0f, 1.0f);
    return out;
}

void set_wrap(Context& context, std::size_t target, GLenum& field, GLenum mode) {
    const bool has_more = context.profile.extensions.texture_wraps;
    const bool repeats = mode == GL_REPEAT || (has_more && mode == GL_MIRRORED_REPEAT);
    const bool known = mode == GL_CLAMP || mode == GL_CLAMP_TO_EDGE ||
                       (has_more && mode == GL_CLAMP_TO_BORDER) ||
                       (repeats && target != rectangular);
    if (!known) return set_error(context, GL_INVALID_ENUM);
    change(context, field, mode);
}

void set_filter(Context& context, GLenum& field, GLenum filter, bool known) {
    if (!known) return set_error(context, GL_INVALID_ENUM);
    change(context, field, filter);
}

/// Sets a parameter that the machine's texture depends on.
template <class T>
void set_part(Context& context, std::size_t target, T TextureParameters::*which, T value) {
    TextureObject& object = bound_texture(context, target);
    if (object.parameters.*which == value) return;
    begin_change(context, texture_part);
    const auto lock = context.shared->exclusive();
    TextureParameters all = object.parameters;
    all.*which = value;
    object.set_parameters(all);
}

void set_level(Context& context, std::size_t target, int TextureParameters::*which, double level) {
    if (level < 0) return set_error(context, GL_INVALID_VALUE);
    if (which == &TextureParameters::base_level && target == rectangular && level != 0)
        return set_error(context, GL_INVALID_OPERATION);
    set_part(context, target, which, int(std::min(level, 1000.0)));
}

void set_depth_mode(Context& context, std::size_t target, GLenum mode) {
    if (mode != GL_LUMINANCE && mode != GL_INTENSITY && mode != GL_ALPHA)
        return set_error(context, GL_INVALID_ENUM);
    set_part(context, target, &TextureParameters::depth_mode, mode);
}

/// [GL14] 3.8.14; all eight functions of [GL15].
void set_comparison(Context& context, std::size_t target, GLenum pname, GLenum value) {
    TextureParameters& s = bound_texture(context, target).parameters;
    if (pname == GL_DEPTH_TEXTURE_MODE) return set_depth_mode(context, target, value);
    if (pname == GL_TEXTURE_COMPARE_MODE) {
        if (value != GL_NONE && value != GL_COMPARE_R_TO_TEXTURE)
            return set_error(context, GL_INVALID_ENUM);
        return change(context, s.compare_mode, value);
    }
    if (!from_opengl<CompareFunc>(value)) return set_error(context, GL_INVALID_ENUM);
    change(context, s.compare_func, value);
}

/// The object of a name, made when the name is bound first. Null: another target has the name.
std::shared_ptr<TextureObject> object_of(Context& context, std::size_t target,
                                         GLenum name_of_target, GLuint name) {
    if (name == 0) return context.textures.initial[target];
    const auto lock = context.shared->exclusive();
    TextureNames::Named& named = context.shared->textures.named[name];
    if (named.target != 0 && named.target != name_of_target) return nullptr;
    if (!named.object) named = {name_of_target, new_texture(target)};
    return named.object;
}

/// A texture that is deleted is bound nowhere in this context.
void unbind(Context& context, GLuint name) {
    for (std::size_t unit = 0; unit < texture_unit_count; ++unit)
        for (std::size_t target = 0; target < texture_target_count; ++target) {
            GLuint& bound = context.state.texture.units[unit].bound[target];
            if (bound != name) continue;
            begin_change(context, texture_part);
            bound = 0;
            context.textures.bound[unit][target] = context.textures.initial[target];
        }
}

}  // namespace

namespace execute {

void tex_parameter(Context& context, GLenum target, GLenum pname, const Params& params) {
    const auto index = target_index(context.profile, target);
    if (!index) return set_error(context, GL_INVALID_ENUM);
    TextureParameters& s = bound_texture(context, *index).parameters;
    const GLenum token = params.token();
    switch (pname) {
        case GL_TEXTURE_MIN_FILTER:
            return set_filter(context, s.min_filter, token, is_min_filter(token, *index));
        case GL_TEXTURE_MAG_FILTER:
            return set_filter(context, s.mag_filter, token,
                              token == GL_NEAREST || token == GL_LINEAR);
        case GL_TEXTURE_WRAP_S: return set_wrap(context, *index, s.wrap_s, token);
        case GL_TEXTURE_WRAP_T: return set_wrap(context, *index, s.wrap_t, token);
        case GL_TEXTURE_WRAP_R:
            if (!context.profile.extensions.texture_3d) return set_error(context, GL_INVALID_ENUM);
            return set_wrap(context, *index, s.wrap_r, token);
        case GL_DEPTH_TEXTURE_MODE:
        case GL_TEXTURE_COMPARE_MODE:
        case GL_TEXTURE_COMPARE_FUNC:
            if (!context.profile.extensions.texture_depth)
                return set_error(context, GL_INVALID_ENUM);
            return set_comparison(context, *index, pname, token);
        case GL_TEXTURE_BORDER_COLOR:
            if (params.count < 4) return set_error(context, GL_INVALID_ENUM);
            return change(context, s.border_color, clamped_color(params));
        case GL_TEXTURE_PRIORITY: s.priority = clamped(float(params[0]), 0.0f, 1.0f); return;
        case GL_GENERATE_MIPMAP:
            if (*index == rectangular && params[0] != 0)
                return set_error(context, GL_INVALID_VALUE);
            s.generate_mipmap = params[0] != 0;
            return;
    }
    if (!context.profile.extensions.texture_lod) return set_error(context, GL_INVALID_ENUM);
    switch (pname) {
        case GL_TEXTURE_MIN_LOD: return change(context, s.min_lod, float(params[0]));
        case GL_TEXTURE_MAX_LOD: return change(context, s.max_lod, float(params[0]));
        case GL_TEXTURE_LOD_BIAS: return change(context, s.lod_bias, float(params[0]));
        case GL_TEXTURE_BASE_LEVEL:
            return set_level(context, *index, &TextureParameters::base_level, params[0]);
        case GL_TEXTURE_MAX_LEVEL:
            return set_level(context, *index, &TextureParameters::max_level, params[0]);
    }
    set_error(context, GL_INVALID_ENUM);
}

void active_texture(Context& context, GLenum texture) {
    const auto unit = unit_index(context.profile, texture);
    if (!unit) return set_error(context, GL_INVALID_ENUM);
    context.state.texture.active = *unit;
}

void bind_texture(Context& context, GLenum target, GLuint texture) {
    const auto index = target_index(context.profile, target);
    if (!index) return set_error(context, GL_INVALID_ENUM);
    std::shared_ptr<TextureObject> object = object_of(context, *index, target, texture);
    if (!object) return set_error(context, GL_INVALID_OPERATION);
    GLuint& name = context.state.texture.unit().bound[*index];
    auto& bound = context.textures.bound[context.state.texture.active][*index];
    // Another context may have changed the object; binding it makes that visible.
    if (object == bound && texture == name && context.shared.use_count() == 1) return;
    begin_change(context, texture_part);
    name = texture;
    bound = std::move(object);
}

void gen_textures(Context& context, GLsizei n, GLuint* textures) {
    const auto lock = context.shared->exclusive();
    gen_names(context, context.shared->textures, n, textures);
}

void delete_textures(Context& context, GLsizei n, const GLuint* textures) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (textures == nullptr) return;
    for (GLsizei i = 0; i < n; ++i) {
        if (textures[i] == 0) continue;
        unbind(context, textures[i]);
        const auto lock = context.shared->exclusive();
        auto& named = context.shared->textures.named;
        const auto found = named.find(textures[i]);
        if (found == named.end()) continue;
        const std::shared_ptr<TextureObject> object = found->second.object;
        if (object) detach(context, [&](const Attachment& a) { return a.texture == object; });
        named.erase(found);
        context.shared->textures.free_names.give_back(textures[i]);
    }
}

GLboolean is_texture(Context& context, GLuint texture) {
    const auto lock = context.shared->exclusive();
    const auto found = context.shared->textures.named.find(texture);
    return found != context.shared->textures.named.end() && found->second.object ? GL_TRUE
                                                                                 : GL_FALSE;
}

GLboolean are_textures_resident(Context& context, GLsizei n, const GLuint* textures, GLboolean*) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE), GL_FALSE;
    if (textures == nullptr) return GL_FALSE;
    for (GLsizei i = 0; i < n; ++i)
        if (!is_texture(context, textures[i]))
            return set_error(context, GL_INVALID_VALUE), GL_FALSE;
    return GL_TRUE;  // residences are then left alone
}

void prioritize_textures(Context& context, GLsizei n, const Numbers& textures,
                         const Numbers& priorities) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    const auto lock = context.shared->exclusive();
    for (std::size_t i = 0; i < std::min(textures->size(), priorities->size()); ++i) {
        const auto found = context.shared->textures.named.find(GLuint((*textures)[i]));
        if (found == context.shared->textures.named.end() || !found->second.object) continue;
        found->second.object->parameters.priority = float(clamped((*priorities)[i], 0.0, 1.0));
    }
}

}  // namespace execute

}  // namespace gw::gl
