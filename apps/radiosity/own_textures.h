// The textures that a scene's surfaces have of their own, beside light maps. Does not solve and does not
// write glTF.
#pragma once

#include "image/output/output_set.h"
#include "scene/gltf/write_gltf.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

/// Radiosity reflects the mean of a map of Kd. Another program may multiply the light by each texel and
/// divide it by the mean.
class OwnTextures {
public:
    /// Pictures STEMown_texture_1.png ...
    explicit OwnTextures(std::filesystem::path stem) : stem_(std::move(stem)) {}

    /// The number of the object's texture; none if it emits, or has no map of Kd, or several. Writes
    /// each picture once, as a display of sRGB shows it.
    std::optional<std::size_t> of(const scene::Object& object, const scene::Material& material,
                                  image::OutputSet& files);
    const std::vector<scene::WrittenTexture>& all() const { return written_; }

private:
    struct Key {
        const Texture* texture;
        Wrap wrap_s, wrap_t;
        bool is_encoded;
        bool operator==(const Key&) const = default;
    };
    std::filesystem::path stem_;
    std::vector<Key> keys_;
    std::vector<scene::WrittenTexture> written_;
};

}  // namespace gw::apps
