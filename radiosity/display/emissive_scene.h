// A solved scene as one that glows [F2.3, K4]: every surface emits its radiosity, as a texture, and
// the rest of its material stays. Eq. 2 and 5 draw it as the radiosity picture with highlights,
// reflections and traced light on top. Reflections show radiosity too. Does not draw.
#pragma once

#include "radiosity/display/display.h"
#include "scene/scene.h"

namespace gw::radiosity {

/// `scene` is the one that `model` was made of. Ka and Kd are 0, Ke is 1 and its map the pixmap,
/// `scale` times the radiosity; lights' highlights are scaled too. An object becomes one for each
/// of its pixmaps.
scene::Scene emissive_scene(const scene::Scene& scene, const PixmapModel& model,
                            const DisplayedPixmaps& colors, double scale);

/// With nothing in place of the triangles that turn their backs to the camera, which do not emit;
/// identifiers of polygons stay the same.
scene::Scene without_backs(scene::Scene scene, const scene::Camera& camera);

}  // namespace gw::radiosity
