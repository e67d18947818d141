// Back-face culling alone [L3]: draws every polygon that faces the eye, in the scene's order. Right
// for one convex object. If there are several, or a concave one, the polygon drawn last is seen, not
// the nearest.
#include "hiddensurface/model/normal.h"
#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {
namespace {

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "back faces culled")};
    const dvec4 eye = eye_of(input.view);
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const Polygon& polygon = input.polygons[i];
        if (!polygon.visible()) continue;
        const double d_f = facing(eye, polygon.world[0], polygon_normal(polygon.world));
        output.counts.facings += 1;
        log.compare({polygon.id}, "D_f", d_f > 0 ? "front" : d_f < 0 ? "back" : "edge-on");
        if (d_f > 0) draw_piece(input, whole(i, polygon), output, log);
    }
    return output;
}

}  // namespace

Algorithm back_face() {
    return {.name = "back-face", .title = "Back-face culling alone [L3]", .run = run};
}

}  // namespace gw::hiddensurface
