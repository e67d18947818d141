// CompressedTexImage and CompressedTexSubImage: blocks become texels when they are given. [GL13] 3.8.3
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/pixels/memory.h"
#include "gl/texture/image_places.h"
#include "gl/texture/s3tc.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// Whether a part begins and ends with blocks, or with the image.
bool is_of_blocks(const TextureImage& image, const Rect& part) {
    const auto fits = [](int at, int size, int whole) {
        return at % 4 == 0 && (size % 4 == 0 || at + size == whole);
    };
    return fits(part.x, part.width, image.width) && fits(part.y, part.height, image.height);
}

/// The blocks of an image with those of a part replaced.
std::vector<std::byte> with_blocks(const BlockFormat& format, const TextureImage& image,
                                   const Rect& part, std::span<const std::byte> blocks) {
    std::vector<std::byte> out = *image.blocks;
    const std::size_t row = blocks_size(format, part.width, 1);
    for (int y = 0; y < part.height; y += 4, blocks = blocks.subspan(row))
        std::copy_n(blocks.begin(), row,
                    out.begin() + std::ptrdiff_t(blocks_size(format, image.width, part.y + y) +
                                                 std::size_t(part.x / 4) * format.bytes));
    return out;
}

}  // namespace

HostImage compressed_blocks(GLenum format, GLsizei width, GLsizei height, GLsizei size,
                            const GLvoid* blocks) {
    constexpr GLsizei largest = max_texture_side;
    Context* const context = bound_context();
    const BlockFormat* const known = block_format(format);
    if (context == nullptr || known == nullptr || size <= 0) return {};
    if (width <= 0 || height <= 0 || width > largest || height > largest) return {};
    if (std::size_t(size) != blocks_size(*known, width, height)) return {};
    const PixelStore& store = context->client.unpack;
    if (blocks == nullptr && !store.buffer) return {};
    const auto lock = context->shared->exclusive();
    const std::byte* const at = values_memory(*context, store, std::size_t(size), 1, blocks);
    if (at == nullptr) return {.is_refused = true};
    return guarded(*context, [&]() -> HostImage {
        auto kept = std::make_shared<const std::vector<std::byte>>(at, at + size);
        return {*kept, kept};
    });
}

namespace execute {

void compressed_tex_image_1d(Context& context, GLenum) { set_error(context, GL_INVALID_ENUM); }
void compressed_tex_image_3d(Context& context, GLenum) { set_error(context, GL_INVALID_ENUM); }

void compressed_tex_image_2d(Context& context, GLenum target, GLint level, GLenum internal_format,
                             GLsizei width, GLsizei height, GLint border, GLsizei image_size,
                             const HostImage& blocks) {
    const auto place = place_of(context.profile, target);
    const BlockFormat* const format = block_format(internal_format);
    if (!place || dimensions_of(*place) != 2 || format == nullptr)
        return set_error(context, GL_INVALID_ENUM);
    const ImageRequest r{level, GLint(internal_format), width, height, border};
    const GLenum error = request_error(context, r, *place);
    if (border != 0 && error == GL_NO_ERROR) return set_error(context, GL_INVALID_OPERATION);
    if (place->is_proxy) return set_proxy(context, *place, r, error);
    if (error != GL_NO_ERROR) return set_error(context, error);
    if (image_size < 0 || std::size_t(image_size) != blocks_size(*format, width, height))
        return set_error(context, GL_INVALID_VALUE);
    if (blocks.is_refused) return;
    TextureImage image = black_image(r);
    if (blocks.is_given()) {
        std::ranges::copy(decoded(*format, width, height, blocks.bytes), colors_of(image).begin());
        image.blocks = blocks.kept;
    }
    set_image(context, *place, level, std::move(image));
}

void compressed_tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset,
                                 GLint yoffset, GLsizei width, GLsizei height, GLenum format,
                                 GLsizei image_size, const HostImage& blocks) {
    const BlockFormat* const known = block_format(format);
    if (known == nullptr) return set_error(context, GL_INVALID_ENUM);
    const Rect rect{xoffset, yoffset, width, height};
    const auto part = replaced_part(context, target, 2, level, {rect});
    if (!part) return;
    const TextureImage& image = part->image();
    if (!image.blocks || GLenum(image.internal_format) != format || !is_of_blocks(image, rect))
        return set_error(context, GL_INVALID_OPERATION);
    if (image_size < 0 || std::size_t(image_size) != blocks_size(*known, width, height))
        return set_error(context, GL_INVALID_VALUE);
    if (!blocks.is_given()) return;
    auto all = std::make_shared<const std::vector<std::byte>>(
        with_blocks(*known, image, rect, blocks.bytes));
    replace(context, *part, decoded(*known, width, height, blocks.bytes));
    part->image().blocks = std::move(all);
}

}  // namespace execute

}  // namespace gw::gl
