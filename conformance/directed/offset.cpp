// Polygon offset: slopes from flat to slivers', factors and units of every size and sign.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

using namespace fuzz;

Case offset_case(Random& r) {
    Script s{r, {r.chance(50) ? reality() : ideal(), r.between(20, 40), r.between(20, 40)}};
    s.frame = any_frame(r, s.out.width, s.out.height, s.out.profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    add(s, Clear{all_planes});
    for (int i = 0; i < 8; ++i) {
        s.state.depth = {.test = true, .func = DepthFunc::Always};
        const float factor = r.pick({0.0f, 1.0f, -1.5f, 1e-3f, 3e38f, 0.3f});
        s.state.polygon_offset = {true, factor, r.pick({0.0f, 1.0f, -4.0f, 2.5f, 1e30f, 70000.0f})};
        s.state.polygon_mode = r.chance(80) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        draw(s, any_mesh(r, s.frame, {.most = 5}));
    }
    return s.out;
}

}  // namespace gw::conformance
