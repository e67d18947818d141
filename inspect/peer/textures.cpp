#include "inspect/peer/textures.h"

#include "inspect/peer/gl.h"

namespace gw::peer {
namespace {

GLint value(GLenum name) { return static_cast<GLint>(name); }

unsigned new_object(GLenum target) {
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(target, name);
    return name;
}

GLint internal_format(TextureFormat format) {
    switch (format) {
        case TextureFormat::RGBA: return GL_RGBA8;
        case TextureFormat::RGB: return GL_RGB8;
        case TextureFormat::LuminanceAlpha: return GL_LUMINANCE8_ALPHA8;
        case TextureFormat::Luminance: return GL_LUMINANCE8;
        case TextureFormat::Alpha: return GL_ALPHA8;
        case TextureFormat::Intensity: return GL_INTENSITY8;
    }
    return GL_RGBA8;
}

GLenum target_of(const TextureBinding& binding) {
    return binding.texture && binding.texture->dimensions == 1 ? GL_TEXTURE_1D : GL_TEXTURE_2D;
}

void upload(const Texture& texture, GLenum target) {
    if (texture.srgb) refuse("GL_EXT_texture_sRGB", "texture");
    if (needs_r(texture)) refuse("OpenGL 1.4", "a texture with r");
    const GLint format = internal_format(texture.format), border = texture.border ? 1 : 0;
    GLint level = 0;
    for (const TextureLevel& l : texture.levels) {
        const GLsizei width = l.width + 2 * border, height = l.height + 2 * border;
        if (target == GL_TEXTURE_1D)
            gl().TexImage1D(target, level, format, width, border, GL_RGBA, GL_UNSIGNED_SHORT,
                            l.rgba.data());
        else
            gl().TexImage2D(target, level, format, width, height, border, GL_RGBA,
                            GL_UNSIGNED_SHORT, l.rgba.data());
        ++level;
    }
    if (gl().version >= 12) gl().TexParameteri(target, GL_TEXTURE_MAX_LEVEL, level - 1);
}

/// Of one level: OpenGL would take a texture without smaller ones for incomplete.
MinFilter without_mipmaps(MinFilter filter) {
    switch (filter) {
        case MinFilter::Nearest:
        case MinFilter::NearestMipmapNearest:
        case MinFilter::NearestMipmapLinear: return MinFilter::Nearest;
        case MinFilter::Linear:
        case MinFilter::LinearMipmapNearest:
        case MinFilter::LinearMipmapLinear: return MinFilter::Linear;
    }
    return filter;
}

void set_sampler(const TextureState& s, GLenum target, bool one_level) {
    if (s.env > TexEnv::Replace) refuse("OpenGL 1.3", "texture.env");
    if (s.lod != TextureLodState{}) refuse("OpenGL 1.4", "texture.lod");
    if (s.shadow_compare && s.compare_func != CompareFunc::LEqual)
        refuse("GL_EXT_shadow_funcs", "texture.compare_func");
    const MinFilter min_filter = one_level ? without_mipmaps(s.min_filter) : s.min_filter;
    gl().TexParameteri(target, GL_TEXTURE_MIN_FILTER, value(token(min_filter)));
    gl().TexParameteri(target, GL_TEXTURE_MAG_FILTER, value(token(s.mag_filter)));
    gl().TexParameteri(target, GL_TEXTURE_WRAP_S, value(token(s.wrap_s)));
    gl().TexParameteri(target, GL_TEXTURE_WRAP_T, value(token(s.wrap_t)));
    gl().TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &s.border_color[0]);
}

/// The machine compares with the nearest texel; OpenGL would filter the comparisons.
void set_comparison(bool compare) {
    if (gl().version < 14) {
        if (compare) refuse("GL_ARB_shadow", "texture.shadow_compare");
        return;
    }
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                       value(compare ? GL_COMPARE_R_TO_TEXTURE : GL_NONE));
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl().TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    if (!compare) return;
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

unsigned Textures::object(const TextureBinding& binding, GLenum target) {
    if (!binding.texture) return slots_.at(*binding.slot);
    const auto [place, added] = made_.try_emplace(binding.texture, 0);
    if (added) {
        place->second = new_object(target);
        upload(*binding.texture, target);
    }
    return place->second;
}

GLenum Textures::bind(const TextureBinding& binding, const TextureState& state) {
    if (!binding.enabled()) return 0;
    const GLenum target = target_of(binding);
    gl().BindTexture(target, object(binding, target));
    set_sampler(state, target, !binding.texture || binding.texture->levels.size() == 1);
    if (target == GL_TEXTURE_2D) set_comparison(state.shadow_compare);
    gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, value(token(state.env)));
    gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &state.env_color[0]);
    return target;
}

void Textures::copy(const CopyTexture& c) {
    const auto [place, added] = slots_.try_emplace(c.slot, 0);
    if (added) place->second = new_object(GL_TEXTURE_2D);
    gl().BindTexture(GL_TEXTURE_2D, place->second);
    if (c.plane == Plane::Depth && gl().version < 14)
        refuse("GL_ARB_depth_texture", "a texture slot of depths");
    const GLenum format = c.plane == Plane::Depth ? GL_DEPTH_COMPONENT24 : GL_RGBA8;
    gl().CopyTexImage2D(GL_TEXTURE_2D, 0, format, c.rect.x, c.rect.y, c.rect.width, c.rect.height,
                        0);
}

}  // namespace gw::peer
