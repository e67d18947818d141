// Back-face culling alone [L3]: draws every polygon that faces the eye, in the scene's order. Right
// for one convex object. If there are several, or a concave one, the polygon drawn last is seen, not
// the nearest.
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/model/normal.h"

namespace gw::hiddensurface {
namespace {

/// The step's product is D_f, or if lines of sight are parallel, N.d with the direction d to the
/// eye.
void log_facing(const Input& input, const Polygon& polygon, const dvec3& n, double sign,
                StepLog& log) {
    if (!log.on()) return;
    const dvec3 p = polygon.world[0];
    const dvec4 eye = unit_eye_of(input.view);
    const bool parallel = eye.w == 0;
    Step step{.test = parallel ? "facing-parallel" : "facing",
              .result = sign > 0   ? "front"
                        : sign < 0 ? "back"
                                   : "edge-on",
              .pieces = {name_of(polygon)},
              .values = {{parallel ? "N_d" : "D_f", facing(eye, p, n)},
                         {"N", std::vector{n.x, n.y, n.z}}},
              .decisive = sign <= 0};
    if (parallel)
        step.values.emplace_back("d", std::vector{eye.x, eye.y, eye.z});
    else
        step.values.emplace_back("P_i", std::vector{p.x, p.y, p.z});
    log.add(std::move(step));
}

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "back faces culled")};
    const dvec4 eye = eye_of(input.view);
    log.watch(watched(output.counts));
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const Polygon& polygon = input.polygons[i];
        if (!polygon.visible()) continue;
        const dvec3 n = polygon_normal(polygon.world);
        const double d_f = facing(eye, polygon.world[0], n);
        output.counts.facings += 1;
        log_facing(input, polygon, n, d_f, log);
        if (d_f > 0) draw_piece(input, whole(i, polygon), output, log);
    }
    return output;
}

}  // namespace

Algorithm back_face() {
    return {.name = "back-face", .title = "Back-face culling alone [L3]", .run = run};
}

}  // namespace gw::hiddensurface
