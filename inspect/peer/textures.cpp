#include "inspect/peer/textures.h"

#include "inspect/peer/gl.h"

#include <algorithm>
#include <vector>

namespace gw::peer {
namespace {

GLint value(GLenum name) { return static_cast<GLint>(name); }

unsigned new_object(GLenum target) {
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(target, name);
    return name;
}

GLint internal_format(const Texture& texture) {
    if (texture.depths) return GL_DEPTH_COMPONENT24;
    switch (texture.format) {
        case TextureFormat::RGBA: return texture.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
        case TextureFormat::RGB: return texture.srgb ? GL_SRGB8 : GL_RGB8;
        case TextureFormat::LuminanceAlpha:
            return texture.srgb ? GL_SLUMINANCE8_ALPHA8 : GL_LUMINANCE8_ALPHA8;
        case TextureFormat::Luminance: return texture.srgb ? GL_SLUMINANCE8 : GL_LUMINANCE8;
        case TextureFormat::Alpha: return GL_ALPHA8;
        case TextureFormat::Intensity: return GL_INTENSITY8;
    }
    return GL_RGBA8;
}

GLenum target_of(const TextureBinding& binding) {
    if (!binding.texture) return GL_TEXTURE_2D;
    if (binding.texture->cube) return GL_TEXTURE_CUBE_MAP;
    return binding.texture->dimensions == 1   ? GL_TEXTURE_1D
           : binding.texture->dimensions == 3 ? GL_TEXTURE_3D
                                              : GL_TEXTURE_2D;
}

void require_kind(const Texture& texture) {
    if (texture.srgb) require(21, "GL_EXT_texture_sRGB", "texture.srgb");
    if (texture.cube) require(13, "GL_ARB_texture_cube_map", "a cube");
    if (texture.depths) require(14, "GL_ARB_depth_texture", "a texture of depths");
    if (is_any_size(texture.width(), texture.height()))
        require(20, "GL_ARB_texture_non_power_of_two", "a texture of any size");
}

/// Texels as depths: R has the high 16 bits, G the low ones.
std::vector<GLuint> depths_of(const TextureLevel& level) {
    std::vector<GLuint> out;
    for (std::size_t i = 0; i < level.rgba.size(); i += 4)
        out.push_back(GLuint(level.rgba[i]) << 16 | level.rgba[i + 1]);
    return out;
}

/// One level of a texture of two dimensions, or of one face of a cube.
void upload_flat(const Texture& texture, GLenum target, GLint number, const TextureLevel& level,
                 std::size_t face) {
    const GLint border = texture.border ? 1 : 0, format = internal_format(texture);
    const GLsizei width = level.width + 2 * border, height = level.height + 2 * border;
    const auto send = [&](GLenum given, GLenum type, const void* texels) {
        gl().TexImage2D(target, number, format, width, height, border, given, type, texels);
    };
    if (texture.depths)
        send(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths_of(level).data());
    else
        send(GL_RGBA, GL_UNSIGNED_SHORT,
             level.rgba.data() + face * 4 * std::size_t(width) * std::size_t(height));
}

void upload(const Texture& texture, GLenum target) {
    require_kind(texture);
    const GLint border = texture.border ? 1 : 0;
    GLint level = 0;
    for (const TextureLevel& l : texture.levels) {
        const GLsizei width = l.width + 2 * border;
        if (target == GL_TEXTURE_1D)
            gl().TexImage1D(target, level, internal_format(texture), width, border, GL_RGBA,
                            GL_UNSIGNED_SHORT, l.rgba.data());
        else if (target == GL_TEXTURE_3D)
            required(gl().TexImage3D, "glTexImage3D", "a texture of three dimensions")(
                target, level, internal_format(texture), l.width, l.height, l.layers, 0, GL_RGBA,
                GL_UNSIGNED_SHORT, l.rgba.data());
        else if (target == GL_TEXTURE_CUBE_MAP)
            for (GLenum face = 0; face < 6; ++face)
                upload_flat(texture, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, l, face);
        else
            upload_flat(texture, target, level, l, 0);
        ++level;
    }
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

void set_levels(const TextureLodState& lod, GLenum target, int count) {
    const int last = count - 1;
    if (gl().version >= 12) {
        gl().TexParameteri(target, GL_TEXTURE_BASE_LEVEL, std::clamp(lod.base_level, 0, last));
        gl().TexParameteri(target, GL_TEXTURE_MAX_LEVEL, std::clamp(lod.max_level, 0, last));
        gl().TexParameterf(target, GL_TEXTURE_MIN_LOD, lod.min);
        gl().TexParameterf(target, GL_TEXTURE_MAX_LOD, lod.max);
    }
    if (gl().version >= 14)
        gl().TexParameterf(target, GL_TEXTURE_LOD_BIAS, lod.bias);
    else if (lod != TextureLodState{})
        refuse("OpenGL 1.4", "texture.lod");
}

void set_sampler(const TextureState& s, GLenum target, int levels) {
    const MinFilter min_filter = levels == 1 ? without_mipmaps(s.min_filter) : s.min_filter;
    gl().TexParameteri(target, GL_TEXTURE_MIN_FILTER, value(token(min_filter)));
    gl().TexParameteri(target, GL_TEXTURE_MAG_FILTER, value(token(s.mag_filter)));
    gl().TexParameteri(target, GL_TEXTURE_WRAP_S, value(token(s.wrap_s)));
    gl().TexParameteri(target, GL_TEXTURE_WRAP_T, value(token(s.wrap_t)));
    if (target == GL_TEXTURE_3D)
        gl().TexParameteri(target, GL_TEXTURE_WRAP_R, value(token(s.wrap_r)));
    gl().TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &s.border_color[0]);
    set_levels(s.lod, target, levels);
    if (gl().offers(32, "GL_ARB_seamless_cube_map"))
        enable(GL_TEXTURE_CUBE_MAP_SEAMLESS, s.seamless);
    else if (s.seamless)
        refuse("GL_ARB_seamless_cube_map", "texture.seamless");
}

/// The machine compares with the nearest texel; OpenGL would filter the comparisons.
void set_comparison(const TextureState& s, GLenum target, TextureFormat format) {
    if (gl().version < 14) {
        if (s.shadow_compare) refuse("GL_ARB_shadow", "texture.shadow_compare");
        return;
    }
    const auto set = [&](GLenum name, GLenum word) {
        gl().TexParameteri(target, name, value(word));
    };
    set(GL_TEXTURE_COMPARE_MODE, s.shadow_compare ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
    if (s.compare_func != CompareFunc::LEqual)
        require(15, "GL_EXT_shadow_funcs", "texture.compare_func");
    set(GL_TEXTURE_COMPARE_FUNC, token(s.compare_func));
    set(GL_DEPTH_TEXTURE_MODE, format == TextureFormat::Luminance ? GL_LUMINANCE
                               : format == TextureFormat::Alpha   ? GL_ALPHA
                                                                  : GL_INTENSITY);
    if (!s.shadow_compare) return;
    set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// An operand of alpha is an alpha, whichever word names it.
GLenum alpha_operand(CombineOperand operand) {
    const bool inverts =
        operand == CombineOperand::OneMinusColor || operand == CombineOperand::OneMinusAlpha;
    return inverts ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA;
}

/// The names of the alpha arguments follow those of colour ones by 8.
void set_combine(const CombineState& s, bool alpha) {
    const auto set = [&](GLenum name, GLenum word) {
        gl().TexEnvi(GL_TEXTURE_ENV, name + (alpha ? 8 : 0), value(word));
    };
    gl().TexEnvi(GL_TEXTURE_ENV, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB, value(token(s.func)));
    const CombineSource sources[] = {s.source0, s.source1, s.source2};
    const CombineOperand operands[] = {s.operand0, s.operand1, s.operand2};
    for (GLenum i = 0; i < 3; ++i) {
        set(GL_SOURCE0_RGB + i, token(sources[i]));
        set(GL_OPERAND0_RGB + i, alpha ? alpha_operand(operands[i]) : token(operands[i]));
    }
    gl().TexEnvf(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, float(s.scale));
}

void set_environment(const TextureState& s) {
    if (s.env > TexEnv::Replace) require(13, "GL_ARB_texture_env_combine", "texture.env");
    gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, value(token(s.env)));
    gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &s.env_color[0]);
    if (gl().offers(20, "GL_ARB_point_sprite"))
        gl().TexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, s.coord_replace);
    if (s.env != TexEnv::Combine) return;
    set_combine(s.combine_rgb, false);
    set_combine(s.combine_alpha, true);
}

}  // namespace

void use_unit(std::size_t unit) {
    if (gl().ActiveTexture)
        gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    else if (unit > 0)
        refuse("GL_ARB_multitexture", "more_maps");
}

void enable(const TextureTargets& targets, bool on) {
    for (std::size_t unit = targets.size(); unit-- > 0;) {
        if (targets[unit] == 0) continue;
        use_unit(unit);
        enable(targets[unit], on);
    }
    use_unit(0);
}

unsigned Textures::object(const TextureBinding& binding, GLenum target) {
    if (!binding.texture) return slots_.at(*binding.slot);
    const auto [place, added] = made_.try_emplace(binding.texture, 0);
    if (added) {
        place->second = new_object(target);
        upload(*binding.texture, target);
    }
    return place->second;
}

GLenum Textures::bind(std::size_t unit, const TextureBinding& binding, const TextureState& state,
                      unsigned plane) {
    if (!binding.enabled()) return 0;
    use_unit(unit);
    const GLenum target = target_of(binding);
    gl().BindTexture(target, binding.surface ? plane : object(binding, target));
    set_sampler(state, target, binding.texture ? int(binding.texture->levels.size()) : 1);
    set_comparison(state, target,
                   binding.texture && binding.texture->depths ? binding.texture->format
                                                              : TextureFormat::Intensity);
    set_environment(state);
    use_unit(0);
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
