#include "conformance/generate/attributes.h"

#include "conformance/generate/state.h"

namespace gw::fuzz {
namespace {

vec3 any_normal(Random& r) {
    const int kind = r.below(20);
    if (kind == 0) return vec3(0);
    if (kind < 6)
        return {float(r.between(-1, 1)), float(r.between(-1, 1)), float(r.between(-1, 1))};
    const float size = kind == 6 ? 1e-30f : kind == 7 ? 1e30f : 1;
    return vec3{float(r.real(-1, 1)), float(r.real(-1, 1)), float(r.real(-0.2, 1))} * size;
}

/// The range of a mesh's coordinates: on texels, over repeats, far out, constant.
struct Spread {
    int kind = 0;
    double scale = 1, shift = 0;
};
Spread any_spread(Random& r) {
    Spread s{r.below(10)};
    s.scale = r.pick({1.0, 1.0, 1.0, 4.0, 0.125, 37.5, 900.0});
    s.shift = r.chance(50) ? 0 : r.between(-5, 5) / 4.0;
    if (r.chance(4)) s.shift = r.scaled(-1, 1, 8, 40);
    if (r.chance(4)) s.scale = r.scaled(-1, 1, 8, 40);
    return s;
}
float any_texcoord(Random& r, const Spread& s) {
    if (s.kind == 0) return float(s.shift);
    const double v = s.kind < 5   ? r.between(-16, 32) / 16.0
                     : s.kind < 8 ? r.real(0, 1)
                                  : r.real(-2, 2);
    return float(v * s.scale + s.shift);
}

}  // namespace

void add_attributes(Random& r, const MeshWish& wish, MeshData& data) {
    const std::size_t n = data.positions.size();
    if (wish.normals)
        for (std::size_t i = 0; i < n; ++i) data.normals.push_back(any_normal(r));
    if (wish.texcoords) {
        const Spread s = any_spread(r), t = any_spread(r);
        for (std::size_t i = 0; i < n; ++i)
            data.texcoords.push_back({any_texcoord(r, s), any_texcoord(r, t)});
    }
    if (wish.colors && r.chance(95)) {
        const vec4 all = any_color(r);
        const bool constant = r.chance(15);
        for (std::size_t i = 0; i < n; ++i) data.colors.push_back(constant ? all : any_color(r));
    }
}

}  // namespace gw::fuzz
