// A scene as gw view opens it.
#pragma once

#include "apps/command/command.h"
#include "apps/picture/picture_options.h"
#include "image/output/output_set.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace gw::apps {

struct ViewedScene {
    std::filesystem::path file{};
    scene::Scene scene{};  ///< with textures, camera and lights
    std::optional<multipass::PassList> passes{};
    /// Its only light is a default one, which the file does not have.
    bool has_default_light = false;
    dvec3 origin{0};  ///< scene::SceneFile::origin
    std::map<std::string, Profile> profiles{};
    image::InputFiles inputs{};         ///< no saved file replaces one
    std::filesystem::path folder{"."};  ///< where views and pictures are saved
};

/// Reads scene, textures and profile. Throws Error.
ViewedScene load_viewed_scene(const PictureOptions& options, const std::filesystem::path& folder,
                              Session& session);

}  // namespace gw::apps
