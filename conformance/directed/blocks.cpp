// A window of 3 x 2 blocks, the last ones cut by its border: every plane differs in every block.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

using namespace fuzz;

Case blocks_case(Random& r) {
    Script s{r, {reality(), 130, 67}};
    s.frame = flat_frame(r, s.out.width, s.out.height, s.out.profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    s.state.depth.test = true;
    s.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    add(s, Clear{all_planes, {0.25f, 0.5f, 0.75f, 1}, 1, 3});
    for (int i = 0; i < 4; ++i) draw(s, cover_mesh(r, s.frame, {}, r.real(-1, 1)));
    for (int i = 0; i < 6; ++i) draw(s, any_triangles(r, s.frame, {.most = 4}));
    add(s, Accumulate{AccumOp::Load, 1.5f});
    return s.out;
}

}  // namespace gw::conformance
