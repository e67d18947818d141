// Draws views of one scene, one after the other, and keeps what no view changes: meshes of maps,
// shadow volumes and maps, hierarchies of rays. Does not choose the views.
#pragma once

#include "apps/render/frame_files.h"
#include "gw/machine.h"

#include <functional>

namespace gw::apps {

/// Leaves each view's picture in the machine's colour plane; the same bits as draw(). Refers to both,
/// which must outlive it; of the drawing only the scene's camera may change. Maps that are generated
/// from the scene depend on the view, so then each view is drawn alone.
std::function<void(const scene::View&)> view_drawer(const Drawing& drawing, Machine& machine);

}  // namespace gw::apps
