// Rows of pixels in the caller's memory, as PixelStore lays them out. [GL11] 3.6.4, 4.3.2
#pragma once

#include "gl/state/client.h"

#include <GL/gl.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gw::gl {

/// Where an image begins in the caller's memory, in bytes, if its rows lie there as
/// copy_from_memory() gives them.
std::optional<std::size_t> rows_in_memory(const PixelStore& store, GLsizei width, GLenum format,
                                          GLenum type);
/// Copies an image out of the caller's memory: rows without padding, the host's byte order, bitmaps
/// with the highest bit first.
std::vector<std::byte> copy_from_memory(const PixelStore& store, GLsizei width, GLsizei height,
                                        GLenum format, GLenum type, const void* memory);
/// Copies such rows back. Bytes and bits between the image's stay as they are.
void copy_to_memory(void* memory, const PixelStore& store, GLsizei width, GLsizei height,
                    GLenum format, GLenum type, std::span<const std::byte> rows);

}  // namespace gw::gl
