// The scene of the folders' benchmarks: the Fig. 9 class scene, or another, ready to draw at
// 640x480.
#pragma once

#include "image/textures.h"
#include "multipass/frame/driver.h"
#include "scene/draw/fit.h"
#include "scene/toml/read_scene.h"

#include <string>

namespace gw::bench {

inline constexpr int width = 640, height = 480;

struct Ready {
    scene::Scene scene;
    scene::View view;
};

/// A scene of scenes/, with textures, default camera and light.
inline Ready ready(const std::string& name) {
    Ready r{scene::read_scene(GW_SOURCE_DIR "/scenes/" + name).scene, {}};
    image::load_textures(r.scene);
    scene::add_defaults(r.scene, width, height);
    r.view = scene::make_view(r.scene, width, height);
    return r;
}

/// The commands of its frame.
inline CommandList frame(const Ready& r) {
    const auto passes = multipass::passes_for(r.scene, multipass::Renderer::Multipass);
    return multipass::frame_list(r.scene, r.view, passes, r.scene.background);
}

}  // namespace gw::bench
