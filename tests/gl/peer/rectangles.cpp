// Steps of pixel rectangles: transfer, maps, storage, zoom; drawn, copied and read.
#include "tests/gl/peer/steps.h"

#include <algorithm>
#include <cstring>

namespace gw::gl_peer {

namespace {

constexpr GLenum color_formats[] = {GL_RED,       GL_GREEN,           GL_BLUE, GL_ALPHA,
                                    GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB,  GL_RGBA};
constexpr GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT,
                            GL_UNSIGNED_INT,  GL_INT,  GL_FLOAT};

void set_transfer(const Gl& gl, Random& random, Results&) {
    constexpr GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
    constexpr GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    const bool plain = random.chance(40);
    for (const GLenum name : scales)
        gl.PixelTransferf(name, plain ? 1 : GLfloat(random.between(-2, 8)) / 4);
    for (const GLenum name : biases)
        gl.PixelTransferf(name, plain ? 0 : GLfloat(random.between(-4, 4)) / 8);
    gl.PixelTransferf(GL_DEPTH_SCALE, plain ? 1 : GLfloat(random.between(1, 6)) / 4);
    gl.PixelTransferf(GL_DEPTH_BIAS, plain ? 0 : GLfloat(random.between(-2, 2)) / 8);
    gl.PixelTransferi(GL_INDEX_SHIFT, plain ? 0 : random.between(-2, 2));
    gl.PixelTransferi(GL_INDEX_OFFSET, plain ? 0 : random.between(0, 3));
}

/// The maps of indices. Those of colours are left out: Mesa looks them up as textures, which have
/// other entries.
void set_maps(const Gl& gl, Random& random, Results&) {
    const int size = 1 << random.between(0, 5);
    for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_I_TO_A; ++map) {
        const bool is_index = map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S;
        std::vector<GLfloat> values;
        for (int i = 0; i < size; ++i)
            values.push_back(is_index ? GLfloat(random.below(16))
                                      : GLfloat(random.below(256)) / 255);
        gl.PixelMapfv(map, size, values.data());
    }
    gl.PixelTransferi(GL_MAP_STENCIL, random.chance(30) ? 1 : 0);
}

/// Neither swapped bytes nor wide alignments: Mesa takes other rows then.
void set_storage(const Gl& gl, Random& random, Results&) {
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << random.below(3));
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, random.chance(50) ? 0 : random.between(1, 40));
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, random.chance(60) ? 0 : random.below(4));
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, random.chance(60) ? 0 : random.below(12));
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, random.chance(40) ? 1 : 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1 << random.below(4));
    gl.PixelStorei(GL_PACK_ROW_LENGTH, random.chance(50) ? 0 : random.between(1, 40));
    gl.PixelStorei(GL_PACK_SKIP_ROWS, random.chance(60) ? 0 : random.below(4));
    gl.PixelStorei(GL_PACK_SKIP_PIXELS, random.chance(60) ? 0 : random.below(12));
    gl.PixelStorei(GL_PACK_LSB_FIRST, random.chance(40) ? 1 : 0);
}

void set_zoom(const Gl& gl, Random& random, Results&) {
    const auto factor = [&] { return random.pick<GLfloat>({1, 1, 1, 2, 3, -1, -2}); };
    const GLfloat x = factor();
    gl.PixelZoom(x, factor());
}

void set_raster_position(const Gl& gl, Random& random, Results&) {
    const auto x = GLfloat(random.real(-1.1, 1.1)), y = GLfloat(random.real(-1.1, 1.1));
    gl.Color4fv(some_color(random).data());
    gl.RasterPos3f(x, y, GLfloat(random.real(-1, 1)));
}

/// Mesa draws and copies indices without transfer.
void leave_indices(const Gl& gl) {
    gl.PixelTransferi(GL_INDEX_SHIFT, 0);
    gl.PixelTransferi(GL_INDEX_OFFSET, 0);
    gl.PixelTransferi(GL_MAP_STENCIL, 0);
}

/// Mesa takes colour indices in rows without padding, and reads behind them if they have a length.
void leave_storage(const Gl& gl) {
    for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS})
        gl.PixelStorei(name, 0);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

/// Mesa's fragments of depths have no texture.
void leave_textures(const Gl& gl) {
    gl.Disable(GL_TEXTURE_1D);
    gl.Disable(GL_TEXTURE_2D);
}

/// Mesa generates and transforms the coordinates of rectangles, as if the raster position had not.
void leave_coordinates(const Gl& gl) {
    gl.Disable(GL_TEXTURE_GEN_S);
    gl.Disable(GL_TEXTURE_GEN_T);
    gl.MatrixMode(GL_TEXTURE);
    gl.LoadIdentity();
    gl.MatrixMode(GL_MODELVIEW);
}

/// Mesa's texture environment takes negative colours.
GLenum clamped(const Gl& gl, GLenum type) {
    const bool is_signed = type == GL_BYTE || type == GL_SHORT || type == GL_INT;
    const bool has_texture = gl.IsEnabled(GL_TEXTURE_1D) || gl.IsEnabled(GL_TEXTURE_2D);
    return is_signed && has_texture ? GL_UNSIGNED_BYTE : type;
}

/// Bytes that are numbers of 0 .. 1 as floats too.
std::vector<GLfloat> some_floats(Random& random, std::size_t count) {
    std::vector<GLfloat> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(GLfloat(random.below(1024)) / 1023);
    return out;
}
std::vector<GLubyte> some_memory(Random& random, GLenum type) {
    std::vector<GLubyte> out(48 * 48 * 16);
    if (type == GL_FLOAT) {
        const std::vector<GLfloat> floats = some_floats(random, out.size() / 4);
        const auto* bytes = reinterpret_cast<const GLubyte*>(floats.data());
        out.assign(bytes, bytes + out.size());
    } else {
        for (GLubyte& byte : out) byte = GLubyte(random.below(256));
    }
    return out;
}

}  // namespace

std::span<const StepKind> pixel_steps() {
    static constexpr StepKind kinds[] = {{"transfer", set_transfer},
                                         {"maps", set_maps},
                                         {"storage", set_storage},
                                         {"zoom", set_zoom},
                                         {"raster position", set_raster_position},
                                         {"raster position", set_raster_position}};
    return kinds;
}

void draw_rectangle(const Gl& gl, Random& random, Results& out) {
    const int width = random.between(0, 14), height = random.between(0, 10);
    GLenum type = types[random.below(int(std::size(types)))];
    const int what = random.below(10);
    const GLenum format = what < 7    ? color_formats[random.below(int(std::size(color_formats)))]
                          : what == 7 ? GL_DEPTH_COMPONENT
                          : what == 8 ? GL_STENCIL_INDEX
                                      : GL_COLOR_INDEX;
    if (format == GL_STENCIL_INDEX || format == GL_COLOR_INDEX) type = GL_UNSIGNED_BYTE;
    if (format == GL_COLOR_INDEX) leave_storage(gl);
    if (format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX) leave_indices(gl);
    if (format == GL_DEPTH_COMPONENT) leave_textures(gl);
    const std::vector<GLubyte> memory = some_memory(random, type);
    use_one_texture(gl);
    leave_coordinates(gl);
    type = clamped(gl, type);
    if (random.chance(25))
        gl.Bitmap(width, height, GLfloat(random.below(4)), 1, 8, 0, memory.data());
    else
        gl.DrawPixels(width, height, format, type, memory.data());
    look(gl, out);
}

/// Inside the window: the values of other pixels are undefined.
void draw_copy(const Gl& gl, Random& random, Results& out) {
    const int x = random.below(window_width - 16), y = random.below(window_height - 16);
    const int width = random.between(0, 16), height = random.between(0, 16);
    const GLenum type = random.pick<GLenum>({GL_COLOR, GL_COLOR, GL_DEPTH, GL_STENCIL});
    if (type == GL_STENCIL) leave_indices(gl);
    gl.CopyPixels(x, y, width, height, type);
    look(gl, out);
}

void read_rectangle(const Gl& gl, Random& random, Results& out) {
    const int x = random.below(window_width - 16), y = random.below(window_height - 16);
    const int width = random.between(0, 16), height = random.between(0, 16);
    const int what = random.below(10);
    const GLenum format = what < 7    ? color_formats[random.below(int(std::size(color_formats)))]
                          : what == 7 ? GL_DEPTH_COMPONENT
                                      : GL_STENCIL_INDEX;
    const GLenum type = what < 8 ? GL_FLOAT : GL_UNSIGNED_BYTE;
    std::vector<GLubyte> memory(48 * 48 * 16);
    gl.ReadPixels(x, y, width, height, format, type, memory.data());
    out.values.push_back({"error", {double(gl.GetError())}});
    Values read{"pixels", {}, 2.0 / 255};
    if (type == GL_UNSIGNED_BYTE)
        read.values.assign(memory.begin(), memory.end());
    else
        for (std::size_t i = 0; i < memory.size(); i += sizeof(GLfloat)) {
            GLfloat value = 0;  // Mesa clamps integers only
            std::memcpy(&value, &memory[i], sizeof value);
            read.values.push_back(std::clamp(double(value), 0.0, 1.0));
        }
    out.values.push_back(std::move(read));
}

}  // namespace gw::gl_peer
