// Steps of texture units: on each a texture of one texel, of any kind, and an environment that may read
// those of the other units.
#include "tests/gl/peer/steps.h"

namespace gw::gl_peer {

namespace {

constexpr GLenum kinds[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};

/// An image of one texel; of a cube, six of them.
void set_texel(const Gl& gl, Random& random, GLenum target) {
    const GLint format =
        random.pick<GLint>({GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_INTENSITY8, GL_LUMINANCE8_ALPHA8});
    const auto color = [&] { return some_color(random); };
    switch (target) {
        case GL_TEXTURE_1D:
            return gl.TexImage1D(target, 0, format, 1, 0, GL_RGBA, GL_FLOAT, color().data());
        case GL_TEXTURE_2D:
            return gl.TexImage2D(target, 0, format, 1, 1, 0, GL_RGBA, GL_FLOAT, color().data());
        case GL_TEXTURE_3D:
            return gl.TexImage3D(target, 0, format, 1, 1, 1, 0, GL_RGBA, GL_FLOAT, color().data());
    }
    for (GLenum face = 0; face < 6; ++face)
        gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, format, 1, 1, 0, GL_RGBA, GL_FLOAT,
                      color().data());
}

/// A depth of 1/2, compared with another r.
void set_depth(const Gl& gl, Random& random) {
    constexpr GLfloat half = 0.5f;
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  &half);
    const auto set = [&](GLenum name, GLenum value) {
        gl.TexParameteri(GL_TEXTURE_2D, name, GLint(value));
    };
    set(GL_TEXTURE_COMPARE_MODE, random.chance(80) ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
    set(GL_TEXTURE_COMPARE_FUNC, GLenum(GL_NEVER + random.below(8)));
    set(GL_DEPTH_TEXTURE_MODE, random.pick<GLenum>({GL_LUMINANCE, GL_INTENSITY, GL_ALPHA}));
}

/// All units have textures: what the texture of a unit that is off gives is open.
void set_combine(const Gl& gl, Random& random) {
    const auto set = [&](GLenum name, GLint value) { gl.TexEnvi(GL_TEXTURE_ENV, name, value); };
    set(GL_COMBINE_RGB,
        random.pick<GLint>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE,
                            GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA}));
    set(GL_COMBINE_ALPHA, random.pick<GLint>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_INTERPOLATE}));
    for (GLenum i = 0; i < 3; ++i)
        for (const GLenum name : {GL_SOURCE0_RGB, GL_SOURCE0_ALPHA})
            set(name + i,
                random.pick<GLint>({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS,
                                    GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE3}));
}

void set_unit(const Gl& gl, Random& random, GLenum unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum target : kinds) gl.Disable(target);
    // Shapes give unit 0 coordinates of their own.
    const GLenum target = unit == 0 ? GL_TEXTURE_2D : kinds[random.below(4)];
    gl.BindTexture(target, 100 + 10 * unit +
                               (target == GL_TEXTURE_3D         ? 2
                                : target == GL_TEXTURE_CUBE_MAP ? 3
                                                                : target & 1));
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(target, name, GL_NEAREST);
    if (unit != 0 && target == GL_TEXTURE_2D && random.chance(60))
        set_depth(gl, random);
    else
        set_texel(gl, random, target);
    gl.Enable(target);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
               random.pick<GLint>({GL_MODULATE, GL_REPLACE, GL_ADD, GL_BLEND, GL_COMBINE}));
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, some_color(random).data());
    set_combine(gl, random);
}

/// A direction off the edges of a cube, and an r that is not 1/2.
void set_coordinates(const Gl& gl, Random& random, Results&) {
    for (GLenum unit = 1; unit < 4; ++unit) {
        GLfloat v[] = {0.375f, -0.125f, random.chance(50) ? 0.25f : 0.75f, 1};
        if (random.chance(60)) v[random.below(2)] = random.chance(50) ? 2.0f : -2.0f;
        gl.MultiTexCoord4fv(GL_TEXTURE0 + unit, v);
    }
}

/// A cube has no texel at the first coordinates, which are 0.
void set_units(const Gl& gl, Random& random, Results& out) {
    for (GLenum unit = 0; unit < 4; ++unit) set_unit(gl, random, unit);
    gl.ActiveTexture(GL_TEXTURE0);
    set_coordinates(gl, random, out);
}

}  // namespace

std::span<const StepKind> unit_steps() {
    static constexpr StepKind steps[] = {{"units", set_units}, {"coordinates", set_coordinates}};
    return steps;
}

}  // namespace gw::gl_peer
