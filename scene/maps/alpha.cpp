#include "scene/maps/alpha.h"

#include <algorithm>
#include <utility>

namespace gw::scene {
namespace {

constexpr std::size_t alpha = 3;
constexpr std::uint16_t one = 0xFFFF;

bool is_opaque(const Texture& texture) {
    for (const TextureLevel& level : texture.levels) {
        const std::uint16_t* const texels = level.rgba.data();
        for (std::size_t i = alpha; i < level.rgba.size(); i += 4)
            if (texels[i] != one) return false;
    }
    return true;
}

TextureRef opaque(const Texture& from) {
    auto made = std::make_shared<Texture>(from);
    made->history = TextureHistory::begin();
    if (made->format != TextureFormat::RGBA) made->format = TextureFormat::RGB;
    for (TextureLevel& level : made->levels) {
        std::vector<std::uint16_t>& rgba = level.rgba.edit();
        for (std::size_t i = alpha; i < rgba.size(); i += 4) rgba[i] = one;
    }
    return made;
}

/// To nearest; of a grey the grey.
std::uint16_t luminance(const std::uint16_t* texel) {
    constexpr std::uint32_t red = 2126, green = 7152, blue = 722, whole = red + green + blue;
    return std::uint16_t((red * texel[0] + green * texel[1] + blue * texel[2] + whole / 2) / whole);
}

std::uint16_t value_of(const std::uint16_t* texel, OpacityChannel channel) {
    switch (channel) {
        case OpacityChannel::Red: return texel[0];
        case OpacityChannel::Green: return texel[1];
        case OpacityChannel::Blue: return texel[2];
        case OpacityChannel::Alpha: return texel[alpha];
        case OpacityChannel::Luminance:
        case OpacityChannel::AlphaOrLuminance: break;
    }
    return luminance(texel);
}

/// One level: cuts look up no other.
TextureRef with_alpha_of(const Texture& from, OpacityChannel channel) {
    const TextureLevel& texels = from.levels.front();
    Texture made{.name = from.name, .levels = {{texels.width, texels.height, {}}}};
    std::vector<std::uint16_t>& rgba = made.levels.front().rgba.edit();
    rgba.assign(texels.rgba.size(), one);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        rgba[i + alpha] = value_of(texels.rgba.data() + i, channel);
    return share_texture(std::move(made));
}

}  // namespace

AlphaRange alpha_of(const Texture& texture) {
    std::uint16_t low = one, high = 0;
    double sum = 0;
    std::size_t between = 0;
    const TexelValues& rgba = texture.levels.front().rgba;
    for (std::size_t i = alpha; i < rgba.size(); i += 4) {
        low = std::min(low, rgba[i]);
        high = std::max(high, rgba[i]);
        sum += rgba[i];
        between += rgba[i] >= one / 16 && rgba[i] <= one - one / 16;
    }
    const double whole = one, count = double(rgba.size() / 4);
    return {low / whole, high / whole, sum / (whole * count), double(between) / count};
}

TextureRef OpaqueTextures::of(const TextureRef& texture) {
    if (!texture) return texture;
    TextureRef& made = made_[texture];
    if (!made) made = is_opaque(*texture) ? texture : opaque(*texture);
    return made;
}

void choose_opacity_channels(Scene& scene) {
    std::map<std::pair<TextureRef, OpacityChannel>, TextureRef> chosen;
    for (Material& material : scene.materials)
        for (Map& map : material.map_d) {
            if (!map.texture || map.channel == OpacityChannel::Alpha) continue;
            TextureRef& made = chosen[{map.texture, map.channel}];
            const bool by_alpha = map.channel == OpacityChannel::AlphaOrLuminance;
            if (!made)
                made = by_alpha && !is_opaque(*map.texture)
                           ? map.texture
                           : with_alpha_of(*map.texture, map.channel);
            map.texture = made;
            map.channel = OpacityChannel::Alpha;
        }
}

}  // namespace gw::scene
