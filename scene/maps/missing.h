// Maps whose pictures are missing beside a model. Does not look for files.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

namespace gw::scene {

/// Takes maps without texture out of their materials, if Map::may_lack. One warning for each file that
/// names some.
void leave_out_missing(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
