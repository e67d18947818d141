// A view of another scene, as `gw view` saves it: `base` names the scene, and the other keys change
// its camera, lights and fog. docs/scenes.md, "Views", has every key. Does not draw.
#pragma once

#include "scene/toml/read_scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gw::scene {

/// Whether a file's first statement is `base = ...`. Reads only the beginning of the file; false for
/// one that cannot be read.
bool is_view(const std::filesystem::path& path);

/// Reads the scene of a view. `file` has the key base. Throws Error with file and line, also if the
/// bases lead around in a circle.
SceneFile read_view(const std::filesystem::path& path, const TomlValue& file);

/// An option of a command as [picture] has it: "samples", "4".
struct SavedOption {
    std::string name, word;
    Origin origin;
};
/// The [picture] tables of a view and of its bases, the view's own first. Empty for other scenes.
std::vector<SavedOption> saved_options(const std::filesystem::path& path);

/// Takes lights out, by their places in Scene::lights. If none is left, one without light stays, so
/// that the scene gets no default light.
void switch_off(Scene& scene, const std::set<std::size_t>& lights);

/// A view to save.
struct SavedView {
    std::filesystem::path base;  ///< as the file names it: relative to its own folder, or absolute
    Camera camera;
    bool fog = true;
    std::set<std::size_t> lights_off;  ///< places in the base's Scene::lights
    std::optional<Light> light;        ///< directional; added to a base without lights
    /// name and word of each option of [picture]
    std::vector<std::pair<std::string, std::string>> options;
};
/// The text of its file. Reading it gives the same numbers.
std::string to_toml(const SavedView& view);

}  // namespace gw::scene
