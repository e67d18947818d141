// The frame of every workload: the Fig. 9 class scene [K4f] (444 quads and 77,184 triangles), a
// texture, a sphere map, lights and shadow volumes. It is the same for all peers. Does not choose
// passes (workload.h).
#pragma once

#include "gw/command_list.h"

#include <vector>

namespace gw::peers {

/// One mesh at its place.
struct Part {
    MeshRef mesh;
    dmat4 eye_from_object{1};
    Material material;
};

struct Frame {
    int width = 640, height = 480;
    State view;  ///< projection and viewport; back faces culled
    std::vector<Part> scene;
    Part volumes;  ///< closed boxes of about 2,000 triangles, in eye space
    Part quad;     ///< the whole window, at depth 0.5; texture coordinates 0 .. 8
    TextureRef texture, sphere_map;
    std::vector<Light> lights;  ///< four, in eye space
};

/// The scene file's geometry in a window, 640x480 unless told.
Frame scene_frame(const char* path, int width = 640, int height = 480);
/// No scene, only the quad, in a 1024x1024 window.
Frame fill_frame();

}  // namespace gw::peers
