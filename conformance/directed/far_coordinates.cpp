// Texture coordinates far from 0: whole parts beyond every clamp, spans beyond 1024 repeats, with
// another wrap in s than in t.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

using namespace fuzz;

namespace {

float any_place(Random& r) {
    return r.pick({0.0f, 1000.0f, 1023.0f, 1024.0f, 3000.0f, 262144.0f, 16777216.0f, 1073741824.0f,
                   3e38f, -1023.0f, -1025.0f, -5000.0f, -16777216.0f});
}

/// From a place on: nearly constant, some repeats, or thousands.
float any_span(Random& r) { return r.pick({0.25f, 1.0f, 2.5f, 1024.0f, 1500.0f, 70000.0f}); }

MeshRef square(Random& r, float size) {
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    const float s = any_place(r), t = any_place(r), ds = any_span(r), dt = any_span(r);
    data.texcoords = {{s, t}, {s + ds, t}, {s + ds, t + dt}, {s, t + dt}};
    return make_mesh(data);
}

/// q grows over the square by up to 2^30, so that s and t are small beside the largest of them.
dmat4 any_projector(Random& r) {
    dmat4 m(0);
    m[0][3] = r.pick({0.0, 1.0, 1e4, 1e8, -0.1});
    m[3][3] = r.pick({1.0, 0.5, -1.0, 1e-3});
    for (int i = 0; i < 3; ++i) {
        m[0][i] = r.real(-1, 1);
        m[1][i] = r.real(-1, 1);
        m[3][i] = r.real(-4, 4);
    }
    return m;
}

}  // namespace

Case far_coordinates_case(Random& r) {
    Script s{r, {r.pick(profiles()), 24, 24}};
    s.frame = {s.out.width, s.out.height};
    s.state.projection[0][0] = s.state.projection[1][1] = 2.0 / 24;
    s.state.projection[3] = {-1, -1, 0, 1};
    add(s, Clear{all_planes});
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 16 * 8; ++i) texels.push_back(static_cast<std::uint16_t>(r.bits(16)));
    const TextureRef texture = make_texture("noise", 16, 8, texels);
    for (int i = 0; i < 10; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.env = TexEnv::Replace;
        if (r.chance(40)) {
            s.state.texture.gen = TexGen::EyeLinear;
            s.state.texture.eye_linear = any_projector(r);
        }
        set_state(s);
        s.out.list.add(Draw{.mesh = square(r, 24), .map = {texture, {}}});
    }
    return s.out;
}

}  // namespace gw::conformance
