// A model before an eye: objects placed, lights in eye space, the state that all passes of the view
// share.
// Does not choose passes and makes no commands.
#pragma once

#include "multipass/frame/pass_model.h"
#include "scene/draw/view.h"

#include <vector>

namespace gw::multipass {

/// A part, or some triangles of it.
struct Portion {
    std::size_t part = 0;
    /// Each mesh of the part and what of it belongs to the portion; empty: all.
    std::vector<std::pair<MeshRef, MeshRef>> meshes;

    MeshRef of(const MeshRef& mesh) const {
        for (const auto& [whole, portion] : meshes)
            if (whole == mesh) return portion;
        return mesh;
    }
};

/// Refers to the model, which must outlive it.
struct Stage {
    const Model* model = nullptr;
    scene::View view;
    State state;                         ///< of every pass, but for what the pass says itself
    std::vector<dmat4> eye_from_object;  ///< by part
    std::vector<LightsRef> lights;       ///< by light: a list of this one
    std::vector<dvec3> glare;            ///< by part: where glare moves it, eye space
    std::vector<Portion>
        far_to_near;  ///< translucent polygons in drawing order; empty: as the scene has them
};

Stage make_stage(const Model& model, const scene::View& view);

/// The lights of a light-list pass that light this part, in one list; null where there are none.
LightsRef lights_of(const Stage& stage, const Part& part);

}  // namespace gw::multipass
