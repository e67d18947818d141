#include "scene/gltf/accessors.h"

#include "gw/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace gw::scene {
namespace {

struct ComponentType {
    std::size_t code, bytes;
    bool is_signed, is_float;
};
constexpr std::array component_types{
    ComponentType{5120, 1, true, false},  ComponentType{5121, 1, false, false},
    ComponentType{5122, 2, true, false},  ComponentType{5123, 2, false, false},
    ComponentType{5125, 4, false, false}, ComponentType{5126, 4, true, true},
};

struct ElementType {
    std::string_view name;
    std::size_t components;
};
constexpr std::array element_types{ElementType{"SCALAR", 1}, ElementType{"VEC2", 2},
                                   ElementType{"VEC3", 3}, ElementType{"VEC4", 4},
                                   ElementType{"MAT4", 16}};

const ComponentType& component_type_of(const JsonValue& value) {
    const std::size_t code = value.whole(0, 0xFFFF);
    for (const ComponentType& type : component_types)
        if (type.code == code) return type;
    value.fail_expected("5120, 5121, 5122, 5123, 5125 or 5126");
}

/// Little-endian, of any alignment.
double component(const char* at, const ComponentType& type) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i)
        bits |= std::uint32_t(static_cast<unsigned char>(at[i])) << 8 * i;
    if (type.is_float) {
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return double(value);
    }
    if (!type.is_signed) return double(bits);
    return type.bytes == 1 ? double(std::int8_t(bits)) : double(std::int16_t(bits));
}

/// [GLTF2 3.6.2.2]
double normalized(double value, const ComponentType& type) {
    if (type.is_float) return value;
    const double most = double((std::uint64_t{1} << (8 * type.bytes - type.is_signed)) - 1);
    return std::max(value / most, -1.0);
}

/// A row of numbers in a buffer view.
struct Row {
    const char* first = nullptr;
    std::size_t stride = 0;
};

Row row_in(const GltfDocument& document, const JsonValue& owner, std::size_t count,
           std::size_t element_bytes) {
    const JsonValue index = owner.at("bufferView");
    const std::string_view bytes = document.bytes_of_view(index);
    const auto stride_value = document.element("bufferViews", index).find("byteStride");
    const std::size_t stride =
        stride_value ? stride_value->whole(std::max<std::size_t>(element_bytes, 1), 252)
                     : element_bytes;
    const auto offset_value = owner.find("byteOffset");
    const std::size_t offset = offset_value ? offset_value->whole(0, bytes.size()) : 0;
    const std::size_t left = bytes.size() - offset;
    const std::size_t fits = left < element_bytes ? 0 : 1 + (left - element_bytes) / stride;
    if (count > fits)
        owner.fail("has " + std::to_string(count) + " elements; expected at most " +
                   std::to_string(fits) + ", which its buffer view holds");
    return {bytes.data() + offset, stride};
}

class AccessorReader {
public:
    AccessorReader(const GltfDocument& document, const JsonValue& index,
                   std::initializer_list<std::string_view> types)
        : document_(document),
          accessor_(document.element("accessors", index)),
          type_(component_type_of(accessor_.at("componentType"))),
          count_(accessor_.at("count").whole(1, max_mesh_size)) {
        const JsonValue type = accessor_.at("type");
        std::string expected;
        for (const std::string_view name : types) {
            expected += (expected.empty() ? "" : " or ") + std::string(name);
            for (const ElementType& element : element_types)
                if (element.name == name && type.text() == name) components_ = element.components;
        }
        if (components_ == 0) type.fail_expected(expected);
        const auto normalized = accessor_.find("normalized");
        normalized_ = normalized && normalized->boolean();
    }

    template <class Number>
    Elements<Number> read() const {
        if (std::is_integral_v<Number> && (type_.is_float || type_.is_signed))
            accessor_.at("componentType").fail_expected("5121, 5123 or 5125: unsigned integers");
        Elements<Number> out{components_, {}};
        if (accessor_.find("bufferView")) {
            const Row row = row_in(document_, accessor_, count_, components_ * type_.bytes);
            out.numbers.resize(count_ * components_);
            for (std::size_t i = 0; i < count_; ++i)
                copy(row.first + i * row.stride, &out.numbers[i * components_], i);
        } else {
            if (count_ > most_zeros)
                accessor_.fail("has " + std::to_string(count_) + " elements without a bufferView" +
                               "; expected at most " + std::to_string(most_zeros));
            out.numbers.resize(count_ * components_);
        }
        if (const auto sparse = accessor_.find("sparse")) replace(*sparse, out);
        return out;
    }

private:
    template <class Number>
    void copy(const char* from, Number* to, std::size_t element) const {
        for (std::size_t k = 0; k < components_; ++k) {
            const double value = component(from + k * type_.bytes, type_);
            if (!std::isfinite(value))
                accessor_.fail("is not finite at element " + std::to_string(element) +
                               "; expected finite numbers");
            to[k] = Number(normalized_ ? normalized(value, type_) : value);
        }
    }

    /// [GLTF2 3.6.2.3]
    template <class Number>
    void replace(const JsonValue& sparse, Elements<Number>& out) const {
        const std::size_t count = sparse.at("count").whole(1, count_);
        const JsonValue indices = sparse.at("indices"), values = sparse.at("values");
        const ComponentType& type = component_type_of(indices.at("componentType"));
        if (type.is_float || type.is_signed)
            indices.at("componentType").fail_expected("5121, 5123 or 5125: unsigned integers");
        const Row places = row_in(document_, indices, count, type.bytes);
        const Row row = row_in(document_, values, count, components_ * type_.bytes);
        double before = -1;
        for (std::size_t i = 0; i < count; ++i) {
            const double place = component(places.first + i * places.stride, type);
            if (place <= before || place >= double(count_))
                indices.fail("has " + std::to_string(std::size_t(place)) + " as index " +
                             std::to_string(i) + "; expected increasing ones below " +
                             std::to_string(count_));
            before = place;
            const auto element = std::size_t(place);
            copy(row.first + i * row.stride, &out.numbers[element * components_], element);
        }
    }

    const GltfDocument& document_;
    JsonValue accessor_;
    const ComponentType& type_;
    std::size_t count_, components_ = 0;
    bool normalized_ = false;
};

}  // namespace

Elements<float> read_floats(const GltfDocument& document, const JsonValue& index,
                            std::initializer_list<std::string_view> types) {
    return AccessorReader(document, index, types).read<float>();
}

Elements<std::uint32_t> read_integers(const GltfDocument& document, const JsonValue& index,
                                      std::string_view type) {
    return AccessorReader(document, index, {type}).read<std::uint32_t>();
}

std::size_t count_of(const GltfDocument& document, const JsonValue& index) {
    return document.element("accessors", index).at("count").whole(1, max_mesh_size);
}

}  // namespace gw::scene
