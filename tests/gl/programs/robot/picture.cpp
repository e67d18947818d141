// The robot's picture: its passes in their order.
#include "tests/gl/programs/robot/matrices.h"
#include "tests/gl/programs/robot/scene.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace robot {

namespace {

struct Spot {
    std::array<GLfloat, 4> position;
    std::array<GLfloat, 3> target;
};
constexpr Spot spots[] = {{{3, -2, 6, 1}, {0, 0, 0}}, {{-4, -3, 5, 1}, {0, 1, 0}}};
constexpr float cutoff = 40;

/// Near is 1 and far 0: depths by ClipControl, else in the upper half of -1 .. 1.
void load_reversed(const Scene& s, float half_width, float half_height, float near_z, float far_z) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (s.zero_to_one) {
        gl.Translatef(0, 0, 0.5f);
        gl.Scalef(1, 1, -0.5f);
    } else {
        gl.Scalef(1, 1, -1);
    }
    gl.Frustum(double(-half_width * near_z), double(half_width * near_z),
               double(-half_height * near_z), double(half_height * near_z), double(near_z),
               double(far_z));
    gl.MatrixMode(GL_MODELVIEW);
}

void material(float r, float g, float b, float a, float emission) {
    const GLfloat specular[] = {0.5f, 0.5f, 0.5f, 1},
                  light[] = {emission * r, emission * g, emission * b, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, light);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 64);
    gl.Color4f(r, g, b, a);
}

enum class Bodies { Opaque, WithoutFloor, Transparent, Numbers };

struct Body {
    float x, y, z, radius, r, g, b, a;
};
constexpr Body bodies[] = {{0, 0, 1, 0.9f, 0.9f, 0.4f, 0.3f, 1},
                           {1.6f, 0.6f, 0.6f, 0.5f, 0.3f, 0.7f, 0.9f, 1},
                           {-1.4f, 1.2f, 0.7f, 0.6f, 0.5f, 0.9f, 0.4f, 1},
                           {0.4f, -1.6f, 0.5f, 0.4f, 0.9f, 0.9f, 0.3f, 0.5f},
                           {-0.9f, -1.1f, 0.4f, 0.3f, 0.8f, 0.4f, 0.9f, 0.6f}};

void draw_floor(const Scene& s, float scale) {
    const GLfloat plane_s[] = {0.5f, 0, 0, 0}, plane_t[] = {0, 0.5f, 0, 0};
    gl.BindTexture(GL_TEXTURE_2D, s.floor_texture);
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane_s);
    gl.TexGenfv(GL_T, GL_OBJECT_PLANE, plane_t);
    const GLenum switches[] = {GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T};
    for (const GLenum what : switches) gl.Enable(what);
    material(scale * 0.9f, scale * 0.9f, scale * 0.9f, 1, 0);
    gl.CallList(s.lists + floor_list);
    for (const GLenum what : switches) gl.Disable(what);
}

void draw_bodies(const Scene& s, Bodies which, float scale = 1, bool textured = true) {
    if (which == Bodies::Opaque && textured) draw_floor(s, scale);
    if (which == Bodies::Opaque && !textured) gl.CallList(s.lists + floor_list);
    if (which == Bodies::Numbers) {
        gl.Color4ub(1, 0, 0, 255);
        gl.CallList(s.lists + floor_list);
    }
    GLubyte number = 2;
    for (const Body& b : bodies) {
        const bool is_opaque = b.a == 1;
        if (which == Bodies::Numbers)
            gl.Color4ub(number++, 0, 0, 255);
        else if (is_opaque == (which == Bodies::Transparent))
            continue;
        else
            material(scale * b.r, scale * b.g, scale * b.b, b.a, 0.05f);
        gl.PushMatrix();
        gl.Translatef(b.x + s.moved, b.y, b.z);
        gl.Rotatef(30 * b.x, 1, 0, 0);
        gl.Scalef(b.radius, b.radius, b.radius);
        gl.CallList(s.lists + sphere_list);
        gl.PopMatrix();
    }
    if (which == Bodies::Transparent) return;
    if (which == Bodies::Numbers)
        gl.Color4ub(number, 0, 0, 255);
    else
        material(scale * 0.7f, scale * 0.6f, scale * 0.8f, 1, 0);
    gl.Disable(GL_CULL_FACE);
    draw_skin(s);
    gl.Enable(GL_CULL_FACE);
}

void place_lights() {
    const GLfloat none[] = {0, 0, 0, 1}, head[] = {0.3f, 0.3f, 0.3f, 1},
                  bright[] = {0.55f, 0.55f, 0.5f, 1}, ahead[] = {0, 0, 1, 0};
    gl.PushMatrix();
    gl.LoadIdentity();
    gl.Lightfv(GL_LIGHT0, GL_POSITION, ahead);
    gl.PopMatrix();
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, head);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, head);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, none);
    for (GLenum i = 0; i < std::size(spots); ++i) {
        const GLenum light = GL_LIGHT1 + i;
        const Spot& spot = spots[i];
        const GLfloat toward[] = {spot.target[0] - spot.position[0],
                                  spot.target[1] - spot.position[1],
                                  spot.target[2] - spot.position[2]};
        gl.Lightfv(light, GL_POSITION, spot.position.data());
        gl.Lightfv(light, GL_SPOT_DIRECTION, toward);
        gl.Lightf(light, GL_SPOT_CUTOFF, cutoff);
        gl.Lightf(light, GL_SPOT_EXPONENT, 10);
        gl.Lightfv(light, GL_AMBIENT, none);
        gl.Lightfv(light, GL_DIFFUSE, bright);
        gl.Lightfv(light, GL_SPECULAR, bright);
    }
}

void use_light(GLenum only) {
    for (GLenum i = 0; i <= std::size(spots); ++i) gl.Disable(GL_LIGHT0 + i);
    gl.Enable(only);
}

void start(const Scene& s) {
    if (s.zero_to_one) gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    const GLfloat none[] = {0, 0, 0, 1};
    gl.Enable(GL_MULTISAMPLE);
    gl.Enable(GL_LIGHTING);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    gl.Enable(GL_NORMALIZE);
    gl.ShadeModel(GL_SMOOTH);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_BACK);
    gl.FrontFace(GL_CCW);
    gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_GEQUAL);
    gl.AlphaFunc(GL_GEQUAL, 0.99f);
    gl.ClearColor(0, 0, 0, 0);
    gl.ClearDepth(0);
    gl.Viewport(0, 0, s.options.width, s.options.height);
    gl.Scissor(0, 0, s.options.width, s.options.height);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
}

/// The camera's matrices, read back as floats: they are loaded again for each pass.
void look(Scene& s) {
    const Matrix camera = looking({5, -6, 3.5f}, {0, 0, 0.6f});
    load_reversed(s, 0.4f * float(s.options.width) / float(s.options.height), 0.4f, 0.1f, 60);
    gl.LoadMatrixf(camera.data());
    gl.GetFloatv(GL_PROJECTION_MATRIX, s.projection.data());
    gl.GetFloatv(GL_MODELVIEW_MATRIX, s.view.data());
}
void look_again(const Scene& s) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadMatrixf(s.projection.data());
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadMatrixf(s.view.data());
}

void draw_mirrored(const Scene& s) {
    const GLdouble above[] = {0, 0, 1, 0};
    gl.ClearStencil(0);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    gl.Enable(GL_STENCIL_TEST);
    gl.Disable(GL_DEPTH_TEST);
    gl.ColorMask(0, 0, 0, 0);
    gl.StencilFunc(GL_ALWAYS, 1, ~0u);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl.CallList(s.lists + floor_list);
    gl.ColorMask(1, 1, 1, 1);
    gl.Enable(GL_DEPTH_TEST);
    gl.StencilFunc(GL_EQUAL, 1, ~0u);
    gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl.PushMatrix();
    gl.Scalef(1, 1, -1);
    gl.ClipPlane(GL_CLIP_PLANE0, above);
    gl.Enable(GL_CLIP_PLANE0);
    gl.FrontFace(GL_CW);
    place_lights();
    for (GLenum i = 0; i <= std::size(spots); ++i) gl.Enable(GL_LIGHT0 + i);
    draw_bodies(s, Bodies::WithoutFloor, 0.4f);
    gl.FrontFace(GL_CCW);
    gl.Disable(GL_CLIP_PLANE0);
    gl.PopMatrix();
    gl.Disable(GL_STENCIL_TEST);
    place_lights();
}

void draw_base(const Scene& s) {
    use_light(GL_LIGHT0);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    draw_floor(s, 1);
    gl.Disable(GL_BLEND);
    draw_bodies(s, Bodies::WithoutFloor);
}

/// The depths that a light sees; its matrix from eye coordinates of the light.
Matrix draw_shadow_map(const Scene& s, const Spot& spot) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, s.shadow_framebuffer);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.Viewport(1, 1, s.options.shadow - 2, s.options.shadow - 2);
    for (const GLenum off : {GL_LIGHTING, GL_CULL_FACE}) gl.Disable(off);
    gl.ShadeModel(GL_FLAT);
    gl.ColorMask(0, 0, 0, 0);
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(s.zero_to_one ? -1.5f : -16.0f, s.zero_to_one ? -4.0f : -512.0f);
    const float half = std::tan(cutoff * 3.14159265f / 180);
    load_reversed(s, half, half, 1, 30);
    const Matrix view =
        looking({spot.position[0], spot.position[1], spot.position[2]}, spot.target);
    gl.LoadMatrixf(view.data());
    draw_bodies(s, Bodies::Opaque, 1, false);
    Matrix projection{};
    gl.GetFloatv(GL_PROJECTION_MATRIX, projection.data());
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.ColorMask(1, 1, 1, 1);
    gl.ShadeModel(GL_SMOOTH);
    for (const GLenum on : {GL_LIGHTING, GL_CULL_FACE}) gl.Enable(on);
    gl.Viewport(0, 0, s.options.width, s.options.height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, s.framebuffer);
    return product(projection, view);
}

void draw_lit(const Scene& s, GLenum light, const Matrix& light_from_world) {
    const float z = s.zero_to_one ? 1.0f : 0.5f;
    const Matrix bias{0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, z, 0, 0.5f, 0.5f, 1 - z, 1};
    const Matrix planes = product(bias, light_from_world);
    const GLenum coordinates[] = {GL_S, GL_T, GL_R, GL_Q};
    look_again(s);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.Enable(GL_TEXTURE_2D);
    for (std::size_t i = 0; i < 4; ++i) {
        const GLfloat plane[] = {planes[i], planes[4 + i], planes[8 + i], planes[12 + i]};
        gl.TexGenfv(coordinates[i], GL_EYE_PLANE, plane);
        gl.Enable(GL_TEXTURE_GEN_S + GLenum(i));
    }
    gl.ActiveTexture(GL_TEXTURE0);
    use_light(light);
    gl.Enable(GL_ALPHA_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    const GLfloat black[] = {0, 0, 0, 0};
    gl.Fogfv(GL_FOG_COLOR, black);
    draw_bodies(s, Bodies::Opaque);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_ALPHA_TEST);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.Disable(GL_TEXTURE_2D);
    for (GLenum i = 0; i < 4; ++i) gl.Disable(GL_TEXTURE_GEN_S + i);
    gl.ActiveTexture(GL_TEXTURE0);
}

void draw_sky(const Scene& s) {
    const GLfloat planes[3][4] = {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}};
    gl.Disable(GL_LIGHTING);
    gl.CullFace(GL_FRONT);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, s.sky_texture);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    for (GLenum i = 0; i < 3; ++i) {
        gl.TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        gl.TexGenfv(GL_S + i, GL_OBJECT_PLANE, planes[i]);
        gl.Enable(GL_TEXTURE_GEN_S + i);
    }
    gl.Color4f(1, 1, 1, 1);
    gl.CallList(s.lists + sky_list);
    for (GLenum i = 0; i < 3; ++i) gl.Disable(GL_TEXTURE_GEN_S + i);
    gl.Disable(GL_TEXTURE_CUBE_MAP);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.CallList(s.lists + haze_list);
    gl.CullFace(GL_BACK);
    gl.Enable(GL_LIGHTING);
}

void draw_transparent(const Scene& s) {
    for (GLenum i = 0; i <= std::size(spots); ++i) gl.Enable(GL_LIGHT0 + i);
    gl.DepthMask(0);
    draw_bodies(s, Bodies::Transparent);
    gl.DepthMask(1);
    gl.Disable(GL_BLEND);
}

}  // namespace

void draw_picture(Scene& s) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, s.framebuffer);
    start(s);
    look(s);
    place_lights();
    draw_mirrored(s);
    draw_base(s);
    for (GLenum i = 0; i < std::size(spots); ++i)
        draw_lit(s, GL_LIGHT1 + i, draw_shadow_map(s, spots[i]));
    draw_sky(s);
    draw_transparent(s);
}

void draw_numbers(const Scene& s) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const GLenum off : {GL_LIGHTING, GL_MULTISAMPLE}) gl.Disable(off);
    gl.ShadeModel(GL_FLAT);
    draw_bodies(s, Bodies::Numbers);
}

namespace {

/// Reads what was drawn by way of the framebuffer without samples.
template <class T>
std::vector<T> read(const Scene& s, GLbitfield planes, GLenum format, GLenum type, int count) {
    const int w = s.options.width, h = s.options.height;
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.framebuffer);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.resolved);
    gl.BlitFramebuffer(0, 0, w, h, 0, 0, w, h, planes, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.resolved);
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    std::vector<T> out(std::size_t(w) * std::size_t(h) * std::size_t(count));
    gl.ReadPixels(0, 0, w, h, format, type, out.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, s.framebuffer);
    return out;
}

}  // namespace

std::vector<GLubyte> read_colors(const Scene& s) {
    return read<GLubyte>(s, GL_COLOR_BUFFER_BIT, GL_RGB, GL_UNSIGNED_BYTE, 3);
}
std::vector<GLfloat> read_depths(const Scene& s) {
    return read<GLfloat>(s, GL_DEPTH_BUFFER_BIT, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
}

}  // namespace robot
