// The messages of textures that are refused, for docs/manual/commands.md's table.
#pragma once

#include "gw/texture.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gw {

/// `message_of`: what a call is refused with.
inline std::vector<std::string> refused_textures(
    const std::function<std::string(const std::function<void()>&)>& message_of) {
    const std::vector<std::uint16_t> texel(4);
    const auto given = [&](const std::function<void(Texture&)>& change) {
        Texture t{.name = "t", .levels = {{1, 1, std::vector<std::uint16_t>(4)}}};
        change(t);
        return message_of([&] { make_texture(std::move(t)); });
    };
    const auto kind = [&](const TextureLevel& level, int dimensions, const Texture& of = {}) {
        return given([&](Texture& t) {
            t.levels[0] = level;
            t.dimensions = dimensions;
            t.cube = of.cube;
            t.border = of.border;
            t.depths = of.depths;
        });
    };
    return {
        message_of([&] { make_texture("t", 4097, 1, texel); }),
        message_of([&] { make_texture("t", 2, 1, texel); }),
        given([](Texture& t) { t.levels.clear(); }),
        kind({1, 1}, 4),
        kind({1, 1, {}, 2}, 2),
        kind({1, 1}, 3, {.cube = true}),
        kind({1, 2}, 2, {.cube = true}),
        kind({513, 1}, 3),
        kind({1, 1}, 3, {.border = true}),
        kind({1, 1}, 2, {.depths = true}),
        given([](Texture& t) {
            t.dimensions = 3;
            t.levels.push_back({1, 1, std::vector<std::uint16_t>(8), 2});
        }),
        given([](Texture& t) {
            t.dimensions = 1;
            t.levels[0].height = 2;
        }),
        given([](Texture& t) { t.format = TextureFormat(6); }),
        given([](Texture& t) { t.levels[0].width = 3; }),
        given([](Texture& t) { t.levels[0].height = 8193; }),
        given([](Texture& t) {
            t.levels.push_back({2, 1, std::vector<std::uint16_t>(8)});
        }),
        given([](Texture& t) { t.levels[0].rgba.edit().resize(8); }),
    };
}

}  // namespace gw
