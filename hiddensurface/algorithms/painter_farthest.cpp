// The painter's algorithm by the farthest corner [L5].
#include "hiddensurface/structures/painter.h"

namespace gw::hiddensurface {

Algorithm painter_farthest() {
    return {.place = 20,
            .name = "painter-farthest",
            .title = "Painter's algorithm by the farthest corner [L5]",
            .run = [](const Input& input, StepLog& log) {
                return paint(input, log, "painter's, farthest", &Polygon::farthest);
            }};
}

}  // namespace gw::hiddensurface
