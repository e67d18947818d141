// Accessors as numbers [GLTF2 3.6.2]: bounds, strides, sparse values and finite numbers are checked
// here. Does not know what the numbers mean.
#pragma once

#include "scene/gltf/gltf_document.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace gw::scene {

/// Elements of 1, 2, 3, 4 or 16 numbers, one behind the other.
template <class Number>
struct Elements {
    std::size_t components = 1;
    std::vector<Number> numbers;

    std::size_t count() const { return numbers.size() / components; }
    const Number* operator[](std::size_t i) const { return &numbers[i * components]; }
};

/// Elements of one of the types, "VEC3". Normalised integers become 0 .. 1 or -1 .. 1. Throws Error
/// at the accessor's place for what the file does not have, and for numbers that are not finite.
Elements<float> read_floats(const GltfDocument& document, const JsonValue& index,
                            std::initializer_list<std::string_view> types);

/// Elements of unsigned integers.
Elements<std::uint32_t> read_integers(const GltfDocument& document, const JsonValue& index,
                                      std::string_view type);

/// The number of elements that an accessor promises; they are not read.
std::size_t count_of(const GltfDocument& document, const JsonValue& index);

/// Elements of an accessor without a buffer view: a short file could ask for any number.
inline constexpr std::size_t most_zeros = std::size_t{1} << 24;

}  // namespace gw::scene
