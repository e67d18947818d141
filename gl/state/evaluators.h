// Evaluators: polynomial maps of one and two parameters to the values of vertices. [GL11] 5.1
#pragma once

#include "gl/state/state.h"

#include <array>
#include <vector>

namespace gw::gl {

inline constexpr int max_eval_order = 30;

struct Map1 {
    double u1 = 0, u2 = 1;
    int order = 1;
    std::vector<double> points;  ///< order points of map_size() numbers
};
struct Map2 {
    double u1 = 0, u2 = 1, v1 = 0, v2 = 1;
    int uorder = 1, vorder = 1;
    std::vector<double> points;  ///< uorder rows of vorder points
};

/// The maps, in GL's order: COLOR_4, INDEX, NORMAL, TEXTURE_COORD_1 .. 4, VERTEX_3, VERTEX_4.
struct Evaluators {
    Evaluators();
    std::array<Map1, map_count> map1;
    std::array<Map2, map_count> map2;
};

/// The numbers of one point, by the map's place in GL's order.
inline constexpr std::array<int, map_count> map_sizes{4, 1, 3, 1, 2, 3, 4, 3, 4};

constexpr bool is_map1(GLenum target) {
    return target >= GL_MAP1_COLOR_4 && target <= GL_MAP1_VERTEX_4;
}
constexpr bool is_map2(GLenum target) {
    return target >= GL_MAP2_COLOR_4 && target <= GL_MAP2_VERTEX_4;
}
/// The numbers of one point of the map; 0: the target is none.
int map_size(GLenum target);

}  // namespace gw::gl
