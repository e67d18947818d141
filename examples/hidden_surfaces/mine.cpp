// Draws nearest first, and so shows what is farthest.
#include "hiddensurface/interface/algorithm.h"

#include <algorithm>
#include <numeric>

namespace gw::hiddensurface {

Algorithm mine() {  // the function's name is the file's
    return {.name = "mine", .title = "Near to far", .run = [](const Input& input, StepLog& log) {
                Output output{.list = begin_picture(input, "mine")};
                std::vector<std::size_t> order(input.polygons.size());
                std::iota(order.begin(), order.end(), std::size_t{0});
                std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                    output.counts.keys += 1;
                    return input.polygons[a].nearest < input.polygons[b].nearest;
                });
                for (const std::size_t i : order)
                    if (input.polygons[i].visible())
                        draw_piece(input, whole(i, input.polygons[i]), output, log);
                return output;
            }};
}

}  // namespace gw::hiddensurface
