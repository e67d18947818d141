// Rows of pixels in the caller's memory, as PixelStore lays them out. [GL11] 3.6.4, 4.3.2
#pragma once

#include "gl/state/client.h"

#include <GL/gl.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gw::gl {

struct Context;

/// The memory of an image that a call packs into or unpacks from: the caller's, or the part of the
/// bound buffer that begins at the pointer's offset. Null: there is none, or it does not fit the
/// buffer, and INVALID_OPERATION is set. GL_ARB_pixel_buffer_object
std::byte* image_memory(Context& context, const PixelStore& store, GLsizei width, GLsizei height,
                        GLenum format, GLenum type, const void* pointer);
/// The same of `count` values that no PixelStore lays out.
std::byte* values_memory(Context& context, const PixelStore& store, std::size_t count,
                         std::size_t size, const void* pointer);

/// Where an image begins in the caller's memory, in bytes, if its rows lie there as
/// copy_from_memory() gives them.
std::optional<std::size_t> rows_in_memory(const PixelStore& store, GLsizei width, GLenum format,
                                          GLenum type);
/// The layout of one slice of an image of three dimensions. [GL12] 3.6.4. None: it is beyond every
/// memory.
std::optional<PixelStore> slice_store(const PixelStore& store, GLsizei height, GLsizei slice);

struct ImageSize {
    GLsizei width, height, depth;
};
/// Packs the slices of a texture's image. `has_slices`: it has three dimensions.
void copy_slices_to_memory(Context& context, const PixelStore& store, const ImageSize& size,
                           bool has_slices, GLenum format, GLenum type, void* pixels,
                           std::span<const std::byte> rows);

/// Copies an image out of the caller's memory: rows without padding, the host's byte order, bitmaps
/// with the highest bit first.
std::vector<std::byte> copy_from_memory(const PixelStore& store, GLsizei width, GLsizei height,
                                        GLenum format, GLenum type, const void* memory);
/// Copies such rows back. Bytes and bits between the image's stay as they are.
void copy_to_memory(void* memory, const PixelStore& store, GLsizei width, GLsizei height,
                    GLenum format, GLenum type, std::span<const std::byte> rows);

}  // namespace gw::gl
