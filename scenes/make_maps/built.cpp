// What is put together from pieces: planks, tiles, bricks; and red lacquer.
#include "scenes/make_maps/materials.h"
#include "scenes/make_maps/noise.h"

#include <cmath>

namespace gw::maps {
namespace {

// Pieces in rows, every second row shifted by half a piece: which piece, and where in it, 0 .. 1.
struct Piece {
    int column, row;
    dvec2 inside;
};

Piece piece_at(dvec2 st, ivec2 count, bool shifted) {
    const double y = st.y * count.y, row = std::floor(y);
    const double x = st.x * count.x + (shifted && static_cast<int>(row) % 2 != 0 ? 0.5 : 0),
                 column = std::floor(x);
    return {static_cast<int>(column) % count.x, static_cast<int>(row), {x - column, y - row}};
}

// 1 in a piece, 0 in the joint; `joint` is its width as a part of the piece, along s and t.
double in_piece(dvec2 inside, dvec2 joint) {
    const dvec2 edge{std::min(inside.x, 1 - inside.x) / joint.x,
                     std::min(inside.y, 1 - inside.y) / joint.y};
    return ramp(0.5, 0.9, std::min(edge.x, edge.y));
}

}  // namespace

Color red(dvec2 st) {
    const double streaks = fractal(st, {2, 20}, 3, 5);
    return mix({0.72, 0.02, 0.03}, {0.96, 0.05, 0.05}, ramp(0.25, 0.75, streaks));
}

Color wood(dvec2 st) {
    const Piece plank = piece_at(st, {1, 4}, false);
    const auto seed = static_cast<std::uint32_t>(7 * plank.row);
    const double warp = fractal(st, {2, 8}, 4, 301 + seed);
    const double rings = plank.inside.y * 3 + 5 * warp, ring = rings - std::floor(rings);
    const double grain = fractal(st, {8, 256}, 2, 311);
    const double tone = 0.75 * ramp(0, 0.8, ring) - 0.9 * ramp(0.8, 1, ring) * ring + 0.45 * grain;
    const Color pale = mix({0.66, 0.42, 0.22}, {0.74, 0.5, 0.29}, hash_unit(0, plank.row, 321));
    return mix({0.1, 0.05, 0.02}, mix(pale, {0.42, 0.22, 0.09}, tone),
               in_piece({0.5, plank.inside.y}, {0.5, 0.02}));
}

Color checker(dvec2 st) {
    const Piece tile = piece_at(st, {2, 2}, false);
    const bool dark = (tile.column + tile.row) % 2 != 0;
    const double cloud = 0.08 * fractal(st, {16, 16}, 4, 401 + (dark ? 9 : 0));
    const Color stone = dark ? Color(0.12, 0.13, 0.16) + cloud : Color(0.78, 0.76, 0.72) + cloud;
    return mix(grey(0.3), stone, in_piece(tile.inside, {0.016, 0.016}));
}

Color brick(dvec2 st) {
    const Piece b = piece_at(st, {4, 8}, true);
    const double tone = hash_unit(b.column, b.row, 501), rough = fractal(st, {32, 32}, 3, 511);
    const Color clay = mix({0.48, 0.2, 0.13}, {0.7, 0.34, 0.24}, 0.6 * tone + 0.5 * rough - 0.05);
    return mix(grey(0.55 + 0.2 * rough), clay, in_piece(b.inside, {0.05, 0.1}));
}

}  // namespace gw::maps
