// Writes glTF 2.0 [GLTF2]: triangles in the world with two sets of texture coordinates, pictures that
// are shown unlit, and a camera. Makes texts and bytes; does not write files. No normals, lights,
// indices or animations.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gw::scene {

struct WrittenPicture {
    std::string file;   ///< PNG or JPEG, encoded as in sRGB, from the file's folder
    std::string exact;  ///< the same values as EXR: `extras` of its material name it
    double scale = 1;   ///< of `exact` in `file`
    std::string rgbm;   ///< the same values as RGBM, scaled too; "": none
    double range = 0;   ///< of `rgbm`
};

/// A texture that TEXCOORD_0 looks up: `extras` of a material name it.
struct WrittenTexture {
    std::string file;  ///< PNG or JPEG, encoded as in sRGB, from the file's folder
    Wrap wrap_s = Wrap::Repeat, wrap_t = Wrap::Repeat;
    dvec3 mean{1};  ///< of its texels, decoded
};

struct WrittenMesh {
    std::string name;
    std::size_t picture = 0;               ///< that TEXCOORD_1 looks up
    std::optional<std::size_t> texture{};  ///< of the scene's `textures`
    /// Three for each triangle. Texture coordinates have t upwards, as the machine's.
    std::vector<vec3> positions;
    std::vector<vec2> texcoord_0, texcoord_1;
};

struct WrittenScene {
    std::vector<WrittenPicture> pictures;
    std::vector<WrittenTexture> textures;
    std::vector<WrittenMesh> meshes;  ///< each with a triangle at least
    std::optional<Camera> camera;     ///< with its near and far plane filled in
    double aspect = 1;                ///< width / height of the camera's picture
};

struct GltfText {
    std::string json, bytes;
};
/// The file and its buffer, which it names `buffer`.
GltfText write_gltf(const WrittenScene& scene, const std::string& buffer);

}  // namespace gw::scene
