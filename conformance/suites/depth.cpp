// The depth test and its plane.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case depth_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(2, 8);
    for (int i = 0; i < draws; ++i) {
        s.state.depth = any_depth(r);
        if (r.chance(30)) s.state.depth_range = any_depth_range(r);
        s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
        s.state.color_mask = r.chance(80) ? ColorMask{} : any_color_mask(r);
        const double z = any_z(r, s.frame);
        draw(s,
             r.chance(25) ? cover_mesh(r, s.frame, {}, z) : any_triangles(r, s.frame, {.most = 8}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
