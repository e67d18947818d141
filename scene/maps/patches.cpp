#include "scene/maps/patches.h"

#include "scene/maps/map_lists.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace gw::scene {
namespace {

std::size_t wrapped(double i, int size, Wrap wrap) {
    if (wrap == Wrap::Clamp) return std::size_t(std::clamp(i, 0.0, double(size - 1)));
    const double period = wrap == Wrap::MirroredRepeat ? 2.0 * size : size;
    const double at = i - period * std::floor(i / period);
    return std::size_t(std::clamp(at < size ? at : period - 1 - at, 0.0, double(size - 1)));
}

/// The bilinear texture at a point in texels.
glm::dvec4 sampled(const Map& map, const dvec2& at) {
    const Texture& texture = *map.texture;
    const TexelValues& rgba = texture.levels.front().rgba;
    const dvec2 low = glm::floor(at - 0.5), part = at - 0.5 - low;
    glm::dvec4 sum(0);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const std::size_t x = wrapped(low.x + i, texture.width(), map.wrap_s),
                              y = wrapped(low.y + j, texture.height(), map.wrap_t);
            const std::uint16_t* const texel =
                rgba.data() + 4 * (y * std::size_t(texture.width()) + x);
            const double weight = (i == 1 ? part.x : 1 - part.x) * (j == 1 ? part.y : 1 - part.y);
            sum += weight * glm::dvec4(texel[0], texel[1], texel[2], texel[3]);
        }
    return sum;
}

class Resampler {
public:
    Resampler(const Map& map, const PatchedLookup& lookup)
        : map_(map),
          patches_(lookup.patches),
          rgba_(4 * patches_.width() * patches_.height(), 0xFFFF) {
        for (std::size_t i = 0; 3 * i < lookup.st.size(); ++i) fill(i, &lookup.st[3 * i]);
    }

    TextureRef texture() const {
        return make_texture(map_.texture->name, int(patches_.width()), int(patches_.height()),
                            rgba_);
    }
    /// Of the map, for one of a patch.
    double most_texels() const { return most_texels_; }

private:
    dvec2 in_texels(const vec2& st) const {
        return (dvec2(st) * dvec2(map_.scale) + dvec2(map_.offset)) *
               dvec2(map_.texture->width(), map_.texture->height());
    }

    /// Beyond the triangle the map goes on in its plane.
    void fill(std::size_t triangle, const vec2* st) {
        const double span = patches_.span(), first = double(patches_.margin());
        const dvec2 a = in_texels(st[0]), u = (in_texels(st[1]) - a) / span,
                    v = (in_texels(st[2]) - a) / span;
        const double step = std::max(length(u), length(v));
        most_texels_ = std::max(most_texels_, step);
        constexpr double most_samples = 8;
        const int n = int(std::clamp(std::ceil(step), 1.0, most_samples));
        for (std::size_t y = 0; y < patches_.side; ++y)
            for (std::size_t x = 0; x < patches_.side; ++x) {
                glm::dvec4 sum(0);
                for (int k = 0; k < n * n; ++k) {
                    const double i = double(x) - first + (k % n + 0.5) / n - 0.5,
                                 j = double(y) - first + (k / n + 0.5) / n - 0.5;
                    sum += sampled(map_, a + u * i + v * j);
                }
                std::uint16_t* const texel =
                    &rgba_[4 * ((patches_.row(triangle) + y) * patches_.width() +
                                patches_.column(triangle) + x)];
                for (int k = 0; k < 4; ++k) texel[k] = std::uint16_t(std::lround(sum[k] / (n * n)));
            }
    }

    const Map& map_;
    const Patches& patches_;
    std::vector<std::uint16_t> rgba_;
    double most_texels_ = 0;
};

}  // namespace

std::size_t patch_side(std::size_t triangles, std::size_t texels) {
    constexpr std::size_t most = 2048, least = 4;
    for (std::size_t side = most; side >= least; side /= 2) {
        const Patches patches(triangles, side);
        if (patches.width() <= most && patches.width() * patches.height() <= texels) return side;
    }
    return 0;
}

void resample_patched(Scene& scene, Warnings& warnings) {
    std::map<std::tuple<TextureRef, const PatchedLookup*>, TextureRef> made;
    const auto resample = [&](const Material& material, Map& map) {
        const auto lookup = std::exchange(map.patched, nullptr);
        if (!lookup || !map.texture) return;
        TextureRef& texture = made[{map.texture, lookup.get()}];
        if (!texture) {
            const Resampler resampler(map, *lookup);
            texture = resampler.texture();
            if (resampler.most_texels() > 2)
                warnings.add(
                    map.origin.file, map.origin.line, "patched map",
                    "material '" + printable(material.name) +
                        "': its textures of several sets of coordinates are drawn with " +
                        std::to_string(lookup->patches.side) +
                        " texels along a triangle; expected at least " +
                        std::to_string(std::llround(std::min(resampler.most_texels(), 1e9) *
                                                    double(lookup->patches.side))));
        }
        map.texture = texture;
        map.wrap_s = map.wrap_t = Wrap::Clamp;
        map.scale = vec2(1);
        map.offset = vec2(0);
    };
    for (Material& material : scene.materials)
        for_each_map_list(material, [&](std::string_view, std::vector<Map>& maps) {
            for (Map& map : maps) resample(material, map);
        });
}

}  // namespace gw::scene
