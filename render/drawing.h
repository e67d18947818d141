// A request with all that its picture needs: scene and profile. Draws it, and says with which
// passes. Does not read scenes and textures: the doors do, each from files of its own kind.
#pragma once

#include "gw/machine.h"
#include "multipass/frame/frame.h"
#include "render/renderers.h"
#include "render/request.h"
#include "scene/film.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gw::render {

struct Drawing {
    Request request;
    Profile profile;
    scene::Scene scene;  ///< with a camera and textures
    /// Instead of the renderer's, which must have passes.
    std::optional<multipass::PassList> pass_list{};
    raytrace::RayCounts* counts = nullptr;  ///< the rays of each picture are added here
    std::vector<scene::Film> films{};       ///< scene::SceneFile::films
    bool is_fitted = false;                 ///< nobody gave a camera

    const Renderer& renderer() const { return renderer_named(request.renderer); }
    scene::View view() const;
};

/// A scene as a door has read it, with its textures.
struct SceneInput {
    scene::Scene scene;
    std::optional<multipass::PassList> passes{};  ///< the scene's own
    /// scene::SceneFile::origin, if the request's points are the file's.
    dvec3 origin{0};
    std::vector<scene::Film> films{};  ///< scene::SceneFile::films
};

/// The camera with the options' values. Throws OptionError if eye and at are one point, or the
/// given up is 0 or along the view.
scene::Camera with_options(const scene::Camera& camera, const scene::CameraOverrides& options);

/// The scene as the request wants it: a camera and a light are added if it lacks them, its camera
/// and shadows changed. Throws OptionError as with_options does.
scene::Scene scene_for(const Request& request, SceneInput input);

/// The ready scene with its profile. Its passes replace those of the renderer multipass only. Throws
/// OptionError also if the profile cannot superpose the samples.
Drawing make_drawing(const Request& request, const Profile& profile, SceneInput input);

/// What the picture will not show, or not show right: a line each, for people.
std::vector<std::string> warnings(const Drawing& drawing);
/// One more line if the picture that the machine has now shows nothing; empty: it does.
std::string empty_warning(const Drawing& drawing, Machine& machine);

/// The profile of this name, or of a file. Throws OptionError for an unknown name, and if it cannot
/// superpose the samples; Error for a wrong file.
Profile load_profile(const Request& request);
void check_samples(const Request& request, const Profile& profile);

/// A machine of the request's size and threads.
std::unique_ptr<Machine> make_machine(const Request& request, const Profile& profile);

/// Draws one picture into the machine's colour plane: the samples, superposed. The view is as large
/// as the machine's window.
void draw(const Drawing& drawing, const scene::View& view, Machine& machine);

/// Whether maps of the scene that the passes look up are generated from the scene itself.
bool has_scene_maps(const Drawing& drawing);
/// The scene with these maps, for views in the direction of `view`. Overwrites the machine's
/// planes.
scene::Scene scene_with_maps(const Drawing& drawing, const scene::View& view, Machine& machine);

/// Draws views of one drawing, one after the other, with the bits of draw(). Keeps what no view
/// changes: meshes of maps, shadow volumes and maps, hierarchies of rays. Refers to both, which
/// must outlive it; of the drawing only the scene's camera may change. Maps that are generated from
/// the scene depend on the view, so then each view is drawn alone.
std::function<void(const scene::View&)> view_drawer(const Drawing& drawing, Machine& machine);

/// A picture of each component [Fig. 4], on black if the background is a component of its own. The
/// renderer must have passes.
std::vector<multipass::ComponentImage> components(const Drawing& drawing, const scene::View& view,
                                                  Machine& machine);

/// The passes that draw it. Empty for a renderer without passes.
multipass::PassList pass_list(const Drawing& drawing);

/// The origin of a pass that the driver runs: the paper's parameter set, and the row in the list.
struct PassSource {
    std::string set;
    std::size_t row = 0;
};
/// By the names of the passes. Passes that the driver adds have none.
std::map<std::string, PassSource> pass_sources(const Drawing& drawing);
/// Their parameter sets alone.
std::map<std::string, std::string> parameter_sets(const Drawing& drawing);

itembuffer::Options ray_options(const Request& request);

}  // namespace gw::render
