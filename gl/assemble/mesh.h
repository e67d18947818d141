// Makes the machine's meshes of assembled vertices.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/state/state.h"
#include "gw/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace gw::gl {

/// The values of vertices that a draw uses, or that a mesh has.
struct VertexValues {
    bool colors = false, normals = false, texcoords = false, materials = false;
    bool secondary_colors = false, fog_coordinates = false;
    std::array<bool, texture_unit_count - 1> further_texcoords{};  ///< of units 1 to 3
    bool operator==(const VertexValues&) const = default;
};

/// The values that a draw with this state uses. Feedback asks for texture coordinates without a
/// texture too.
VertexValues used_values(const State& s, bool is_feedback);

/// The mesh of an assembly. Values in `used` that vary become its arrays; the draw's current values
/// are the first vertex's.
MeshRef mesh_of(const Assembly& assembly, const std::vector<FaceMaterials>& materials,
                const VertexValues& used);

/// The meshes of a frame in their order, so that one that is the same in the next frame is made
/// once. Bounded by the frame before.
class MeshCache {
public:
    /// The mesh of an assembly. Its vertices move into the cache.
    MeshRef mesh_of(Assembly& assembly, const std::vector<FaceMaterials>& materials,
                    const VertexValues& used);
    /// Begins with the first mesh; forgets the meshes that the frame did not have. A frame without
    /// meshes does not count.
    void begin_frame();

private:
    struct Entry {
        Assembly assembly;
        std::vector<FaceMaterials> materials;
        VertexValues used;
        MeshRef mesh;
    };
    std::vector<Entry> entries_;
    std::size_t next_ = 0;
};

}  // namespace gw::gl
