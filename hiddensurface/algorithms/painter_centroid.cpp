// The painter's algorithm by the centroid [L5].
#include "hiddensurface/structures/painter.h"

namespace gw::hiddensurface {

Algorithm painter_centroid() {
    return {.place = 22,
            .name = "painter-centroid",
            .title = "Painter's algorithm by the centroid [L5]",
            .run = [](const Input& input, StepLog& log) {
                return paint(input, log, "painter's, centroid", &Polygon::centroid);
            }};
}

}  // namespace gw::hiddensurface
