// Digests of a recording's content: equal content has equal digests, in any process. Does not look
// at names: a map's name is no part of its value.
#pragma once

#include "gw/mesh.h"
#include "gw/planes.h"
#include "gw/texture.h"
#include "inspect/recording/recording.h"

namespace gw::inspect {

/// XXH3-128 of a mesh's or a map's arrays, each preceded by its length, little-endian.
Digest content(const MeshData& mesh);
Digest content(const Texture& texture);

/// The drawn scene, from any eye: XXH3-128 over the digests of the meshes and maps of a recording's
/// draws, each once, in increasing order.
Digest scene_content(const Recording& recording);

/// XXH3-128 of bytes.
Digest digest_of_bytes(std::span<const std::uint8_t> bytes);

}  // namespace gw::inspect
