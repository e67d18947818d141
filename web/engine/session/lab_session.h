// What one visitor of the lab works on: a scene, a machine, and the last picture. Options and answers
// are JSON, planes are arrays. Calls the layers, and keeps what the next call can use again. Throws
// gw::Error.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/run/compare.h"
#include "image/picture.h"
#include "inspect/replay/replayed.h"
#include "inspect/shown/color_map.h"
#include "raytrace/casting/casting.h"
#include "render/drawing.h"
#include "scene/draw/view.h"
#include "scene/toml/read_scene.h"
#include "web/engine/lighting.h"
#include "web/engine/ray_scene.h"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gw::lab {

using Json = nlohmann::ordered_json;

class LabSession {
public:
    /// A texture file's texels, as the file has them: 4 channels of 8 or 16 bits, top row first.
    void add_picture(const std::string& path, int width, int height, int bits,
                     const std::string& texels);
    /// What the engine has: hidden-surface algorithms, and the vectors that it was compiled for.
    Json about(const Json& options);
    /// Reads `path`, a TOML scene, an OBJ or a glTF file. Answers what is in it, and the texture files
    /// that it needs: `embedded` are those that lie within it.
    Json open(const Json& options);
    /// The bytes of the texture file `path` among these, as picture().
    Json embedded(const Json& options);
    /// Finishes the scene with the pictures that were added since: all methods then work on it.
    /// Answers `warnings` of that.
    Json finish(const Json& options);
    /// Draws the scene: options `renderer`, `samples`, `reflections`, `translucency`, `shadow`,
    /// `depth`, and those of a view. Answers passes, counters, and `warnings` for people.
    Json draw(const Json& options);
    /// The same with the manifest that `gw render --manifest` writes.
    std::string manifest(const Json& options);
    /// Draws the scene and keeps it pass by pass: the options of draw(), and `list`, the pass list as
    /// [[pass]] tables of TOML; empty: the scene's or the renderer's. Answers that list as `toml`, and
    /// every pass that ran: name, parameter set, row of the list, counters, estimated seconds.
    Json passes(const Json& options);
    /// The plane `plane` after the pass `pass` of passes(), as picture(); what the pass changed, as
    /// change(). Answers how many pixels changed, and how much the change is amplified.
    Json plane(const Json& options);
    /// The history of the pixel `x`, `y` of passes(), as `gw pixel` prints it.
    Json history(const Json& options);
    /// Reads the file `file`, a recording of a program, and takes its window `window`; none: the one
    /// with most frames. Answers its windows, size and frames.
    Json recording(const Json& options);
    /// The frame `frame` of recording(), in at most `most` steps of some primitives each. Answers what
    /// each step draws, its counters and estimated seconds, the plane that is drawn to, and whether
    /// depths are used. plane() and events() are then of the steps: pass 0 is everything before the
    /// frame.
    Json frame(const Json& options);
    /// What happened to the pixel `x`, `y` of frame(), step by step: fragments with their fate, and
    /// commands that wrote to it without one.
    Json events(const Json& options);
    /// A triangle of three `corners` in a window of `width` x `height` pixels, and all numbers of its
    /// pixel `x`, `y` (row 0 at the bottom) by the manual; the machine's own fragment as `machine`.
    Json pixel(const Json& options);
    /// The scene from the eye `from` with its shadow volumes as translucent objects, its lights and
    /// the view's eye; no `from`: from outside. Answers that eye and the number of volumes.
    Json volumes(const Json& options);
    /// One step towards the state of light that the options name (lighting.h), or its beginning.
    /// Answers what is known of the light, and whether there is more to do.
    Json light(const Json& options);
    /// That light from a view: `exposure`, `gamma`, `ambient` as `gw radiosity` has them.
    Json lit(const Json& options);
    /// The texels of its pixmap `pixmap`, in the same tone.
    Json pixmap(const Json& options);
    /// The five ID buffers of the hemicube on the point `point` of the patch `patch`, as a cross.
    Json hemicube(const Json& options);
    /// Eq. 5 with rays from the item buffer, and the ordinary ray tracer, of the scene as `gw compare`
    /// draws it: the options of draw(). Answer counts of rays and times (ray_scene.h).
    Json rays(const Json& options);
    Json raytraced(const Json& options);
    /// The item buffer in false colours; difference(): which pixels are traced. Answers their number.
    Json identifiers(const Json& options);
    /// Why the two pictures differ: difference() is itembuffer::Reason.
    Json reasons(const Json& options);
    /// The rays of the pixel `x`, `y` of identifiers(); `ordinary`: of the ordinary ray tracer.
    Json path(const Json& options);
    /// The sweeps of `gw study passes` that the scene has: name, values, base of a logarithmic axis
    /// (0: linear), and why it has none.
    Json sweeps(const Json& options);
    /// The scene at `value` of the sweep `sweep`, drawn by all methods: the options of rays(). Answers
    /// counts, processor seconds and estimates at every price list.
    Json sweep_row(const Json& options);
    /// The scene from the eye `from`, else from outside, without faces that look away. Answers that
    /// eye and the matrix from world to clip space.
    Json outside(const Json& options);
    /// Ray casting as `gw cast` does it: options `method`, `inside`, `limit` (of tests), and those of
    /// a view. change() is the picture of tests. Answers counts and time.
    Json cast(const Json& options);
    /// The boxes or voxels that the ray through the pixel `x`, `y` looks into.
    Json visits(const Json& options);
    /// The three inside tests of the polygon `corners` at the centres of `columns` x `rows` pixels,
    /// a bit each, and what each side adds to them at `point`.
    Json inside(const Json& options);
    /// Runs a hidden-surface or hidden-line algorithm: options `algorithm`, `level`, `limit`, and
    /// those of a view. The answer is the text of steps.jsonl that `gw hidden --steps` writes.
    std::string hidden(const Json& options);
    /// What an algorithm in any language works on, as `gw play --polygons` writes it.
    std::string polygons(const Json& options);
    /// Draws and grades the `steps` of such an algorithm, lines of JSON, as `gw play` does.
    std::string play(const Json& options);

    /// The last picture, RGBA of 8 bits, top row first.
    const std::vector<std::uint8_t>& picture() const { return picture_; }
    const std::vector<std::uint8_t>& change() const { return change_; }
    /// Of the last hidden-surface algorithm beside the Z-buffer: hiddensurface::Difference, top row
    /// first. Empty for lines.
    const std::vector<std::uint8_t>& difference() const { return difference_; }

    /// For methods that are no members: a picture of their own, and what the options of every view
    /// name: `width`, `height`, `profile`, `eye`, `at`, `up`, `fov`. Fits what the scene lacks.
    void keep(std::vector<std::uint8_t> picture) { picture_ = std::move(picture); }
    scene::Scene scene_for(const Json& options) const;
    scene::View view_of(const scene::Scene& scene, const Json& options) const;
    Machine& machine_for(const Json& options);

private:
    struct Finished {
        scene::Scene scene;
        std::vector<std::string> warnings;
    };
    /// With the pictures that are here.
    const Finished& finished() const;
    /// Throws Error if a picture is not here.
    void check_pictures() const;
    /// What a renderer draws.
    render::Drawing drawing_of(const Json& options) const;
    struct Rays {
        Machine& machine;
        RayScene& scene;
        scene::View view;
    };
    Rays rays_for(const Json& options);
    const raytrace::RayCaster& caster_for(const Json& options);
    /// A plane for the eye: through the colour map, if there is one.
    image::Picture seen(const Planes& planes, Plane plane, const Profile& profile) const;
    /// Draws with what the last picture left that no eye changes; the same bits. Answers
    /// render::warnings of the first of these pictures, and a line if this one is empty.
    std::vector<std::string> draw_again(Machine& machine, const Json& options);
    void keep_picture(Machine& machine);
    const Lighting& lighting_of(const Json& options) const;
    std::string graded_log(Machine& machine, const hiddensurface::Algorithm& algorithm,
                           const hiddensurface::Input& input, hiddensurface::Level level);
    void keep_difference(const hiddensurface::Result& result, int width);

    scene::SceneFile file_;
    std::map<std::string, TextureRef> pictures_;
    mutable std::optional<Finished> finished_;  ///< made by the first caller
    std::unique_ptr<Machine> machine_;
    std::string machine_key_;
    struct Drawn {
        std::string key;
        std::vector<std::string> warnings;
        std::unique_ptr<render::Drawing> drawing;
        std::function<void(const scene::View&)> draw;  ///< refers to it
    };
    std::map<std::string, Drawn> drawn_;  ///< by renderer; with machine_
    std::unique_ptr<inspect::Replayed> replayed_;
    inspect::Recording recorded_;  ///< of a program
    inspect::ColorMap map_;        ///< of what is replayed; 0 bits: colours are colours
    Plane drawn_plane_ = Plane::Color;
    std::array<std::unique_ptr<Lighting>, 2> lightings_;  ///< gone on with, and solved again
    std::unique_ptr<RayScene> rays_;                      ///< of machine_
    std::string rays_key_;
    std::vector<raytrace::CastShape> shapes_;
    std::unique_ptr<raytrace::RayCaster> caster_;  ///< of shapes_
    std::string caster_key_;
    std::vector<std::uint8_t> picture_, change_, difference_;
};

}  // namespace gw::lab
