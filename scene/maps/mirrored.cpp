#include "scene/maps/mirrored.h"

#include "scene/maps/map_lists.h"

#include <map>
#include <tuple>

namespace gw::scene {
namespace {

constexpr bool is_mirrored(Wrap wrap) { return wrap == Wrap::MirroredRepeat; }

TextureRef unfolded(const Texture& texture, bool by_s, bool by_t) {
    const int width = texture.width(), height = texture.height();
    const int wide = by_s ? 2 * width : width, high = by_t ? 2 * height : height;
    std::vector<std::uint16_t> rgba;
    rgba.reserve(std::size_t(4 * wide * high));
    const TexelValues& from = texture.levels.front().rgba;
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            const int i = x < width ? x : wide - 1 - x, j = y < height ? y : high - 1 - y;
            const auto texel = from.begin() + std::ptrdiff_t(4 * pixel_index(i, j, width));
            rgba.insert(rgba.end(), texel, texel + 4);
        }
    return make_texture(texture.name, wide, high, rgba);
}

class Unfolder {
public:
    explicit Unfolder(Warnings& warnings) : warnings_(warnings) {}

    void operator()(Map& map) {
        if (!map.texture) return;
        const bool by_s = fits(map, map.wrap_s, map.texture->width()),
                   by_t = fits(map, map.wrap_t, map.texture->height());
        if (is_mirrored(map.wrap_s)) map.wrap_s = Wrap::Repeat;
        if (is_mirrored(map.wrap_t)) map.wrap_t = Wrap::Repeat;
        if (!by_s && !by_t) return;
        TextureRef& made = made_[{map.texture, by_s, by_t}];
        if (!made) made = unfolded(*map.texture, by_s, by_t);
        map.texture = made;
        const vec2 part(by_s ? 0.5f : 1, by_t ? 0.5f : 1);
        map.scale *= part;
        map.offset *= part;
    }

private:
    bool fits(const Map& map, Wrap wrap, int side) {
        if (!is_mirrored(wrap)) return false;
        if (2 * side <= max_texture_size) return true;
        warnings_.add(map.origin.file, map.origin.line, "mirrored",
                      "a map of " + std::to_string(side) +
                          " texels repeats without being mirrored; expected at most " +
                          std::to_string(max_texture_size / 2));
        return false;
    }

    Warnings& warnings_;
    std::map<std::tuple<TextureRef, bool, bool>, TextureRef> made_;
};

}  // namespace

void unfold_mirrored(Scene& scene, Warnings& warnings) {
    Unfolder unfold(warnings);
    for (Material& material : scene.materials)
        for_each_color_map(material, [&](Map& map) { unfold(map); });
}

}  // namespace gw::scene
