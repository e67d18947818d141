#include "conformance/generate/profile.h"

namespace gw::fuzz {

Profile user_profile(Random& r) {
    Profile p{.name = "user"};
    p.color_bits = r.chance(40) ? 8 : r.between(8, 16);
    p.depth_bits = r.between(16, 32);
    p.stencil_bits = r.between(1, 8);
    p.accum_bits = r.between(16, 32);
    p.subpixel_bits = r.between(1, 8);
    p.lit_bits = r.between(4, p.color_bits);
    p.max_lights = r.between(1, 12);
    p.fragment_fog = r.chance(50);
    p.perspective_color = r.chance(50);
    p.extensions = {r.chance(50), r.chance(50), r.chance(50), r.chance(50)};
    return p;
}

Profile any_profile(Random& r) { return r.chance(70) ? r.pick(profiles()) : user_profile(r); }

}  // namespace gw::fuzz
