#include "scene/gltf/gltf_document.h"

#include "gw/error.h"
#include "scene/gltf/base64.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <cstdint>

namespace gw::scene {
namespace {

/// Little-endian words of a GLB file.
constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
    return value;
}

struct Chunks {
    std::string_view json, binary;
};

/// [GLTF2 4.4]
Chunks chunks_of(const std::string& file, std::string_view bytes) {
    const auto fail = [&](const std::string& what) { throw Error(file, 0, what); };
    if (bytes.size() < header_size + chunk_header_size)
        fail("is a GLB of " + std::to_string(bytes.size()) + " bytes; expected a header and JSON");
    if (word(bytes, 4) != 2)
        fail("is a GLB of version " + std::to_string(word(bytes, 4)) + "; expected 2");
    if (word(bytes, 8) > bytes.size())
        fail("is cut off: it has " + std::to_string(bytes.size()) + " bytes; expected " +
             std::to_string(word(bytes, 8)) + " as its header says");
    bytes = bytes.substr(0, word(bytes, 8));
    Chunks chunks;
    std::size_t at = header_size;
    for (int number = 0; at < bytes.size(); ++number) {
        const std::string name = "chunk " + std::to_string(number);
        if (bytes.size() - at < chunk_header_size) fail(name + " has no header; expected 8 bytes");
        const std::size_t size = word(bytes, at);
        const std::uint32_t kind = word(bytes, at + 4);
        at += chunk_header_size;
        if (size > bytes.size() - at)
            fail(name + " has " + std::to_string(size) + " bytes; expected at most " +
                 std::to_string(bytes.size() - at) + " to the end of the file");
        if (number == 0 && kind != json_chunk) fail("chunk 0 is no JSON; expected type 'JSON'");
        if (number == 0) chunks.json = bytes.substr(at, size);
        if (number == 1 && kind == binary_chunk) chunks.binary = bytes.substr(at, size);
        at += size;
    }
    if (!chunks.json.data()) fail("is a GLB without chunks; expected one of JSON");
    return chunks;
}

bool is_glb(std::string_view bytes) { return bytes.size() >= 4 && word(bytes, 0) == glb_magic; }

JsonValue read_json(const std::string& file, std::string_view bytes, std::string_view& binary) {
    if (!is_glb(bytes)) {
        if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
        return JsonValue::read(file, bytes);
    }
    const Chunks chunks = chunks_of(file, bytes);
    binary = chunks.binary;
    return JsonValue::read(file, chunks.json);
}

int hex(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// "my%20bricks.png" is "my bricks.png".
std::string without_percents(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool coded =
            text[i] == '%' && i + 2 < text.size() && hex(text[i + 1]) >= 0 && hex(text[i + 2]) >= 0;
        plain += coded ? char(hex(text[i + 1]) * 16 + hex(text[i + 2])) : text[i];
        if (coded) i += 2;
    }
    return plain;
}

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& path, Warnings& warnings)
    : path_(path),
      warnings_(warnings),
      contents_(read_bytes(path)),
      root_(read_json(path.string(), contents_, binary_)) {
    warnings_.add_file(path);
    check_asset();
    read_buffers();
}

void GltfDocument::check_asset() const {
    const JsonValue version = root_.at("asset").at("version");
    if (!version.text().starts_with("2."))
        version.fail_expected("2.0: other versions of glTF are not read");
    if (const auto least = root_.at("asset").find("minVersion"); least && least->text() != "2.0")
        least->fail_expected("2.0: a later version is not read");
}

JsonValue GltfDocument::element(const std::string& array, const JsonValue& index) const {
    const std::size_t n = count(array);
    if (n == 0) index.fail_expected("an index into " + array + ", of which the file has none");
    return root_.at(array)[index.whole(0, n - 1)];
}

std::size_t GltfDocument::count(const std::string& array) const {
    const auto list = root_.find(array);
    return list ? list->size() : 0;
}

GltfUri GltfDocument::read_uri(const JsonValue& uri) const {
    const std::string& text = uri.text();
    if (text.starts_with("data:")) {
        const std::size_t comma = text.find(',');
        if (comma == text.npos || !text.substr(0, comma).ends_with(";base64"))
            uri.fail("is a data URI of another kind; expected data:TYPE;base64,TEXT");
        auto bytes = from_base64(std::string_view(text).substr(comma + 1));
        if (!bytes) uri.fail("is no base64 text; expected groups of four of its 64 characters");
        return {std::make_shared<const std::string>(std::move(*bytes)), {}};
    }
    const std::string name = without_percents(text);
    const bool absolute = name.starts_with('/') || name.starts_with('\\') ||
                          name.find(':') < name.find_first_of("/\\");
    if (name.empty() || absolute || name.find('\0') != name.npos)
        uri.fail_expected("the name of a file, relative to this one");
    return {nullptr, find_file(path_.parent_path(), name)};
}

void GltfDocument::read_buffers() {
    for (std::size_t i = 0; i < count("buffers"); ++i) {
        const JsonValue buffer = root_.at("buffers")[i];
        std::string_view bytes = binary_;
        if (const auto uri = buffer.find("uri")) {
            GltfUri found = read_uri(*uri);
            if (!found.bytes) {
                if (const std::string fault = file_fault(found.file); !fault.empty())
                    uri->fail("'" + printable(uri->text()) + "' " + fault + "; expected a file");
                warnings_.add_file(found.file);
                found.bytes = std::make_shared<const std::string>(read_bytes(found.file));
            }
            owned_.push_back(found.bytes);
            bytes = *owned_.back();
        } else if (i > 0 || !binary_.data()) {
            buffers_.emplace_back();  // of an extension; an error if a view is read
            continue;
        }
        const JsonValue length = buffer.at("byteLength");
        const std::size_t size = length.whole(1, std::size_t{1} << 52);
        if (size > bytes.size())
            length.fail_expected("at most " + std::to_string(bytes.size()) +
                                 ", which the buffer has");
        buffers_.push_back(bytes.substr(0, size));
    }
}

std::string_view GltfDocument::bytes_of_view(const JsonValue& index) const {
    const JsonValue view = element("bufferViews", index);
    const JsonValue buffer = view.at("buffer");
    const JsonValue named = element("buffers", buffer);
    const std::string_view bytes = buffers_[buffer.whole(0, buffers_.size() - 1)];
    if (!bytes.data()) named.fail("has no uri; expected one, or a GLB file with a second chunk");
    const auto offset = view.find("byteOffset");
    const std::size_t begin = offset ? offset->whole(0, bytes.size()) : 0;
    return bytes.substr(begin, view.at("byteLength").whole(1, bytes.size() - begin));
}

}  // namespace gw::scene
