// Types that pack the components of a pixel into one number: EXT_packed_pixels, [GL12] 3.6.4's reversed ones, and
// EXT_packed_depth_stencil's.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace gw::gl {

struct PackedType {
    GLenum type;
    std::size_t bytes;
    std::array<unsigned, 4> bits;  ///< of the components, the first one first; 0: no such component
    bool reversed;                 ///< whether the first one is in the lowest bits
};
/// Null: not a packed type.
const PackedType* packed_type(GLenum type);

/// Whether pixels of the format can be packed so: three components or four, or a depth and a stencil value.
bool is_packed_format(const PackedType& packed, GLenum format);

struct PixelType {
    GLenum format, type;
};
/// The format of GL_UNSIGNED_BYTE that has the same bytes in memory, if there is one; else these two.
PixelType as_bytes(GLenum format, GLenum type);

void store_packed_number(const PackedType& packed, std::byte* at, std::uint32_t number);
/// Where a component is in a pixel as a number.
struct PackedComponent {
    unsigned shift = 0;
    std::uint32_t largest = 0;  ///< 0: no such component
};
std::array<PackedComponent, 4> packed_components(const PackedType& packed);

/// The components of a pixel, 0 .. 1.
std::array<double, 4> load_packed(const PackedType& packed, const std::byte* at);
/// The reverse; clamped.
void store_packed(const PackedType& packed, std::byte* at, const std::array<double, 4>& values);

}  // namespace gw::gl
