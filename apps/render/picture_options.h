// The options that gw render and gw passes share: scene, camera, renderer, machine. Loads the scene
// and makes the machine. Does not draw.
#pragma once

#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/render/renderers.h"
#include "gw/machine.h"
#include "multipass/frame/options.h"
#include "scene/draw/fit.h"
#include "scene/draw/view.h"
#include "scene/scene.h"
#include "scene/validate/warnings_of.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gw::apps {

struct PictureOptions {
    std::filesystem::path scene;
    std::string renderer = "multipass";
    Size size;
    std::string profile = "vgx";
    std::string machine;  ///< empty: the first of machines()
    int threads = 0;      ///< 0: all
    int samples = 1;
    bool weighted = false;  ///< a weighted mean of the samples
    multipass::Translucency translucency = multipass::Translucency::Sorted;
    bool traced = true;  ///< illum 3 and up by rays
    itembuffer::Options rays;
    std::optional<scene::Shadow> shadow;  ///< of all lights that cast one
    scene::CameraOverrides camera;
    std::optional<dvec3> up;
    bool quiet = false;
};

/// Adds SCENE and the options. Parsing checks the words, not the files.
void add_picture_options(CLI::App& command, PictureOptions& options);
/// Removes the options of renderer and passes, for a command that chooses them itself.
void remove_pass_options(CLI::App& command);

/// Reads the scene and its textures, as inputs of the session. Fits a missing camera and light, and
/// applies the camera options. Prints the readers' warnings unless quiet. Throws Error.
/// Prints also what a picture of the scene that is drawn so will not show.
scene::Scene load_scene(const PictureOptions& options, Session& session,
                        scene::DrawnBy by = scene::DrawnBy::Depth);

/// The scene, with its own pass list if it has one.
struct SceneWithPasses {
    scene::Scene scene;
    std::optional<multipass::PassList> passes;
    dvec3 origin{0};  ///< scene::SceneFile::origin
};
SceneWithPasses load_scene_with_passes(const PictureOptions& options, Session& session);

/// The options for the renderer.
DrawOptions draw_options(const PictureOptions& options);

/// A built-in profile by name, or one from a TOML file. If it cannot superpose that many samples,
/// throws UsageError, or Error for a profile from a file.
Profile load_profile(const PictureOptions& options, Session& session);

/// "fast", "reference": the machines of this build, the default first.
std::vector<std::string> machines();
/// The machine, added to the session's recorder if it has one.
std::unique_ptr<Machine> make_machine(const PictureOptions& options, const Profile& profile,
                                      const Session& session);

}  // namespace gw::apps
