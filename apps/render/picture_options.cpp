#include "apps/render/picture_options.h"

#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/terminal.h"
#include "apps/recordings/machine_options.h"
#include "apps/render/renderers.h"
#include "apps/render/scene_warnings.h"
#include "gw/error.h"
#include "image/textures.h"
#include "multipass/frame/superpose.h"
#include "multipass/passes/pass_toml.h"
#include "scene/toml/read_profile.h"
#include "scene/toml/read_scene.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <map>

namespace gw::apps {
namespace {

void add_camera_options(CLI::App& command, PictureOptions& options) {
    scene::CameraOverrides& camera = options.camera;
    const auto point = [&command](const char* name, std::optional<dvec3>& to, const char* help) {
        command
            .add_option_function<std::string>(
                name, [name, &to](const std::string& word) { to = point_from(name, word); }, help)
            ->type_name("X,Y,Z");
    };
    point("--eye", camera.eye, "The eye's position (default: the scene's camera, or fitted)");
    point("--at", camera.at, "The point it looks at");
    point("--up", options.up, "The direction that is up in the picture");
    command
        .add_option_function<std::string>(
            "--fov",
            [&camera](const std::string& word) {
                camera.fov = number_from("--fov", word, 0.1, 179);
            },
            "Vertical angle of view")
        ->type_name("DEGREES");
}

void add_machine_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option_function<std::string>(
            "--machine",
            [&](const std::string& word) {
                options.machine = one_of("--machine", word, machines());
            },
            "The machine that draws; both give the same bits (default " + machines().front() + ")")
        ->type_name("NAME");
    add_threads_option(command, options.threads);
    command
        .add_option_function<std::string>(
            "--samples",
            [&](const std::string& word) {
                options.samples = whole_number_from("--samples", word, 1, 32768);
            },
            "Pictures superposed against jagged edges (default 1; in groups if the accumulation "
            "buffer cannot hold them all)")
        ->type_name("N");
    command
        .add_option("--profile", options.profile,
                    "vgx, reality, ideal, opengl or a TOML file (default vgx)")
        ->type_name("NAME|FILE.toml");
}

// Adds an option whose words stand for values.
template <class Value, class Target>
void add_choice(CLI::App& command, const std::string& name, std::map<std::string, Value> words,
                Target& target, const std::string& help) {
    std::vector<std::string> known;
    for (const auto& [word, value] : words) known.push_back(word);
    command
        .add_option_function<std::string>(
            name,
            [=, &target](const std::string& word) { target = words.at(one_of(name, word, known)); },
            help)
        ->type_name("NAME");
}

void add_effect_options(CLI::App& command, PictureOptions& options) {
    using enum multipass::Translucency;
    add_choice(command, "--translucency",
               std::map<std::string, multipass::Translucency>{
                   {"sorted", Sorted}, {"unsorted", Unsorted}, {"layers", Layers}},
               options.translucency,
               "Translucent faces: sorted by distance (default), unsorted, "
               "or in exact layers pixel by pixel");
    add_choice(command, "--shadow",
               std::map<std::string, scene::Shadow>{{"none", scene::Shadow::None},
                                                    {"volume", scene::Shadow::Volume},
                                                    {"map", scene::Shadow::Map}},
               options.shadow,
               "none, volume or map, for all lights that cast shadows (default: the scene's)");
    add_choice(
        command, "--averaging", std::map<std::string, bool>{{"simple", false}, {"weighted", true}},
        options.weighted,
        "Mean of --samples: simple (default), or weighted with integers that fall towards the "
        "pixel's border");
}

void add_ray_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option_function<std::string>(
            "--reflections",
            [&](const std::string& word) {
                options.traced = one_of("--reflections", word, {"rays", "maps"}) == "rays";
            },
            "Reflections of materials with illum 3 to 7: by rays from an item buffer (default), "
            "or by maps only")
        ->type_name("rays|maps");
    command
        .add_option_function<std::string>(
            "--depth",
            [&](const std::string& word) {
                options.rays.depth = whole_number_from("--depth", word, 1, 64);
            },
            "Rays in a path, with the one from the eye (default 2; glass needs about 6)")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--reflected-shadows",
            [&](const std::string& word) {
                options.rays.shadow_maps =
                    one_of("--reflected-shadows", word, {"rays", "maps"}) == "maps";
            },
            "Shadows in reflections: by shadow rays (default), or by the lights' shadow maps")
        ->type_name("rays|maps");
}

std::vector<std::string> profile_names() {
    std::vector<std::string> names;
    for (const Profile& profile : profiles()) names.push_back(profile.name);
    return names;
}

void add_textures(image::InputFiles& inputs, const scene::Scene& scene) {
    for (const scene::Material& m : scene.materials)
        for (const auto* maps :
             {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
            for (const scene::Map& map : *maps) inputs.add(map.file);
}

/// The options' points are the file's (scene::SceneFile::origin).
scene::CameraOverrides counted_from(scene::CameraOverrides camera, const dvec3& origin) {
    if (camera.eye) *camera.eye -= origin;
    if (camera.at) *camera.at -= origin;
    return camera;
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command.add_option("SCENE", options.scene, "A TOML scene or a Wavefront OBJ file")
        ->required()
        ->type_name("FILE");
    command
        .add_option_function<std::string>(
            "--renderer",
            [&](const std::string& word) {
                options.renderer = one_of("--renderer", word, renderer_names());
            },
            renderers_help())
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [&](const std::string& word) { options.size = size_from("--size", word); },
            "Pixels, both sides 1..4096 (default 640x480)")
        ->type_name("WxH");
    add_machine_options(command, options);
    add_camera_options(command, options);
    add_effect_options(command, options);
    add_ray_options(command, options);
    command.add_flag("--quiet", options.quiet, "No progress, no warnings");
}

void remove_pass_options(CLI::App& command) {
    for (const char* option : {"--renderer", "--samples", "--averaging", "--translucency",
                               "--shadow", "--reflections", "--depth", "--reflected-shadows"})
        command.remove_option(command.get_option(option));
}

SceneWithPasses load_scene_with_passes(const PictureOptions& options, Session& session) {
    if (options.scene.empty()) throw UsageError("SCENE is empty; expected the name of a file");
    if (options.camera.eye && options.camera.eye == options.camera.at) {
        throw UsageError("--eye and --at are the same point; expected two");
    }
    scene::SceneFile file = scene::read_scene(options.scene);
    const auto warn = [&](const std::vector<std::string>& lines) {
        if (options.quiet) return;
        for (const std::string& line : lines) print_warning(line);
    };
    warn(file.warnings);
    scene::Scene& scene = file.scene;
    std::optional<multipass::PassList> passes;
    if (!file.passes.empty()) passes = multipass::read_passes(file.passes);
    warn(image::load_textures(scene));
    for (const std::filesystem::path& read : file.files) session.inputs.add(read);
    add_textures(session.inputs, scene);
    scene::add_defaults(scene, options.size.width, options.size.height);
    scene.camera = scene::override_camera(*scene.camera, counted_from(options.camera, file.origin));
    if (options.up) scene.camera->up = *options.up;
    for (scene::Light& light : scene.lights)
        if (options.shadow && light.shadow != scene::Shadow::None) light.shadow = *options.shadow;
    return {std::move(scene), std::move(passes), file.origin};
}

scene::Scene load_scene(const PictureOptions& options, Session& session, scene::DrawnBy by) {
    scene::Scene scene = load_scene_with_passes(options, session).scene;
    if (!options.quiet) print_warnings_of(scene, options.size, by);
    return scene;
}

DrawOptions draw_options(const PictureOptions& options) {
    DrawOptions draw{.passes = {.translucency = options.translucency,
                                .samples = options.samples,
                                .weighted = options.weighted},
                     .rays = options.rays,
                     .traced = options.traced};
    draw.rays.threads = options.threads;
    return draw;
}

Profile load_profile(const PictureOptions& options, Session& session) {
    const bool from_file = std::filesystem::path(options.profile).extension() == ".toml";
    if (from_file) session.inputs.add(options.profile);
    const Profile profile =
        from_file ? scene::read_profile(options.profile)
                  : profile_named(one_of("--profile", options.profile, profile_names()));
    // As many groups as a group has samples; with weights only one group.
    const int group = multipass::most_pictures(profile),
              most = options.weighted ? group : group * group;
    if (options.samples > most) {
        const std::string what = fmt::format(
            "--samples '{}': more than profile {} superposes{}; expected 1..{}", options.samples,
            profile.name, options.weighted ? " with weights" : "", most);
        if (from_file) throw Error(what);
        throw UsageError(what);
    }
    return profile;
}

std::vector<std::string> machines() { return {"fast", "reference"}; }

std::unique_ptr<Machine> make_machine(const PictureOptions& options, const Profile& profile,
                                      const Session& session) {
    const auto [width, height] = options.size;
    auto machine = options.machine == "reference"
                       ? make_reference(profile, width, height)
                       : make_fast(profile, width, height, {.threads = options.threads});
    return recorded(std::move(machine), width, height, session.recorder);
}

}  // namespace gw::apps
