// The colours of the maps, each a function of s, t in [0,1) that repeats, so that the map can be tiled:
// red lacquer; planks, tiles, bricks; marble, whose veins lie at the level of warped noise; sphere maps.
#include "scenes/make_maps/maps.h"

#include "scenes/make_maps/noise.h"
#include "scenes/make_maps/paint.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace gw::maps {
namespace {

// Pieces in rows, every second row shifted by half a piece: the piece, and the place in it, 0 .. 1.
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

// The place to which noise pushes st; still repeats.
dvec2 warped(dvec2 st, double strength, std::uint32_t seed) {
    return st + strength * dvec2(fractal(st, {3, 3}, 4, seed) - 0.5,
                                 fractal(st, {3, 3}, 4, seed + 100) - 0.5);
}

// 1 on the middle line of a vein, falling to 0 at `width` of the noise's range from it.
double vein(dvec2 st, ivec2 cells, double width, std::uint32_t seed) {
    return 1 - ramp(0, width, std::abs(fractal(st, cells, 4, seed) - 0.5));
}

double veins(dvec2 st) {
    const dvec2 p = warped(st, 0.35, 11);
    const double broad = vein(p, {2, 3}, 0.026, 21), fine = vein(p, {5, 4}, 0.018, 31);
    return std::max(broad, 0.6 * fine);
}

// The direction in which the ball reflects the view (0, 0, -1) at st; outside the ball, that at its
// rim.
dvec3 reflected(dvec2 st) {
    dvec2 n = 2.0 * st - 1.0;
    const double length = glm::length(n);
    if (length > 1) n /= length;
    const double z = std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y));
    return {2 * z * n.x, 2 * z * n.y, 2 * z * z - 1};
}

// 1 inside the rectangle |x - center| < half, fading over `soft`.
double inside(dvec2 p, dvec2 center, dvec2 half, double soft) {
    const dvec2 d = glm::abs(p - center) - half;
    return (1 - ramp(0, soft, d.x)) * (1 - ramp(0, soft, d.y));
}

// The point in which the direction meets the wall of a large room, x to the right of the wall's
// middle. False: it points away.
bool on_wall(const dvec3& r, const dvec3& wall, const dvec3& right, const dvec3& up, dvec2& p) {
    const double ahead = glm::dot(r, wall);
    if (ahead <= 0.05) return false;
    p = dvec2(glm::dot(r, right), glm::dot(r, up)) / ahead;
    return true;
}

double soft_box(const dvec3& r) {
    dvec2 p;
    return on_wall(r, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}, p)
               ? inside(p, {0.1, -0.35}, {0.75, 0.4}, 0.12)
               : 0;
}

double window(const dvec3& r) {
    dvec2 p;
    if (!on_wall(r, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}, p)) return 0;
    double light = 0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            light += inside(p, {-0.75 + 0.5 * i, -0.1 + 0.42 * j}, {0.2, 0.17}, 0.03);
    return light;
}

double lamps(const dvec3& r) {
    dvec2 p;
    if (!on_wall(r, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, p)) return 0;
    double light = 0;
    for (int i = 0; i < 4; ++i)
        light += 1 - ramp(0.06, 0.12, glm::length(p - dvec2(-0.6 + 0.5 * i, 0.7)));
    return light;
}

/// Red lacquer, slightly uneven. Has hardly any green or blue, so that it turns every colour it
/// modulates red [K2].
Color red(dvec2 st) {
    const double streaks = fractal(st, {2, 20}, 3, 5);
    return mix({0.72, 0.02, 0.03}, {0.96, 0.05, 0.05}, ramp(0.25, 0.75, streaks));
}

/// Planks of wood, four across, s along the grain.
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

/// Stone tiles, light and dark, two by two.
Color checker(dvec2 st) {
    const Piece tile = piece_at(st, {2, 2}, false);
    const bool dark = (tile.column + tile.row) % 2 != 0;
    const double cloud = 0.08 * fractal(st, {16, 16}, 4, 401 + (dark ? 9 : 0));
    const Color stone = dark ? Color(0.12, 0.13, 0.16) + cloud : Color(0.78, 0.76, 0.72) + cloud;
    return mix(grey(0.3), stone, in_piece(tile.inside, {0.016, 0.016}));
}

/// Eight courses of four bricks.
Color brick(dvec2 st) {
    const Piece b = piece_at(st, {4, 8}, true);
    const double tone = hash_unit(b.column, b.row, 501), rough = fractal(st, {32, 32}, 3, 511);
    const Color clay = mix({0.48, 0.2, 0.13}, {0.7, 0.34, 0.24}, 0.6 * tone + 0.5 * rough - 0.05);
    return mix(grey(0.55 + 0.2 * rough), clay, in_piece(b.inside, {0.05, 0.1}));
}

/// Green marble with light veins, and its gloss: 1 on the polished ground, dark in the dull veins
/// [K3.1].
Color marble(dvec2 st) {
    const double cloud = fractal(warped(st, 0.2, 41), {4, 4}, 5, 51);
    const Color ground = mix({0.05, 0.22, 0.16}, {0.22, 0.46, 0.34}, ramp(0.25, 0.75, cloud));
    return mix(ground, {0.86, 0.9, 0.82}, veins(st));
}

Color marble_gloss(dvec2 st) { return grey(1 - 0.92 * ramp(0.05, 0.6, veins(st))); }

/// White marble with grey veins.
Color white_marble(dvec2 st) {
    const dvec2 p = warped(st, 0.4, 61);
    const double cloud = fractal(p, {3, 3}, 5, 71), dark = vein(p, {2, 2}, 0.03, 81);
    return mix(mix({0.93, 0.92, 0.9}, {0.74, 0.74, 0.77}, ramp(0.45, 0.8, cloud)),
               {0.45, 0.45, 0.5}, 0.8 * dark);
}

/// Speckled granite.
Color granite(dvec2 st) {
    const double fine = fractal(st, {48, 48}, 3, 91), coarse = fractal(st, {12, 12}, 3, 95);
    const Color ground = mix({0.42, 0.4, 0.42}, {0.66, 0.63, 0.62}, ramp(0.3, 0.7, coarse));
    return mix(mix(ground, {0.16, 0.16, 0.18}, ramp(0.62, 0.7, fine)), {0.88, 0.84, 0.82},
               ramp(0.36, 0.28, fine));
}

/// GL's sphere map of a photographer's studio [K3]: s, t is the direction of the ball's normal, as
/// the eye sees it. Dark, with a soft box above, a window with bars to the left, a row of lamps to
/// the right, a floor.
Color studio(dvec2 st) {
    const dvec3 r = reflected(st);
    const Color wall = mix({0.1, 0.11, 0.14}, {0.3, 0.31, 0.35}, ramp(-0.2, 0.8, r.y));
    const Color floor = mix({0.26, 0.2, 0.15}, {0.1, 0.08, 0.07}, ramp(-0.05, -0.9, r.y));
    const Color walls = mix(floor, wall, ramp(-0.12, -0.08, r.y));
    return walls + Color(1, 0.98, 0.94) * soft_box(r) + Color(0.8, 0.92, 1) * window(r) +
           Color(1, 0.85, 0.6) * lamps(r);
}

/// The same of a landscape: sky, sun behind the eye's left shoulder, hills, ground.
Color landscape(dvec2 st) {
    const dvec3 r = reflected(st);
    const Color sky = mix({0.82, 0.88, 0.94}, {0.2, 0.4, 0.75}, ramp(0, 0.8, r.y));
    const Color ground = mix({0.42, 0.38, 0.26}, {0.16, 0.13, 0.09}, ramp(0, -0.8, r.y));
    const double hills = 0.1 * noise({0.5 + 0.5 * r.x, r.z > 0 ? 0.25 : 0.75}, {6, 2}, 601);
    const Color land = mix(ground, {0.2, 0.28, 0.22}, ramp(-0.02, 0.02, r.y));
    const double sun = ramp(0.985, 0.99, glm::dot(r, glm::normalize(dvec3(-0.5, 0.6, 0.62))));
    return mix(land, sky, ramp(hills - 0.01, hills + 0.01, r.y)) + Color(1, 0.95, 0.8) * sun;
}

}  // namespace

image::Picture NamedMap::picture() const { return paint(width, height, at); }

const std::vector<NamedMap>& maps() {
    static const std::vector<NamedMap> all{
        {"brick.png", 256, 256, brick},
        {"checker.png", 256, 256, checker},
        {"granite.png", 256, 256, granite},
        {"landscape.png", 256, 256, landscape},
        {"marble.png", 256, 256, marble},
        {"marble_gloss.png", 256, 256, marble_gloss},
        {"red.png", 128, 128, red},
        {"studio.png", 256, 256, studio},
        {"white_marble.png", 256, 256, white_marble},
        {"wood.png", 256, 256, wood},
    };
    return all;
}

}  // namespace gw::maps
