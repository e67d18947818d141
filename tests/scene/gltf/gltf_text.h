// Small glTF files as texts, for tests that change a word of them.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace gw::scene {

inline std::string to_base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
        for (int k = 0; k < 4; ++k)
            text += i + std::size_t(k) > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// The text with every `from` replaced; a `from` that is not there is a mistake of the test.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    std::size_t at = text.find(from);
    if (at == text.npos) throw std::invalid_argument("no " + from);
    for (; at != text.npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    return text;
}

inline std::string data_uri(const std::string& bytes) {
    return "data:application/octet-stream;base64," + to_base64(bytes);
}

/// (0, 0, 0), (2, 0, 0), (0, 3, 0) and its indices 0, 1, 2.
inline std::string triangle_bytes() {
    return bytes_of<float>({0, 0, 0, 2, 0, 0, 0, 3, 0}) + bytes_of<std::uint16_t>({0, 1, 2});
}

/// One node "leaf" with one triangle.
inline std::string triangle_json(const std::string& buffer) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "leaf", "mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
 {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
"buffers": [{"byteLength": 42)" +
           buffer + "}]}";
}
inline std::string triangle_gltf() {
    return triangle_json(R"(, "uri": ")" + data_uri(triangle_bytes()) + "\"");
}

/// The triangle's node with an animation of two keys, at 0 and 2 s.
inline std::string animated(const std::string& path, const std::vector<float>& values,
                            const std::string& type, const std::string& interpolation = "LINEAR") {
    const std::string bytes =
        triangle_bytes() + std::string(2, '\0') + bytes_of<float>({0, 2}) + bytes_of(values);
    std::string text =
        replaced(triangle_json(R"(, "uri": ")" + data_uri(bytes) + "\""), "\"byteLength\": 42",
                 "\"byteLength\": " + std::to_string(bytes.size()));
    text = replaced(
        text, R"("byteLength": 6})",
        R"("byteLength": 6}, {"buffer": 0, "byteOffset": 44, "byteLength": 8}, {"buffer": 0, "byteOffset": 52, "byteLength": )" +
            std::to_string(bytes.size() - 52) + "}");
    const std::size_t count = values.size() / (type == "VEC4" ? 4 : 3);
    text = replaced(
        text, R"("type": "SCALAR"})",
        R"("type": "SCALAR"}, {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR"},
                    {"bufferView": 3, "componentType": 5126, "count": )" +
            std::to_string(count) + R"(, "type": ")" + type + "\"}");
    return replaced(
        text, R"("scene": 0)",
        R"("scene": 0, "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": ")" +
            path + R"("}}], "samplers": [{"input": 2, "output": 3, "interpolation": ")" +
            interpolation + "\"}]}]");
}

/// That with an animation "hop" before it, which scales the node by the same values.
inline std::string with_hop(const std::string& text) {
    return replaced(text, R"("animations": [)",
                    R"("animations": [{"name": "hop", "samplers": [{"input": 2, "output": 3}],
"channels": [{"sampler": 0, "target": {"node": 0, "path": "scale"}}]}, )");
}

inline std::string word_bytes(std::size_t value) {
    return bytes_of<std::uint32_t>({std::uint32_t(value)});
}

inline std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    return "glTF" + word_bytes(2) + word_bytes(28 + json.size() + binary.size()) +
           word_bytes(json.size()) + "JSON" + json + word_bytes(binary.size()) +
           std::string("BIN\0", 4) + binary;
}

}  // namespace gw::scene
