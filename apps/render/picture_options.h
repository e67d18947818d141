// The options that gw render and gw passes share: which scene, seen how, drawn by what; and the
// scene they give. Does not draw.
#pragma once

#include "apps/command/cli_fwd.h"
#include "apps/command/option_values.h"
#include "apps/command/session.h"
#include "apps/render/renderers.h"
#include "gw/machine.h"
#include "multipass/frame/options.h"
#include "scene/draw/fit.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

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
    bool weighted = false;  ///< the samples' mean
    multipass::Translucency translucency = multipass::Translucency::Sorted;
    bool traced = true;  ///< illum 3 and up by rays
    itembuffer::Options rays;
    std::optional<scene::Shadow> shadow;  ///< of all lights that cast one
    scene::CameraOverrides camera;
    std::optional<dvec3> up;
    bool quiet = false;
};

/// Adds SCENE and the options. The wording is checked while parsing, files are not looked at.
void add_picture_options(CLI::App& command, PictureOptions& options);
/// For a command that chooses renderer and passes itself: takes their options away again.
void remove_pass_options(CLI::App& command);

/// Reads the scene and its textures, fits what it leaves open, applies the camera options. Warnings
/// of the readers go to stderr unless quiet. Throws Error.
/// What is read is an input of the session.
scene::Scene load_scene(const PictureOptions& options, Session& session);

/// The same, with the pass list that the scene brings, if it does.
struct SceneWithPasses {
    scene::Scene scene;
    std::optional<multipass::PassList> passes;
};
SceneWithPasses load_scene_with_passes(const PictureOptions& options, Session& session);

/// What of the options a renderer asks for.
DrawOptions draw_options(const PictureOptions& options);

/// A built-in profile by name, or one from a TOML file. Throws UsageError, of a file Error, where
/// it cannot hold so many samples.
Profile load_profile(const PictureOptions& options, Session& session);

/// "fast", "reference": those that this build has, the default first.
std::vector<std::string> machines();
/// Recorded where the session records.
std::unique_ptr<Machine> make_machine(const PictureOptions& options, const Profile& profile,
                                      const Session& session);

}  // namespace gw::apps
