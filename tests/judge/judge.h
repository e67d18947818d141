// Picture files as OpenImageIO itself reads and writes them. Its 250 libraries take 0.6 s to load, so
// they are a module that is loaded when a test first asks. Does not use image/.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace gw::judge {

/// How a file, or a caller, stores one sample of a pixel.
enum class Sample { U8, U16, U32, Half, Float, Other };

struct Spec {
    int width = 0, height = 0, channels = 0;
    Sample format = Sample::U8;

    std::size_t samples() const {
        return std::size_t(width) * std::size_t(height) * std::size_t(channels);
    }
};

/// The module's functions. Each answers what went wrong, or "". Rows from the top; an alpha is not
/// multiplied into its colours.
struct Functions {
    std::string (*read)(const std::string& file, Sample as, Spec&, std::vector<std::byte>& values);
    std::string (*write)(const std::string& file, const Spec&, Sample given, const void* values);
};

/// Loads the module at the first call.
const Functions& functions();

template <class T>
constexpr Sample sample_of = Sample::Float;
template <>
inline constexpr Sample sample_of<std::uint8_t> = Sample::U8;
template <>
inline constexpr Sample sample_of<std::uint16_t> = Sample::U16;
template <>
inline constexpr Sample sample_of<std::uint32_t> = Sample::U32;

/// What a file holds, top row first.
template <class T>
struct Stored {
    Spec spec;
    std::vector<T> values;
};

template <class T>
Stored<T> stored_in(const std::filesystem::path& file) {
    Stored<T> found;
    std::vector<std::byte> bytes;
    const std::string error = functions().read(file.string(), sample_of<T>, found.spec, bytes);
    EXPECT_EQ(error, "") << file;
    found.values.resize(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(found.values.data(), bytes.data(), bytes.size());
    return found;
}

/// False if OpenImageIO does not write this kind of file.
template <class T>
bool store(const std::filesystem::path& file, const Spec& spec, const std::vector<T>& values) {
    return functions().write(file.string(), spec, sample_of<T>, values.data()).empty();
}

}  // namespace gw::judge
