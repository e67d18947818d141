#include "inspect/recording/content.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <set>

static_assert(std::endian::native == std::endian::little,
              "content digests are of little-endian bytes");

namespace gw::inspect {
namespace {

Digest ours(const XXH128_hash_t& hash) { return {hash.high64, hash.low64}; }

/// Digests of arrays, chained: each with its length, so that no two ways of cutting give the same.
class Hasher {
public:
    Hasher() { XXH3_128bits_reset(&state_); }
    template <typename T>
    void add(const std::vector<T>& values) {
        static_assert(std::is_standard_layout_v<T>);
        add_number(values.size());
        XXH3_128bits_update(&state_, values.data(), values.size() * sizeof(T));
    }
    void add_number(std::uint64_t number) { XXH3_128bits_update(&state_, &number, sizeof number); }
    Digest finish() { return ours(XXH3_128bits_digest(&state_)); }

private:
    XXH3_state_t state_;
};

}  // namespace

static bool has_more(const MeshData& mesh) {
    return std::ranges::any_of(mesh.more_texcoords,
                               [](const UnitTexcoords& unit) { return !unit.st.empty(); });
}

Digest content(const MeshData& mesh) {
    Hasher hasher;
    hasher.add_number(std::uint64_t(mesh.primitive));
    hasher.add(mesh.positions);
    hasher.add(mesh.normals);
    hasher.add(mesh.texcoords);
    hasher.add(mesh.colors);
    hasher.add(mesh.indices);
    hasher.add(mesh.polygon_sizes);
    hasher.add(mesh.polygon_ids);
    if (mesh.w.empty() && mesh.texcoords_rq.empty() && mesh.edge_flags.empty() &&
        mesh.material_indices.empty() && mesh.secondary_colors.empty() &&
        mesh.fog_coordinates.empty() && !has_more(mesh))
        return hasher.finish();
    hasher.add(mesh.w);
    hasher.add(mesh.texcoords_rq);
    hasher.add(mesh.edge_flags);
    hasher.add(mesh.materials);
    hasher.add(mesh.material_indices);
    if (mesh.secondary_colors.empty() && mesh.fog_coordinates.empty() && !has_more(mesh))
        return hasher.finish();
    hasher.add(mesh.secondary_colors);
    hasher.add(mesh.fog_coordinates);
    if (has_more(mesh))
        for (const UnitTexcoords& unit : mesh.more_texcoords) {
            hasher.add(unit.st);
            hasher.add(unit.rq);
        }
    return hasher.finish();
}

Digest content(const Texture& texture) {
    const TextureLevel& level = texture.levels.front();
    Hasher hasher;
    hasher.add_number(std::uint64_t(level.width));
    hasher.add_number(std::uint64_t(level.height));
    hasher.add(*level.rgba);
    if (texture.srgb) hasher.add_number(1);
    if (!texture.given_levels) return hasher.finish();
    hasher.add_number(std::uint64_t(texture.format));
    hasher.add_number(std::uint64_t(texture.dimensions));
    hasher.add_number(texture.border ? 1 : 0);
    if (needs_r(texture)) {
        hasher.add_number(std::uint64_t(level.layers));
        hasher.add_number((texture.cube ? 2 : 0) + (texture.depths ? 1 : 0));
    }
    for (const TextureLevel& l : texture.levels) hasher.add(*l.rgba);
    return hasher.finish();
}

Digest scene_content(const Recording& recording) {
    std::set<const void*> seen;
    std::set<Digest> contents;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) {
            const auto* draw = std::get_if<Draw>(&command);
            if (!draw) continue;
            if (seen.insert(draw->mesh.get()).second) contents.insert(content(draw->mesh->data()));
            for (std::size_t unit = 0; unit < max_texture_units; ++unit)
                if (const TextureRef& t = map_of(*draw, unit).texture;
                    t && seen.insert(t.get()).second)
                    contents.insert(content(*t));
        }
    Hasher hasher;
    for (const Digest& digest : contents) {
        hasher.add_number(digest.high);
        hasher.add_number(digest.low);
    }
    return hasher.finish();
}

Digest digest_of_bytes(std::span<const std::uint8_t> bytes) {
    return ours(XXH3_128bits(bytes.data(), bytes.size()));
}

}  // namespace gw::inspect
