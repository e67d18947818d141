// PixelStore, PixelTransfer, PixelMap, PixelZoom. [GL11] 3.6.1 to 3.6.3
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/draw/submit.h"
#include "gl/pixels/memory.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::gl {

namespace {

int rounded(double v) { return int(clamped(std::floor(finite(v) + 0.5), -0x1p30, 0x1p30)); }

bool is_map(GLenum map) { return map >= GL_PIXEL_MAP_I_TO_I && map <= GL_PIXEL_MAP_A_TO_A; }
/// I_TO_I and S_TO_S hold indices.
bool holds_indices(GLenum map) { return map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S; }

template <class T>
Numbers map_numbers(GLenum map, GLsizei size, const T* values) {
    auto out = std::make_shared<std::vector<double>>();
    Context* const context = bound_context();
    if (context == nullptr || !is_map(map) || size < 1 || size > max_pixel_map) return out;
    const auto lock = context->shared->exclusive();
    values = reinterpret_cast<const T*>(
        values_memory(*context, context->client.unpack, std::size_t(size), sizeof(T), values));
    if (values == nullptr) return out;
    for (GLsizei i = 0; i < size; ++i)
        out->push_back(std::is_integral_v<T> && !holds_indices(map) ? unit(values[i])
                                                                    : double(values[i]));
    return out;
}

void set_store(Context& context, GLint& field, int value, bool valid) {
    if (!valid) return set_error(context, GL_INVALID_VALUE);
    field = value;
}

void set_store(Context& context, PixelStore& s, GLenum what, double param) {
    const int value = rounded(param);
    switch (what) {
        case GL_UNPACK_SWAP_BYTES: s.swap_bytes = param != 0; return;
        case GL_UNPACK_LSB_FIRST: s.lsb_first = param != 0; return;
        case GL_UNPACK_ROW_LENGTH: return set_store(context, s.row_length, value, value >= 0);
        case GL_UNPACK_SKIP_ROWS: return set_store(context, s.skip_rows, value, value >= 0);
        case GL_UNPACK_SKIP_PIXELS: return set_store(context, s.skip_pixels, value, value >= 0);
        case GL_UNPACK_ALIGNMENT:
            return set_store(context, s.alignment, value,
                             value == 1 || value == 2 || value == 4 || value == 8);
    }
}

}  // namespace

Numbers map_values(GLenum map, GLsizei size, const GLfloat* values) {
    return map_numbers(map, size, values);
}
Numbers map_values(GLenum map, GLsizei size, const GLuint* values) {
    return map_numbers(map, size, values);
}
Numbers map_values(GLenum map, GLsizei size, const GLushort* values) {
    return map_numbers(map, size, values);
}

namespace execute {

void pixel_store(Context& context, GLenum pname, double param) {
    const int value = rounded(param);
    switch (pname) {
        case GL_PACK_SKIP_IMAGES:
            return set_store(context, context.client.pack.skip_images, value, value >= 0);
        case GL_PACK_IMAGE_HEIGHT:
            return set_store(context, context.client.pack.image_height, value, value >= 0);
        case GL_UNPACK_SKIP_IMAGES:
            return set_store(context, context.client.unpack.skip_images, value, value >= 0);
        case GL_UNPACK_IMAGE_HEIGHT:
            return set_store(context, context.client.unpack.image_height, value, value >= 0);
    }
    if (pname >= GL_UNPACK_SWAP_BYTES && pname <= GL_UNPACK_ALIGNMENT)
        return set_store(context, context.client.unpack, pname, param);
    if (pname >= GL_PACK_SWAP_BYTES && pname <= GL_PACK_ALIGNMENT)
        return set_store(context, context.client.pack,
                         pname - GL_PACK_SWAP_BYTES + GL_UNPACK_SWAP_BYTES, param);
    set_error(context, GL_INVALID_ENUM);
}

void pixel_transfer(Context& context, GLenum pname, double param) {
    PixelState& s = context.state.pixel;
    const auto value = float(finite(param));
    switch (pname) {
        case GL_MAP_COLOR: s.map_color = param != 0; return;
        case GL_MAP_STENCIL: s.map_stencil = param != 0; return;
        case GL_INDEX_SHIFT: s.index_shift = rounded(param); return;
        case GL_INDEX_OFFSET: s.index_offset = rounded(param); return;
        case GL_RED_SCALE: s.scale.x = value; return;
        case GL_RED_BIAS: s.bias.x = value; return;
        case GL_GREEN_SCALE: s.scale.y = value; return;
        case GL_GREEN_BIAS: s.bias.y = value; return;
        case GL_BLUE_SCALE: s.scale.z = value; return;
        case GL_BLUE_BIAS: s.bias.z = value; return;
        case GL_ALPHA_SCALE: s.scale.w = value; return;
        case GL_ALPHA_BIAS: s.bias.w = value; return;
        case GL_DEPTH_SCALE: s.depth_scale = value; return;
        case GL_DEPTH_BIAS: s.depth_bias = value; return;
    }
    set_error(context, GL_INVALID_ENUM);
}

void pixel_map(Context& context, GLenum map, GLsizei size, const Numbers& values) {
    if (!is_map(map)) return set_error(context, GL_INVALID_ENUM);
    const bool by_index = map <= GL_PIXEL_MAP_I_TO_A;
    if (size < 1 || size > max_pixel_map || (by_index && !std::has_single_bit(unsigned(size))))
        return set_error(context, GL_INVALID_VALUE);
    if (values->empty()) return;
    auto& table = context.pixel_maps.tables[map - GL_PIXEL_MAP_I_TO_I];
    table.clear();
    for (const double v : *values)
        table.push_back(float(holds_indices(map) ? finite(v) : clamped(v, 0.0, 1.0)));
}

void pixel_zoom(Context& context, GLfloat xfactor, GLfloat yfactor) {
    context.state.pixel.zoom_x = float(finite(double(xfactor)));
    context.state.pixel.zoom_y = float(finite(double(yfactor)));
}

}  // namespace execute

}  // namespace gw::gl
