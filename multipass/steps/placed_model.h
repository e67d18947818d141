// A model before an eye: placed objects, lights in eye space, the state that all passes of the view
// share. Does not choose passes and makes no commands.
#pragma once

#include "multipass/steps/pass_model.h"
#include "scene/draw/view.h"

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gw::multipass {

/// A part, or a number of its triangles.
struct Portion {
    std::size_t part = 0;
    /// Each mesh of the part, and its triangles in the portion as a mesh; empty: all triangles.
    std::vector<std::pair<MeshRef, MeshRef>> meshes;

    MeshRef of(const MeshRef& mesh) const {
        for (const auto& [whole, portion] : meshes)
            if (whole == mesh) return portion;
        return mesh;
    }
};

/// Refers to the model, which must outlive it.
struct PlacedModel {
    const PassModel* model = nullptr;
    scene::View view;
    State state;                         ///< that all passes share
    std::vector<dmat4> eye_from_object;  ///< by part
    std::vector<LightsRef> lights;       ///< by light: a list with this light alone
    LightsRef every_light;               ///< all lights in one list; null: there are none
    std::vector<dvec3> glare;            ///< by part: the displacement of its glare, eye space
    std::vector<CullState> cull;         ///< by part
    /// By part and map: meshes with texture coordinates for reflection and refraction maps, for
    /// orthographic views. The machine's assume an eye at a finite distance.
    std::map<std::pair<std::size_t, const MappedMesh*>, MeshRef> generated;
    /// Translucent polygons in drawing order; empty: in the order of the scene.
    std::vector<Portion> far_to_near;

    /// The mesh that a map of a part is drawn with in this view.
    const MeshRef& mesh_of(std::size_t part, const MappedMesh& map) const {
        const auto found = generated.find({part, &map});
        return found == generated.end() ? map.mesh : found->second;
    }
};

PlacedModel place_model(const PassModel& model, const scene::View& view);

/// The lights that light this part, in one list; null: none.
LightsRef lights_of(const PlacedModel& placed, const Part& part);

/// Makes portions. Those that have the same triangles of one mesh share a mesh.
class PortionMaker {
public:
    /// Refers to the model, which must outlive it.
    explicit PortionMaker(const PlacedModel& placed) : placed_(placed) {}

    /// These triangles of the part's meshes, in this order: for passes that do not draw all of it.
    Portion portion_of(std::size_t part, std::span<const std::uint32_t> triangles);

private:
    const MeshRef& picked(const MeshRef& mesh, std::span<const std::uint32_t> triangles);

    const PlacedModel& placed_;
    std::map<std::pair<MeshRef, std::vector<std::uint32_t>>, MeshRef> picked_;
};

}  // namespace gw::multipass
