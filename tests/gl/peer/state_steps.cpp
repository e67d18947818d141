// Steps that set state: transform, rasterization, lighting, fragments.
#include "tests/gl/peer/steps.h"

#include <cmath>

namespace gw::gl_peer {

namespace {

void switch_to(const Gl& gl, GLenum cap, bool on) { on ? gl.Enable(cap) : gl.Disable(cap); }

void set_projection(const Gl& gl, Random& random, Results&) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (random.chance(40))
        gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 4);
    else
        gl.Ortho(-1, 1, -1, 1, 0.5, 3.5);
    gl.MatrixMode(GL_MODELVIEW);
}

void set_modelview(const Gl& gl, Random& random, Results&) {
    gl.LoadIdentity();
    gl.Translatef(0, 0, -2);
    if (random.chance(50))
        gl.Translatef(GLfloat(random.between(-4, 4)) / 16, GLfloat(random.between(-4, 4)) / 16, 0);
    if (random.chance(50)) gl.Rotatef(GLfloat(random.between(0, 360)), 0, 0, 1);
    if (random.chance(25)) gl.Rotatef(GLfloat(random.between(-60, 60)), 1, 0.5f, 0);
    if (random.chance(50)) gl.Scalef(GLfloat(random.between(4, 12)) / 8, 0.75f, 1);
}

void set_viewport(const Gl& gl, Random& random, Results&) {
    if (random.chance(50))
        gl.Viewport(0, 0, window_width, window_height);
    else
        gl.Viewport(random.between(-8, 8), random.between(-8, 8), random.between(16, 64),
                    random.between(16, 64));
    const double near = random.real(0, 1), far = random.real(0, 1);
    random.chance(50) ? gl.DepthRange(0, 1) : gl.DepthRange(near, far);
}

void set_clip_plane(const Gl& gl, Random& random, Results&) {
    const GLenum plane = GL_CLIP_PLANE0 + GLenum(random.below(6));
    const double a = random.real(-1, 1), b = random.real(-1, 1), c = random.real(-1, 1);
    const double equation[] = {a, b, c, random.real(0, 0.6)};
    gl.ClipPlane(plane, equation);
    switch_to(gl, plane, random.chance(60));
}

void set_sizes(const Gl& gl, Random& random, Results&) {
    gl.PointSize(GLfloat(random.between(1, 5)));
    gl.LineWidth(GLfloat(random.chance(70) ? 1 : random.between(2, 4)));
}

void set_faces(const Gl& gl, Random& random, Results&) {
    gl.FrontFace(random.pick<GLenum>({GL_CW, GL_CCW}));
    gl.CullFace(random.pick<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
    switch_to(gl, GL_CULL_FACE, random.chance(25));
    gl.PolygonOffset(GLfloat(random.between(-2, 2)), GLfloat(random.between(-64, 64)));
    switch_to(gl, GL_POLYGON_OFFSET_FILL, random.chance(30));
}

void set_polygon_mode(const Gl& gl, Random& random, Results&) {
    const GLenum face = random.pick<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
    gl.PolygonMode(face, random.pick<GLenum>({GL_FILL, GL_FILL, GL_LINE, GL_POINT}));
}

/// Not of lines: Mesa cuts them into pieces, whose ends are other pixels.
void set_stipple(const Gl& gl, Random& random, Results&) {
    std::array<GLubyte, 128> pattern;
    for (GLubyte& byte : pattern) byte = GLubyte(random.below(256));
    gl.PolygonStipple(pattern.data());
    switch_to(gl, GL_POLYGON_STIPPLE, random.chance(40));
}

void set_shade_model(const Gl& gl, Random& random, Results&) {
    gl.ShadeModel(random.chance(40) ? GL_FLAT : GL_SMOOTH);
}

void set_light(const Gl& gl, Random& random, Results&) {
    const GLenum light = GL_LIGHT0 + GLenum(random.below(8));
    switch_to(gl, light, random.chance(75));
    gl.Lightfv(light, GL_AMBIENT, some_color(random).data());
    gl.Lightfv(light, GL_DIFFUSE, some_color(random).data());
    gl.Lightfv(light, GL_SPECULAR, some_color(random).data());
    const auto x = GLfloat(random.real(-2, 2)), y = GLfloat(random.real(-2, 2));
    const GLfloat position[] = {x, y, GLfloat(random.real(0.5, 3)),
                                random.chance(50) ? 1.0f : 0.0f};
    gl.Lightfv(light, GL_POSITION, position);
    if (random.chance(40)) {
        gl.Lightf(light, GL_CONSTANT_ATTENUATION, GLfloat(random.real(0.5, 2)));
        gl.Lightf(light, GL_LINEAR_ATTENUATION, GLfloat(random.real(0, 1)));
        gl.Lightf(light, GL_QUADRATIC_ATTENUATION, GLfloat(random.real(0, 1)));
    }
    const GLfloat direction[] = {-x, -y, -2};
    gl.Lightfv(light, GL_SPOT_DIRECTION, direction);
    gl.Lightf(light, GL_SPOT_EXPONENT, GLfloat(random.between(0, 10)));
    gl.Lightf(light, GL_SPOT_CUTOFF, random.chance(60) ? 180.0f : GLfloat(random.between(20, 90)));
}

/// Mesa keeps given materials aside, and puts them over the colours of COLOR_MATERIAL later. A query
/// puts them in place.
void set_material(const Gl& gl, Random& random, Results&) {
    const GLenum face = random.pick<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
        if (random.chance(50)) gl.Materialfv(face, name, some_color(random).data());
    gl.Materialf(face, GL_SHININESS, GLfloat(random.between(0, 128)));
    std::array<GLfloat, 4> placed;
    gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, placed.data());
}

/// Without colours for GL_BACK alone: with a light, some of Mesa's channels are then those of others.
void set_light_model(const Gl& gl, Random& random, Results&) {
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, some_color(random).data());
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, random.below(2));
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, random.below(2));
    switch_to(gl, GL_NORMALIZE, random.chance(70));
    gl.ColorMaterial(random.pick<GLenum>({GL_FRONT, GL_FRONT_AND_BACK}),
                     random.pick<GLenum>({GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                          GL_AMBIENT_AND_DIFFUSE}));
    switch_to(gl, GL_COLOR_MATERIAL, random.chance(40));
}

void set_fog(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_FOG, random.chance(50));
    gl.Fogi(GL_FOG_MODE, random.pick<GLint>({GL_LINEAR, GL_EXP, GL_EXP2}));
    gl.Fogf(GL_FOG_DENSITY, GLfloat(random.real(0, 2)));
    gl.Fogf(GL_FOG_START, GLfloat(random.real(0, 1)));
    gl.Fogf(GL_FOG_END, GLfloat(random.real(1, 3)));
    gl.Fogfv(GL_FOG_COLOR, some_color(random).data());
}

GLenum some_func(Random& random) { return GL_NEVER + GLenum(random.between(1, 7)); }

void set_depth(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_DEPTH_TEST, random.chance(70));
    gl.DepthFunc(random.pick<GLenum>({GL_LESS, GL_GREATER, GL_LEQUAL, GL_GEQUAL, GL_ALWAYS}));
    gl.DepthMask(random.chance(80) ? GL_TRUE : GL_FALSE);
}

void set_stencil(const Gl& gl, Random& random, Results&) {
    const auto op = [&] {
        return random.pick<GLenum>({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT});
    };
    switch_to(gl, GL_STENCIL_TEST, random.chance(60));
    gl.StencilFunc(some_func(random), random.below(4), GLuint(random.pick({255, 3, 1})));
    const GLenum fail = op(), zfail = op();
    gl.StencilOp(fail, zfail, op());
    gl.StencilMask(GLuint(random.chance(70) ? 255 : random.below(256)));
}

void set_alpha(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_ALPHA_TEST, random.chance(40));
    gl.AlphaFunc(random.pick<GLenum>({GL_LESS, GL_GREATER, GL_ALWAYS}),
                 GLfloat(random.real(0.2, 0.8)));
}

void set_blend(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_BLEND, random.chance(60));
    const GLenum source = random.pick<GLenum>(
        {GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA,
         GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA_SATURATE});
    gl.BlendFunc(source, random.pick<GLenum>({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
                                              GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA,
                                              GL_ONE_MINUS_DST_ALPHA}));
}

/// Alpha has a rule of its own; colours are factors of both sides. [GL14] 4.1.7
void set_separate_blend(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_BLEND, random.chance(80));
    const auto factor = [&] {
        return random.pick<GLenum>({GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR,
                                    GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                                    GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA});
    };
    const auto equation = [&] {
        return random.pick<GLenum>(
            {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX});
    };
    const GLenum src_rgb = factor(), dst_rgb = factor(), src_alpha = factor();
    gl.BlendFuncSeparate(src_rgb, dst_rgb, src_alpha, factor());
    const GLenum rgb = equation();
    gl.BlendEquationSeparate(rgb, equation());
}

void set_logic_op(const Gl& gl, Random& random, Results&) {
    switch_to(gl, GL_COLOR_LOGIC_OP, random.chance(30));
    gl.LogicOp(random.pick<GLenum>({GL_COPY, GL_SET, GL_CLEAR, GL_INVERT, GL_NOOP}));
}

void set_masks(const Gl& gl, Random& random, Results&) {
    const auto flag = [&]() -> GLboolean { return random.chance(75) ? GL_TRUE : GL_FALSE; };
    const GLboolean r = flag(), g = flag(), b = flag();
    gl.ColorMask(r, g, b, flag());
    switch_to(gl, GL_SCISSOR_TEST, random.chance(50));
    gl.Scissor(random.between(-4, 20), random.between(-4, 20), random.between(0, 48),
               random.between(0, 48));
}

void clear(const Gl& gl, Random& random, Results&) {
    const std::array<GLfloat, 4> color = some_color(random);
    gl.ClearColor(color[0], color[1], color[2], color[3]);
    gl.ClearDepth(random.chance(60) ? 1 : random.real(0, 1));
    gl.ClearStencil(random.below(4));
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/// Mesa 22.3 restores with GL_ENABLE_BIT alone not which lights are enabled.
void nest_attributes(const Gl& gl, Random& random, Results&) {
    if (!random.chance(50)) return gl.PopAttrib();
    GLbitfield mask = GLbitfield(random.next()) & GL_ALL_ATTRIB_BITS;
    if ((mask & GL_ENABLE_BIT) != 0) mask |= GL_LIGHTING_BIT;
    gl.PushAttrib(mask);
}

void nest_matrices(const Gl& gl, Random& random, Results&) {
    gl.MatrixMode(random.pick<GLenum>({GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
    random.chance(50) ? gl.PushMatrix() : gl.PopMatrix();
    gl.MatrixMode(GL_MODELVIEW);
}

}  // namespace

std::span<const StepKind> transform_steps() {
    static constexpr StepKind kinds[] = {
        {"projection", set_projection},  {"modelview", set_modelview},
        {"viewport", set_viewport},      {"clip plane", set_clip_plane},
        {"attributes", nest_attributes}, {"matrices", nest_matrices}};
    return kinds;
}

std::span<const StepKind> rasterization_steps() {
    static constexpr StepKind kinds[] = {
        {"faces", set_faces}, {"stipple", set_stipple}, {"shade model", set_shade_model}};
    return kinds;
}

std::span<const StepKind> size_steps() {
    static constexpr StepKind kinds[] = {{"sizes", set_sizes},
                                         {"faces", set_faces},
                                         {"polygon mode", set_polygon_mode},
                                         {"shade model", set_shade_model}};
    return kinds;
}

std::span<const StepKind> lighting_steps() {
    static constexpr StepKind kinds[] = {
        {"light", set_light}, {"material", set_material}, {"light model", set_light_model}};
    return kinds;
}

std::span<const StepKind> fragment_steps() {
    static constexpr StepKind kinds[] = {
        {"fog", set_fog},           {"depth", set_depth}, {"stencil", set_stencil},
        {"alpha", set_alpha},       {"blend", set_blend}, {"separate blend", set_separate_blend},
        {"logic op", set_logic_op}, {"masks", set_masks}, {"clear", clear}};
    return kinds;
}

}  // namespace gw::gl_peer
