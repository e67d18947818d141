// What is asked of a picture: the options that the command, the Python package and the lab have in
// common, as plain values. options.h has their names, words and limits. Does not draw.
#pragma once

#include "multipass/frame/options.h"
#include "render/words/option_values.h"
#include "scene/draw/fit.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace gw::render {

struct Request {
    std::filesystem::path scene{};       ///< empty: the scene is built in code
    std::string renderer = "multipass";  ///< a name of renderers()
    Size size{};
    std::string machine = "fast";  ///< a name of machines()
    int threads = 0;               ///< 0: all
    int samples = 1;               ///< superposed pictures, at least
    std::string profile = "vgx";   ///< a name of gw::profiles(), or a TOML file
    scene::CameraOverrides camera{};
    multipass::Translucency translucency = multipass::Translucency::Sorted;
    std::optional<scene::Shadow> shadow;  ///< of all lights that cast one; absent: the scene's
    bool weighted = false;                ///< a weighted mean of the samples
    bool traced = true;                   ///< illum 3 and up by rays; false: by maps only
    int depth = 2;                        ///< rays in a path, with the one from the eye
    bool shadow_maps = false;             ///< shadows in reflections by shadow maps
};

}  // namespace gw::render
