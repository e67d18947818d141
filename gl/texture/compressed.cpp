// CompressedTexImage and CompressedTexSubImage: blocks become texels when they are given. [GL13] 3.8.3
#include "gl/texture/compressed.h"

#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/pixels/memory.h"
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

/// Replaces the blocks of a part, and its texels.
void replace_blocks(Context& context, const ReplacedPart& part, const BlockFormat& format,
                    std::span<const std::byte> blocks) {
    const Rect& rect = part.box.rect;
    auto all = std::make_shared<const std::vector<std::byte>>(
        with_blocks(format, part.image(), rect, blocks));
    replace(context, part, decoded(format, rect.width, rect.height, blocks));
    part.image().blocks = std::move(all);
}

}  // namespace

GLint stored_format(const ImageRequest& r, const ImagePlace& place) {
    const bool has_blocks = dimensions_of(place) == 2 && r.border == 0 &&
                            block_format(GLenum(r.internal_format)) != nullptr;
    if (!is_compressed(r.internal_format) || has_blocks) return r.internal_format;
    const GLenum base = base_format(r.internal_format);
    if (!is_srgb(r.internal_format)) return GLint(base);
    switch (base) {
        case GL_RGB: return GL_SRGB;
        case GL_RGBA: return GL_SRGB_ALPHA;
        case GL_LUMINANCE: return GL_SLUMINANCE;
    }
    return GL_SLUMINANCE_ALPHA;
}

void compress(TextureImage& image) {
    const BlockFormat* const format = block_format(GLenum(image.internal_format));
    if (format == nullptr || image.width == 0) return;
    const std::span<Rgba> colors = colors_of(image);
    image.blocks = std::make_shared<const std::vector<std::byte>>(
        encoded(*format, image.width, image.height, colors));
    std::ranges::copy(decoded(*format, image.width, image.height, *image.blocks), colors.begin());
}

void replace_texels(Context& context, const ReplacedPart& part, std::span<const Rgba> colors) {
    const TextureImage& image = part.image();
    const Rect& rect = part.box.rect;
    if (!image.blocks) return replace(context, part, colors);
    if (!is_of_blocks(image, rect)) return set_error(context, GL_INVALID_OPERATION);
    const BlockFormat& format = *block_format(GLenum(image.internal_format));
    replace_blocks(context, part, format, encoded(format, rect.width, rect.height, colors));
}

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
    if (!place || dimensions_of(*place) != 2 || place->index == rectangular || format == nullptr)
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
    } else {
        compress(image);
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
    replace_blocks(context, *part, *known, blocks.bytes);
}

}  // namespace execute

}  // namespace gw::gl
