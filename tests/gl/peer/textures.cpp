// Steps of textures: images of all formats, environment, filters, coordinates; copies and reads.
#include "tests/gl/peer/steps.h"

namespace gw::gl_peer {

namespace {

constexpr GLenum formats[] = {GL_RED,       GL_GREEN,           GL_BLUE, GL_ALPHA,
                              GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB,  GL_RGBA};
constexpr GLint internal_formats[] = {GL_ALPHA8,
                                      GL_LUMINANCE8,
                                      GL_LUMINANCE8_ALPHA8,
                                      GL_INTENSITY8,
                                      GL_RGB8,
                                      GL_RGBA8,
                                      GL_ALPHA,
                                      GL_LUMINANCE,
                                      GL_LUMINANCE_ALPHA,
                                      GL_INTENSITY,
                                      GL_RGB,
                                      GL_RGBA,
                                      1,
                                      2,
                                      3,
                                      4};

GLenum some_target(Random& random) { return random.chance(25) ? GL_TEXTURE_1D : GL_TEXTURE_2D; }

std::vector<GLubyte> some_bytes(Random& random, int count) {
    std::vector<GLubyte> out;
    for (int i = 0; i < count; ++i) out.push_back(GLubyte(random.below(256)));
    return out;
}

/// Transfer and storage are the program's. Without a border, which Mesa takes off.
/// One filter: where it changes to the other, Mesa decides for four pixels at once.
void set_image(const Gl& gl, Random& random, Results&) {
    const GLenum target = some_target(random);
    const int width = random.between(1, 16), height = random.between(1, 16);
    const GLenum format = formats[random.below(int(std::size(formats)))];
    const GLint internal = internal_formats[random.below(int(std::size(internal_formats)))];
    const std::vector<GLubyte> bytes = some_bytes(random, 4 * 64 * 64);
    gl.BindTexture(target, GLuint(random.below(4)) + (target == GL_TEXTURE_1D ? 10 : 20));
    if (target == GL_TEXTURE_1D)
        gl.TexImage1D(target, 0, internal, width, 0, format, GL_UNSIGNED_BYTE, bytes.data());
    else
        gl.TexImage2D(target, 0, internal, width, height, 0, format, GL_UNSIGNED_BYTE,
                      bytes.data());
    const GLint filter = random.chance(50) ? GL_NEAREST : GL_LINEAR;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl.TexParameteri(target, name,
                         random.pick<GLint>({GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
                                             GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
    gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, some_color(random).data());
}

void set_part(const Gl& gl, Random& random, Results&) {
    const std::vector<GLubyte> bytes = some_bytes(random, 4 * 16 * 16);
    const int x = random.below(4), y = random.below(4);
    const int width = random.below(5), height = random.below(5);
    const GLenum format = formats[random.below(int(std::size(formats)))];
    if (random.chance(25))
        gl.TexSubImage1D(GL_TEXTURE_1D, 0, x, width, format, GL_UNSIGNED_BYTE, bytes.data());
    else
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, format, GL_UNSIGNED_BYTE,
                         bytes.data());
}

/// Without GL_DECAL, whose effect is open for most formats.
void set_environment(const Gl& gl, Random& random, Results&) {
    const GLenum target = some_target(random);
    random.chance(70) ? gl.Enable(target) : gl.Disable(target);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
               random.pick<GLint>({GL_MODULATE, GL_BLEND, GL_REPLACE, GL_ADD}));
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, some_color(random).data());
}

/// Without the largest scale, which makes differences larger than those that are allowed.
void set_combine(const Gl& gl, Random& random, Results&) {
    const auto set = [&](GLenum name, GLint value) { gl.TexEnvi(GL_TEXTURE_ENV, name, value); };
    set(GL_TEXTURE_ENV_MODE, GL_COMBINE);
    for (const GLenum name : {GL_COMBINE_RGB, GL_COMBINE_ALPHA})
        set(name, random.pick<GLint>({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED,
                                      GL_INTERPOLATE, GL_SUBTRACT}));
    for (GLenum i = 0; i < 3; ++i) {
        for (const GLenum name : {GL_SOURCE0_RGB, GL_SOURCE0_ALPHA})
            set(name + i,
                random.pick<GLint>({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}));
        set(GL_OPERAND0_RGB + i, random.pick<GLint>({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR,
                                                     GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
        set(GL_OPERAND0_ALPHA + i, random.pick<GLint>({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
    }
    set(GL_RGB_SCALE, random.chance(50) ? 1 : 2);
    set(GL_ALPHA_SCALE, random.chance(50) ? 1 : 2);
}

/// Both planes: with the first ones, centres of pixels would be on the sides of texels.
void set_generation(const Gl& gl, Random& random, Results&) {
    const GLenum coord = random.chance(50) ? GL_S : GL_T;
    const GLenum cap = coord == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T;
    random.chance(60) ? gl.Enable(cap) : gl.Disable(cap);
    gl.TexGeni(coord, GL_TEXTURE_GEN_MODE,
               random.pick<GLint>({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP}));
    for (const GLenum name : {GL_OBJECT_PLANE, GL_EYE_PLANE}) {
        const auto a = GLfloat(random.real(-1, 1)), b = GLfloat(random.real(-1, 1));
        const GLfloat plane[] = {a, b, GLfloat(random.real(-1, 1)), GLfloat(random.real(0, 1))};
        gl.TexGenfv(coord, name, plane);
    }
}

void set_matrix(const Gl& gl, Random& random, Results&) {
    gl.MatrixMode(GL_TEXTURE);
    gl.LoadIdentity();
    if (random.chance(60)) {
        gl.Rotatef(GLfloat(random.between(0, 90)), 0, 0, 1);
        gl.Scalef(GLfloat(random.between(1, 8)) / 4, 1.25f, 1);
    }
    gl.MatrixMode(GL_MODELVIEW);
}

void delete_texture(const Gl& gl, Random& random, Results&) {
    const GLuint name = GLuint(random.between(10, 24));
    gl.DeleteTextures(1, &name);
}

}  // namespace

std::span<const StepKind> texture_steps() {
    static constexpr StepKind kinds[] = {{"image", set_image},
                                         {"image", set_image},
                                         {"part", set_part},
                                         {"environment", set_environment},
                                         {"environment", set_environment},
                                         {"combine", set_combine},
                                         {"generation", set_generation},
                                         {"texture matrix", set_matrix},
                                         {"delete texture", delete_texture}};
    return kinds;
}

void use_one_texture(const Gl& gl) {
    GLint width = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    if (width == 0 && gl.IsEnabled(GL_TEXTURE_2D)) gl.Disable(GL_TEXTURE_1D);
}

/// Draws, then makes a texture or a part of one of the window.
void copy_to_texture(const Gl& gl, Random& random, Results& out) {
    const int x = random.below(16), y = random.below(16);
    const GLint internal = random.pick<GLint>(
        {GL_RGB, GL_RGBA, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGBA8});
    const int part_x = random.below(8), part_y = random.below(8), size = random.below(8);
    if (random.chance(60)) {
        gl.BindTexture(GL_TEXTURE_2D, 20);
        gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GLenum(internal), x, y, 16, 8, 0);
    } else if (random.chance(50)) {
        gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, part_x, part_y, x, y, size, size);
    } else {
        gl.BindTexture(GL_TEXTURE_1D, 10);
        gl.CopyTexImage1D(GL_TEXTURE_1D, 0, GLenum(internal), x, y, 16, 0);
        gl.CopyTexSubImage1D(GL_TEXTURE_1D, 0, part_x, y, x, size);
    }
    read_texture(gl, random, out);
}

/// Not as luminance: Mesa takes red for it, not the sum.
void read_texture(const Gl& gl, Random& random, Results& out) {
    const GLenum target = some_target(random);
    const GLenum format =
        random.pick<GLenum>({GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA});
    std::vector<GLfloat> texels(4 * 40 * 40);
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (const GLenum name :
         {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES})
        gl.PixelStorei(name, 0);
    gl.GetTexImage(target, 0, format, GL_FLOAT, texels.data());
    gl.PopClientAttrib();
    out.values.push_back({"error", {double(gl.GetError())}});
    out.values.push_back({"texels", {texels.begin(), texels.end()}, 2.0 / 255});
    for (const GLenum name : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER}) {
        GLint value = -1;
        gl.GetTexLevelParameteriv(target, 0, name, &value);
        out.values.push_back({"level parameter", {double(value)}});
    }
}

}  // namespace gw::gl_peer
