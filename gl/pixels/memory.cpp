#include "gl/pixels/memory.h"

#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/pixels/formats.h"

#include "gw/texture.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace gw::gl {

namespace {

/// The bytes from one row in memory to the next. [GL11] 3.6.4: k = a/s ceil(s n l / a)
std::size_t memory_row(const PixelStore& store, GLsizei width, GLenum format, GLenum type) {
    const GLsizei length = store.row_length > 0 ? store.row_length : width;
    const std::size_t bytes = row_bytes(length, format, type), align = std::size_t(store.alignment);
    if (type != GL_BITMAP && component_bytes(type) >= align) return bytes;
    return (bytes + align - 1) / align * align;
}

/// The bytes before the first pixel; of a bitmap the whole bytes.
std::size_t skipped_bytes(const PixelStore& store, std::size_t row, GLenum format, GLenum type) {
    const std::size_t pixels = type == GL_BITMAP ? std::size_t(store.skip_pixels) / 8
                                                 : row_bytes(store.skip_pixels, format, type);
    return std::size_t(store.skip_rows) * row + pixels;
}

void swap_components(std::byte* row, std::size_t bytes, GLenum type) {
    const std::size_t size = component_bytes(type);
    for (std::size_t at = 0; at + size <= bytes; at += size)
        std::reverse(row + at, row + at + size);
}

std::byte bit_mask(bool lsb_first, std::size_t i) {
    return std::byte(lsb_first ? 1u << i % 8 : 0x80u >> i % 8);
}

/// Copies bits; each side has its order and its first bit.
void copy_bits(std::byte* to, bool to_lsb, std::size_t to_first, const std::byte* from,
               bool from_lsb, std::size_t from_first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const bool bit =
            (from[(from_first + i) / 8] & bit_mask(from_lsb, from_first + i)) != std::byte{0};
        std::byte& byte = to[(to_first + i) / 8];
        const std::byte mask = bit_mask(to_lsb, to_first + i);
        byte = bit ? byte | mask : byte & ~mask;
    }
}

}  // namespace

std::optional<std::size_t> rows_in_memory(const PixelStore& store, GLsizei width, GLenum format,
                                          GLenum type) {
    const std::size_t row = memory_row(store, width, format, type);
    if (row != row_bytes(width, format, type) || type == GL_BITMAP || store.swap_bytes)
        return std::nullopt;
    return skipped_bytes(store, row, format, type);
}

std::vector<std::byte> copy_from_memory(const PixelStore& store, GLsizei width, GLsizei height,
                                        GLenum format, GLenum type, const void* memory) {
    const std::size_t row = memory_row(store, width, format, type);
    const std::size_t bytes = row_bytes(width, format, type);
    const auto* from =
        static_cast<const std::byte*>(memory) + skipped_bytes(store, row, format, type);
    std::vector<std::byte> rows(bytes * std::size_t(height));
    std::byte* to = rows.data();
    for (GLsizei y = 0; y < height; ++y, from += row, to += bytes) {
        if (type == GL_BITMAP) {
            copy_bits(to, false, 0, from, store.lsb_first, std::size_t(store.skip_pixels) % 8,
                      std::size_t(width));
            continue;
        }
        std::memcpy(to, from, bytes);
        if (store.swap_bytes) swap_components(to, bytes, type);
    }
    return rows;
}

void copy_to_memory(void* memory, const PixelStore& store, GLsizei width, GLsizei height,
                    GLenum format, GLenum type, std::span<const std::byte> rows) {
    const std::size_t row = memory_row(store, width, format, type);
    const std::size_t bytes = row_bytes(width, format, type);
    auto* to = static_cast<std::byte*>(memory) + skipped_bytes(store, row, format, type);
    const std::byte* from = rows.data();
    for (GLsizei y = 0; y < height; ++y, from += bytes, to += row) {
        if (type == GL_BITMAP) {
            copy_bits(to, store.lsb_first, std::size_t(store.skip_pixels) % 8, from, false, 0,
                      std::size_t(width));
            continue;
        }
        std::memcpy(to, from, bytes);
        if (store.swap_bytes) swap_components(to, bytes, type);
    }
}

std::byte* values_memory(Context& context, const PixelStore& store, std::size_t count,
                         std::size_t size, const void* pointer) {
    if (store.buffer) {
        const auto offset = reinterpret_cast<std::size_t>(pointer);
        if (store.buffer->is_mapped || offset % size != 0 ||
            !store.buffer->holds(offset, count * size))
            return set_error(context, GL_INVALID_OPERATION), nullptr;
    }
    return const_cast<std::byte*>(bytes_at(store.buffer, pointer));
}

std::byte* image_memory(Context& context, const PixelStore& store, GLsizei width, GLsizei height,
                        GLenum format, GLenum type, const void* pointer) {
    if (!store.buffer) return static_cast<std::byte*>(const_cast<void*>(pointer));
    const std::size_t row = memory_row(store, width, format, type);
    const std::size_t pixels_before = std::size_t(store.skip_pixels);
    const std::size_t last = type == GL_BITMAP ? (pixels_before + std::size_t(width) + 7) / 8
                                               : row_bytes(store.skip_pixels, format, type) +
                                                     row_bytes(width, format, type);
    // Rows beyond every memory are as good as the largest number.
    const double rows = double(store.skip_rows) + double(height) - 1;
    const double estimate = rows * double(row) + double(last);
    const std::size_t size = type == GL_BITMAP ? 1 : component_bytes(type);
    const bool is_empty = height == 0 || width == 0;
    const std::size_t end = is_empty             ? 0
                            : estimate >= 0x1p62 ? std::size_t(1) << 62
                                                 : std::size_t(rows) * row + last;
    return values_memory(context, store, (end + size - 1) / size, size, pointer);
}

HostImage unpack(GLsizei width, GLsizei height, GLenum format, GLenum type, const GLvoid* pixels) {
    Context* const context = bound_context();
    if (context == nullptr || width <= 0 || height <= 0) return {};
    if (format_error(format, type) != GL_NO_ERROR) return {};
    const PixelStore& store = context->client.unpack;
    if (pixels == nullptr && !store.buffer) return {};
    const HostImage refused{.is_refused = true};
    if (row_bytes(width, format, type) > std::size_t(PTRDIFF_MAX) / std::size_t(height))
        return set_error(*context, GL_OUT_OF_MEMORY), refused;
    const auto lock = context->shared->exclusive();
    pixels = image_memory(*context, store, width, height, format, type, pixels);
    if (pixels == nullptr) return refused;
    return guarded(*context, [&]() -> HostImage {
        std::optional<std::span<const std::byte>> rows;
        if (const auto first = rows_in_memory(store, width, format, type))
            rows.emplace(static_cast<const std::byte*>(pixels) + *first,
                         row_bytes(width, format, type) * std::size_t(height));
        if (rows && !context->lists.open && !store.buffer) return {*rows, nullptr};
        auto kept = std::make_shared<const std::vector<std::byte>>(
            rows ? std::vector(rows->begin(), rows->end())
                 : copy_from_memory(store, width, height, format, type, pixels));
        return {*kept, std::move(kept)};
    });
}

std::optional<PixelStore> slice_store(const PixelStore& store, GLsizei height, GLsizei slice) {
    PixelStore out = store;
    const std::int64_t rows = store.image_height > 0 ? store.image_height : height;
    const std::int64_t skipped = store.skip_rows + (std::int64_t(store.skip_images) + slice) * rows;
    if (skipped > std::numeric_limits<GLint>::max()) return std::nullopt;
    out.skip_rows = GLint(skipped);
    return out;
}

void copy_slices_to_memory(Context& context, const PixelStore& store, const ImageSize& size,
                           bool has_slices, GLenum format, GLenum type, void* pixels,
                           std::span<const std::byte> rows) {
    const std::size_t bytes = row_bytes(size.width, format, type) * std::size_t(size.height);
    // The last slice lies behind the others: if it is in a buffer, all are.
    for (GLsizei slice = size.depth; slice-- > 0;) {
        const auto of_slice = has_slices ? slice_store(store, size.height, slice) : store;
        if (!of_slice) return set_error(context, GL_OUT_OF_MEMORY);
        void* const memory =
            image_memory(context, *of_slice, size.width, size.height, format, type, pixels);
        if (memory == nullptr) return;
        copy_to_memory(memory, *of_slice, size.width, size.height, format, type,
                       rows.subspan(std::size_t(slice) * bytes, bytes));
    }
}

HostImage unpack_volume(GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                        const GLvoid* pixels) {
    Context* const context = bound_context();
    if (context == nullptr || depth <= 0) return {};
    for (const GLsizei side : {width, height, depth})
        if (side <= 0 || side > max_volume_side + 2) return {};
    const PixelStore& store = context->client.unpack;
    if (format_error(format, type) != GL_NO_ERROR || (pixels == nullptr && !store.buffer))
        return {};
    const HostImage refused{.is_refused = true};
    const auto lock = context->shared->exclusive();
    return guarded(*context, [&]() -> HostImage {
        auto kept = std::make_shared<std::vector<std::byte>>();
        for (GLsizei slice = 0; slice < depth; ++slice) {
            const auto of_slice = slice_store(store, height, slice);
            if (!of_slice) return set_error(*context, GL_OUT_OF_MEMORY), refused;
            const std::byte* const memory =
                image_memory(*context, *of_slice, width, height, format, type, pixels);
            if (memory == nullptr) return refused;
            const std::vector<std::byte> rows =
                copy_from_memory(*of_slice, width, height, format, type, memory);
            kept->insert(kept->end(), rows.begin(), rows.end());
        }
        return {*kept, kept};
    });
}

HostImage unpack_texture(GLsizei width, GLsizei height, GLenum format, GLenum type,
                         const GLvoid* pixels) {
    constexpr GLsizei largest = max_texture_side + 2;
    return width <= largest && height <= largest ? unpack(width, height, format, type, pixels)
                                                 : HostImage{};
}

Stipple stipple(const GLubyte* mask) {
    Stipple out;
    out.fill(~0u);
    const HostImage image = unpack(32, 32, GL_COLOR_INDEX, GL_BITMAP, mask);
    if (image.is_refused)  // the pattern stays
        if (const auto& pattern = bound_context()->state.polygon_stipple.pattern) return *pattern;
    if (!image.is_given()) return out;
    for (std::size_t y = 0; y < 32; ++y) {
        out[y] = 0;
        for (std::size_t i = 0; i < 4; ++i)
            out[y] = out[y] << 8 | std::to_integer<std::uint32_t>(image.bytes[4 * y + i]);
    }
    return out;
}

}  // namespace gw::gl
