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

/// The numbers of one point of the map; 0: the target is none.
int map_size(GLenum target);

}  // namespace gw::gl
