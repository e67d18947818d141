// The options that gw render and gw passes share: scene, camera, renderer, machine. Loads the scene
// and makes the machine. Does not draw.
#pragma once

#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "gw/machine.h"
#include "render/drawing.h"
#include "render/renderers.h"
#include "scene/validate/warnings_of.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

using render::Drawing;

struct PictureOptions : render::Request {
    bool quiet = false;  ///< no progress, no warnings
};

/// Adds SCENE and the options. Parsing checks the words, not the files.
void add_picture_options(CLI::App& command, PictureOptions& options);
/// Removes the options of renderer and passes, for a command that chooses them itself.
void remove_pass_options(CLI::App& command);

/// The scene's file with its textures and its own passes, as inputs of the session. Prints the
/// readers' warnings unless quiet. Throws Error.
render::SceneInput read_input(const PictureOptions& options, Session& session);
/// render::scene_for; throws UsageError.
scene::Scene ready_scene(const PictureOptions& options, render::SceneInput input);
/// How a command uses a scene; by default as hidden-surface algorithms do.
struct SceneUse {
    scene::DrawnBy by = scene::DrawnBy::Depth;
    std::vector<std::string> leaves_out = render::left_out_by_algorithms;
};
/// Both. Prints also what a picture of the scene that is used so lacks, unless quiet.
scene::Scene load_scene(const PictureOptions& options, Session& session, const SceneUse& use = {});

/// The profile, an input of the session if it is a file. If it cannot superpose that many samples,
/// throws UsageError, or Error for a profile from a file.
Profile load_profile(const PictureOptions& options, Session& session);

/// Reads scene and profile. Prints render::warnings unless quiet.
Drawing make_drawing(const PictureOptions& options, Session& session);

/// The machine, added to the session's recorder if it has one.
std::unique_ptr<Machine> make_machine(const render::Request& request, const Profile& profile,
                                      const Session& session);

/// What a picture of the scene will not show right, for its own camera.
void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by);

/// A warning for each line that is not empty.
void print_warnings(const std::vector<std::string>& lines);

}  // namespace gw::apps
