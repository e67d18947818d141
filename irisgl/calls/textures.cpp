// Textures: definitions, binding, coordinates.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace gw::irisgl::calls {

namespace {

constexpr GLuint texture_names = 0x60000000;

/// The bytes of a texture: rows begin at whole words, the first component in the highest byte that
/// they use.
std::uint32_t component(Words image, std::size_t row_words, long x, long y, int components, int c) {
    const std::size_t byte = std::size_t(x) * std::size_t(components) + std::size_t(c);
    const std::uint32_t word = image.get(std::size_t(y) * row_words + byte / 4);
    return word >> (24 - 8 * (byte % 4)) & 0xFF;
}

void read_texels(TextureDefinition& t, Words image) {
    const std::size_t row_words = (std::size_t(t.width) * std::size_t(t.components) + 3) / 4;
    t.rgba.clear();
    for (long y = 0; y < t.height; ++y)
        for (long x = 0; x < t.width; ++x) {
            std::uint32_t v[4] = {};
            for (int c = 0; c < t.components; ++c)
                v[c] = component(image, row_words, x, y, t.components, c);
            // 4: ABGR in a word; 3: BGR; 2: intensity and alpha; 1: intensity.
            const int n = t.components;
            const std::uint32_t r = n == 4 ? v[3] : n == 3 ? v[2] : v[0];
            const std::uint32_t g = n == 4 ? v[2] : n == 3 ? v[1] : v[0];
            const std::uint32_t b = n == 4 ? v[1] : n == 3 ? v[0] : v[0];
            const std::uint32_t a = n == 4 ? v[0] : n == 2 ? v[1] : 255;
            for (const std::uint32_t c : {r, g, b, a}) t.rgba.push_back(std::uint8_t(c));
        }
}

GLint filter_of(int word) {
    switch (word) {
        case TX_POINT: return GL_NEAREST;
        case TX_BILINEAR: return GL_LINEAR;
        case TX_MIPMAP_POINT: return GL_NEAREST_MIPMAP_NEAREST;
        case TX_MIPMAP_LINEAR: return GL_NEAREST_MIPMAP_LINEAR;
        case TX_MIPMAP_BILINEAR: return GL_LINEAR_MIPMAP_NEAREST;
        case TX_MIPMAP_TRILINEAR: return GL_LINEAR_MIPMAP_LINEAR;
    }
    return GL_LINEAR;
}

void set_property(int word, int value) {
    const GLint wrap = value == TX_CLAMP ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    if (word == TX_MINFILTER)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter_of(value));
    if (word == TX_MAGFILTER)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                        value == TX_POINT ? GL_NEAREST : GL_LINEAR);
    if (word == TX_WRAP || word == TX_WRAP_S)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    if (word == TX_WRAP || word == TX_WRAP_T)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

/// Gives OpenGL the definition, with levels when the filter needs them.
void upload(const TextureDefinition& t) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (std::size_t i = 0; i + 1 < t.properties.size() && t.properties[i] != 0;
         i += 1 + std::size_t(texture_values(int(t.properties[i]))))
        set_property(int(t.properties[i]), int(t.properties[i + 1]));
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GLsizei(t.width), GLsizei(t.height), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, t.rgba.data());
}

/// Textures are drawn if both a texture and an environment are bound.
void use_texture() {
    State& s = state();
    s.textured = s.bound_texture != 0 && s.bound_environment != 0;
    (s.textured ? glEnable : glDisable)(GL_TEXTURE_2D);
}

/// A part of a texture: new texels, and the first one's place.
struct TexturePart {
    TextureDefinition texels;
    long x = 0, y = 0;
};

/// Left, right, bottom, top from 0 to 1. Nothing: no such part.
std::optional<TexturePart> part_of(const std::string& function, long target, long index,
                                   const std::array<float, 4>& sides) {
    const auto found = program().textures.find(index);
    if (target != TX_TEXTURE_0 || found == program().textures.end()) {
        warn(function + ": texture " + std::to_string(index) +
             "; expected TX_TEXTURE_0 and a defined texture; it is ignored");
        return {};
    }
    const TextureDefinition& t = found->second;
    const auto texel = [](float at, long size) {
        return at >= 0 && at <= 1 ? std::lround(at * float(size)) : 0;
    };
    const long x = texel(sides[0], t.width), y = texel(sides[2], t.height);
    TexturePart part{{.components = t.components,
                      .width = texel(sides[1], t.width) - x,
                      .height = texel(sides[3], t.height) - y},
                     x,
                     y};
    const auto& [width, height] = std::pair(part.texels.width, part.texels.height);
    if (x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= t.width &&
        y + height <= t.height)
        return part;
    warn(function + ": texels " + std::to_string(x) + " to " + std::to_string(x + width - 1) +
         ", " + std::to_string(y) + " to " + std::to_string(y + height - 1) +
         "; expected a part of the texture; it is ignored");
    return {};
}

void put(const TexturePart& part, long index) {
    TextureDefinition& t = program().textures.at(index);
    const long width = part.texels.width;
    for (long row = 0; row < part.texels.height; ++row)
        std::copy_n(part.texels.rgba.begin() + 4 * row * width, 4 * width,
                    t.rgba.begin() + 4 * ((part.y + row) * t.width + part.x));
    if (state().bound_texture == index) upload(t);
}

constexpr GLenum axes[] = {GL_S, GL_T, GL_R, GL_Q};

}  // namespace

void texdef2d(long index, long components, long width, long height, Words image, long,
              Values props) {
    const bool fits = width > 0 && height > 0 && width <= 4096 && height <= 4096;
    if (index <= 0 || components < 1 || components > 4 || !fits || !image.is_given())
        return warn(
            "texdef2d: texture " + std::to_string(index) + " of " + std::to_string(width) + " x " +
            std::to_string(height) + " texels of " + std::to_string(components) +
            " components; expected an index from 1, an image, 1 to 4 components and sides of 1 "
            "to 4096; it is ignored");
    TextureDefinition& t = program().textures[index];
    t.components = int(components);
    t.width = width;
    t.height = height;
    t.properties.assign(props.begin(), props.end());
    read_texels(t, image);
    ++t.version;
}

void texbind(long target, long index) {
    if (target != TX_TEXTURE_0) return warn("texbind: expected TX_TEXTURE_0; it is ignored");
    const auto found = program().textures.find(index);
    const bool is_defined = found != program().textures.end();
    if (!is_defined && index != 0)
        warn("texbind: texture " + std::to_string(index) + " is not defined; none is bound");
    state().bound_texture = is_defined ? index : 0;
    if (is_defined) {
        glBindTexture(GL_TEXTURE_2D, texture_names + GLuint(index));
        upload(found->second);
    }
    use_texture();
}

// Rows of the part begin at whole words, as those of a whole texture.
void subtexload(long target, long index, float left, float right, float bottom, float top, long n,
                Words texels, unsigned long) {
    auto part = part_of("subtexload", target, index, {left, right, bottom, top});
    if (!part) return;
    TextureDefinition& texture = part->texels;
    const long words = (texture.width * texture.components + 3) / 4 * texture.height;
    if (n < words || !texels.is_given())
        return warn("subtexload: " + std::to_string(n) + " words; expected " +
                    std::to_string(words) + "; it is ignored");
    read_texels(texture, texels);
    put(*part, index);
}

void fbsubtexload(long x, long y, long target, long index, float left, float right, float bottom,
                  float top, unsigned long) {
    auto part = part_of("fbsubtexload", target, index, {left, right, bottom, top});
    if (!part) return;
    TextureDefinition& texture = part->texels;
    for (const std::uint32_t pixel :
         read_rectangle(int(x), int(y), int(texture.width), int(texture.height)))
        for (const int channel : {0, 1, 2, 3}) {
            const bool is_grey = texture.components < 3, has_alpha = texture.components % 2 == 0;
            const std::uint32_t value = pixel >> 8 * (is_grey && channel < 3 ? 0 : channel);
            texture.rgba.push_back(channel == 3 && !has_alpha ? 255 : std::uint8_t(value));
        }
    put(*part, index);
}

void tevdef(long index, long, Values props) {
    program().environments[index].assign(props.begin(), props.end());
}

void tevbind(long, long index) {
    const auto found = program().environments.find(index);
    const bool is_defined = index != 0 && found != program().environments.end();
    if (!is_defined && index != 0)
        warn("tevbind: environment " + std::to_string(index) + " is not defined; none is bound");
    state().bound_environment = is_defined ? index : 0;
    use_texture();
    if (!is_defined) return;
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    const auto& props = found->second;
    for (std::size_t i = 0; i < props.size() && props[i] != 0; ++i) {
        const int word = int(props[i]);
        if (word == TV_DECAL) glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
        if (word == TV_BLEND) glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
        if (word == TV_COLOR && i + 4 < props.size()) {
            glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &props[i + 1]);
            i += 4;
        }
    }
}

void texgen(long coordinate, long mode, Values params) {
    if (coordinate < TX_S || coordinate > TX_Q)
        return warn("texgen: coordinate " + std::to_string(coordinate) +
                    "; expected TX_S, TX_T, TX_R or TX_Q; it is ignored");
    const GLenum axis = axes[coordinate], capability = GL_TEXTURE_GEN_S + GLenum(coordinate - TX_S);
    if (mode == TG_OFF || mode == TG_ON) return (mode == TG_ON ? glEnable : glDisable)(capability);
    load_matrices();
    if (mode == TG_SPHEREMAP) {
        glTexGeni(axis, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    } else if (mode == TG_LINEAR || mode == TG_CONTOUR) {
        const bool object = mode == TG_LINEAR;
        glTexGeni(axis, GL_TEXTURE_GEN_MODE, object ? GL_OBJECT_LINEAR : GL_EYE_LINEAR);
        glTexGenfv(axis, object ? GL_OBJECT_PLANE : GL_EYE_PLANE, params.data());
    } else {
        warn("texgen: mode " + std::to_string(mode) + " is not known; it is ignored");
    }
}

void texture_coordinate(float s, float t, float r, float q) {
    state().texture_coordinate = {s, t, r, q};
}

long istexloaded(long, long index) { return program().textures.contains(index) ? 1 : 0; }

}  // namespace gw::irisgl::calls
