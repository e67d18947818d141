// A glTF 2.0 file, .gltf or .glb: its JSON and its buffers, checked as containers [GLTF2 3.6, 4].
// Does not know meshes, materials or nodes.
#pragma once

#include "scene/gltf/json_value.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gw::scene {

/// What a URI stands for: bytes in the text, or a file.
struct GltfUri {
    std::shared_ptr<const std::string> bytes;  ///< of a data URI; null: `file`
    std::filesystem::path file;
};

class GltfDocument {
public:
    /// Throws Error "FILE: PLACE is WHAT; expected WHAT", for missing and short buffers as well.
    GltfDocument(const std::filesystem::path& path, Warnings& warnings);

    const JsonValue& root() const { return root_; }
    std::string file() const { return path_.string(); }
    const std::filesystem::path& path() const { return path_; }

    /// The element of an array of the file, "meshes", that a value names by its index.
    JsonValue element(const std::string& array, const JsonValue& index) const;
    /// The number of elements; 0 without the array.
    std::size_t count(const std::string& array) const;

    /// The bytes of a buffer view, which lie in its buffer.
    std::string_view bytes_of_view(const JsonValue& index) const;

    GltfUri read_uri(const JsonValue& uri) const;

    /// A warning for this file; one of each kind.
    void warn(const std::string& kind, const std::string& text) const {
        warnings_.add(file(), 0, kind, text);
    }
    Warnings& warnings() const { return warnings_; }

private:
    void check_asset() const;
    void read_buffers();

    std::filesystem::path path_;
    Warnings& warnings_;
    std::string contents_;     ///< the whole file
    std::string_view binary_;  ///< the second chunk of a .glb
    JsonValue root_;
    std::vector<std::shared_ptr<const std::string>> owned_;
    std::vector<std::string_view> buffers_;
};

}  // namespace gw::scene
