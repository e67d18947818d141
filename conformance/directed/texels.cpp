// Texels: every environment with every format, fewer bits, border colours, r and q of the mesh.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

std::vector<std::uint16_t> noise(Random& r, int texels) {
    std::vector<std::uint16_t> out;
    for (int i = 0; i < 4 * texels; ++i) out.push_back(std::uint16_t(r.bits(16)));
    return out;
}

TextureRef noise_of_format(Random& r, TextureFormat format) {
    Texture t{.name = "noise", .format = format};
    t.levels.push_back({4, 4, noise(r, 16)});
    return make_texture(std::move(t));
}

/// A colour far from 0 and 1 in every channel.
vec4 middle_color(Random& r) {
    return {float(r.real(0.2, 0.8)), float(r.real(0.2, 0.8)), float(r.real(0.2, 0.8)),
            float(r.real(0.2, 0.8))};
}

/// A square of the window with texture coordinates from `low` to `high`.
MeshData colored_square(Random& r, int side, float low, float high) {
    MeshData data = rectangle(0, 0, float(side), float(side));
    data.texcoords = {{low, low}, {high, low}, {high, high}, {low, high}};
    for (int i = 0; i < 4; ++i) data.colors.push_back(middle_color(r));
    return data;
}

}  // namespace

// [R10.17] [R10.24]
Case environments_case(Random& r) {
    constexpr int side = 12;
    Script s = pixel_script(r, opengl_up_to(&Extensions::draw_pixels), side, side);
    const MeshRef mesh = make_mesh(colored_square(r, side, 0, 1));
    for (int format = 0; format <= int(TextureFormat::Intensity); ++format) {
        const TextureRef texture = noise_of_format(r, TextureFormat(format));
        for (int env = 0; env <= int(TexEnv::Replace); ++env) {
            s.state.texture = any_texture_state(r);
            s.state.texture.env = TexEnv(env);
            s.state.texture.env_color = middle_color(r);
            add(s, Draw{.mesh = mesh, .map = {texture, {}}});
        }
    }
    return s.out;
}

namespace {

/// [R10.25] Half of the square is border.
void draw_borders(Script& s, int side) {
    Random& r = s.random;
    const MeshRef mesh = make_mesh(colored_square(r, side, -0.5f, 1.5f));
    for (int format = 0; format <= int(TextureFormat::Intensity); ++format) {
        s.state.texture = {.wrap_s = Wrap::BorderClamp, .wrap_t = r.any(Wrap::BorderClamp)};
        s.state.texture.env = TexEnv::Modulate;
        s.state.texture.border_color = middle_color(r);
        add(s, Draw{.mesh = mesh, .map = {noise_of_format(r, TextureFormat(format)), {}}});
    }
}

/// [R10.22] q is 1, and r is what is compared. Plain coordinates would have no r, and those that
/// repeat so often would be wide.
void draw_projected(Script& s, int side) {
    Random& r = s.random;
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    s.state.texture = {};
    MeshData slope = rectangle(0, 0, float(side), float(side));
    for (vec3& p : slope.positions) p.z = float(r.real(-1, 1));
    add(s, Draw{.mesh = make_mesh(slope)});
    add(s, CopyTexture{.slot = 1, .plane = Plane::Depth, .rect = {0, 0, side, side}});
    MeshData mesh = colored_square(r, side, 0, 1);
    mesh.texcoords_rq = {{0, 1}, {1, 1}, {1, 1}, {0, 1}};
    s.state.texture.shadow_compare = true;
    add(s, Draw{.mesh = make_mesh(mesh), .map = {{}, 1}});
    s.state.texture = {.env = TexEnv::Replace};  // [R10.16] depths as grey
    add(s, Draw{.mesh = make_mesh(colored_square(r, side, 0, 1)), .map = {{}, 1}});
    s.state.texture = {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
    s.state.texture.env = TexEnv::Replace;
    const double repeats = r.real(5000, 9000);
    const TextureRef texture = make_texture("noise", 8, 8, noise(r, 64));
    MeshData far = mesh;
    for (vec2& st : far.texcoords) st *= float(repeats);
    add(s, Draw{.mesh = make_mesh(far), .map = {texture, {}}});
    // An affine matrix leaves plain coordinates plain.
    mesh.texcoords_rq.clear();
    s.state.texture.matrix[0][0] = s.state.texture.matrix[1][1] = repeats;
    add(s, Draw{.mesh = make_mesh(mesh), .map = {texture, {}}});
}

}  // namespace

Case texels_case(Random& r) {
    constexpr int side = 16;
    Profile profile = opengl_up_to(&Extensions::draw_pixels);
    profile.texel_bits = r.between(2, 5);
    profile.extensions.shadow_texture = true;
    Script s = pixel_script(r, profile, side, side);
    const MeshRef mesh = make_mesh(colored_square(r, side, 0, 1));
    for (int i = 0; i < 3; ++i) {  // [R10.23] with and without given levels
        s.state.texture = any_texture_state(r);
        const TextureRef plain = make_texture("noise", 8, 8, noise(r, 64));
        add(s, Draw{.mesh = mesh, .map = {plain, {}}});
        add(s, Draw{.mesh = mesh, .map = {noise_of_format(r, TextureFormat::RGBA), {}}});
    }
    draw_borders(s, side);
    draw_projected(s, side);
    return s.out;
}

}  // namespace gw::conformance
