// The painter's algorithm by the nearest corner [L5].
#include "hiddensurface/structures/painter.h"

namespace gw::hiddensurface {

Algorithm painter_nearest() {
    return {.place = 21,
            .name = "painter-nearest",
            .title = "Painter's algorithm by the nearest corner [L5]",
            .run = [](const Input& input, StepLog& log) {
                return paint(input, log, "painter's, nearest", &Polygon::nearest);
            }};
}

}  // namespace gw::hiddensurface
