// Back-face culling alone [L3]: draws every polygon that faces the eye, in the scene's order. Right
// for one convex object. If there are several, or a concave one, the polygon drawn last is seen, not
// the nearest.
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/model/normal.h"

namespace gw::hiddensurface {
namespace {

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "back faces culled")};
    const dvec4 eye = eye_of(input.view);
    log.watch(watched(output.counts));
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const Polygon& polygon = input.polygons[i];
        if (!polygon.visible()) continue;
        const dvec3 n = polygon_normal(polygon.world), p = polygon.world[0];
        const double d_f = facing(eye, p, n);
        output.counts.facings += 1;
        if (log.on())
            log.add({.test = "facing",
                     .result = d_f > 0   ? "front"
                               : d_f < 0 ? "back"
                                         : "edge-on",
                     .pieces = {name_of(polygon)},
                     .values = {{"D_f", d_f},
                                {"N", std::vector{n.x, n.y, n.z}},
                                {"P_i", std::vector{p.x, p.y, p.z}}},
                     .decisive = d_f <= 0});
        if (d_f > 0) draw_piece(input, whole(i, polygon), output, log);
    }
    return output;
}

}  // namespace

Algorithm back_face() {
    return {.name = "back-face", .title = "Back-face culling alone [L3]", .run = run};
}

}  // namespace gw::hiddensurface
