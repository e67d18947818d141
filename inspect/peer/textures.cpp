#include "inspect/peer/textures.h"

#include "gw/error.h"
#include "inspect/peer/gl.h"

namespace gw::peer {
namespace {

GLint value(GLenum name) { return static_cast<GLint>(name); }

unsigned new_object() {
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(GL_TEXTURE_2D, name);
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

void upload(const Texture& texture) {
    if (texture.border || texture.dimensions != 2)
        throw Error("texture " + texture.name +
                    ": a border, or one dimension; the player hands over neither");
    GLint level = 0;
    for (const TextureLevel& l : texture.levels)
        gl().TexImage2D(GL_TEXTURE_2D, level++, internal_format(texture.format), l.width, l.height,
                        0, GL_RGBA, GL_UNSIGNED_SHORT, l.rgba.data());
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
}

/// A slot has one level.
void set_sampler(const TextureState& s, bool one_level) {
    if (one_level) gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, value(token(s.min_filter)));
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, value(token(s.mag_filter)));
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, value(token(s.wrap_s)));
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, value(token(s.wrap_t)));
    gl().TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &s.border_color[0]);
}

/// The machine compares with the nearest texel; OpenGL would filter the comparisons.
void set_comparison(bool compare) {
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                       value(compare ? GL_COMPARE_R_TO_TEXTURE : GL_NONE));
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl().TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    if (!compare) return;
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

unsigned Textures::object(const TextureBinding& binding) {
    if (!binding.texture) return slots_.at(*binding.slot);
    const auto [place, added] = made_.try_emplace(binding.texture, 0);
    if (added) {
        place->second = new_object();
        upload(*binding.texture);
    }
    return place->second;
}

bool Textures::bind(const TextureBinding& binding, const TextureState& state) {
    if (!binding.enabled()) return false;
    gl().BindTexture(GL_TEXTURE_2D, object(binding));
    set_sampler(state, !binding.texture);
    set_comparison(state.shadow_compare);
    gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, value(token(state.env)));
    gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &state.env_color[0]);
    return true;
}

void Textures::copy(const CopyTexture& c) {
    const auto [place, added] = slots_.try_emplace(c.slot, 0);
    if (added) place->second = new_object();
    gl().BindTexture(GL_TEXTURE_2D, place->second);
    const GLenum format = c.plane == Plane::Depth ? GL_DEPTH_COMPONENT24 : GL_RGBA8;
    gl().CopyTexImage2D(GL_TEXTURE_2D, 0, format, c.rect.x, c.rect.y, c.rect.width, c.rect.height,
                        0);
}

}  // namespace gw::peer
