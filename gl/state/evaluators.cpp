#include "gl/state/evaluators.h"

namespace gw::gl {

int map_size(GLenum target) {
    if (is_map1(target)) return map_sizes[target - GL_MAP1_COLOR_4];
    return is_map2(target) ? map_sizes[target - GL_MAP2_COLOR_4] : 0;
}

Evaluators::Evaluators() {
    // [GL11] table 6.19: one point, the initial current value.
    const std::array<std::vector<double>, map_count> points{{{1, 1, 1, 1},
                                                             {1},
                                                             {0, 0, 1},
                                                             {0},
                                                             {0, 0},
                                                             {0, 0, 0},
                                                             {0, 0, 0, 1},
                                                             {0, 0, 0},
                                                             {0, 0, 0, 1}}};
    for (std::size_t i = 0; i < map_count; ++i) {
        map1[i].points = points[i];
        map2[i].points = points[i];
    }
}

}  // namespace gw::gl
