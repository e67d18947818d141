#include "apps/picture/picture_options.h"

#include "apps/command/command_recorder.h"
#include "apps/command/terminal.h"
#include "gw/error.h"
#include "image/textures.h"
#include "multipass/passes/pass_toml.h"
#include "render/options.h"
#include "scene/maps/finish.h"
#include "scene/maps/map_lists.h"
#include "scene/toml/read_scene.h"

#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

/// The command line writes options with two dashes.
template <class Work>
auto as_usage(const Work& work) {
    try {
        return work();
    } catch (const render::OptionError& error) {
        throw UsageError(std::string("--") + error.what());
    }
}

void add_textures(image::InputFiles& inputs, const scene::Scene& scene) {
    for (const scene::Material& m : scene.materials)
        scene::for_each_map_list(m, [&](std::string_view, const std::vector<scene::Map>& maps) {
            for (const scene::Map& map : maps)
                if (!map.bytes) inputs.add(map.file);
        });
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command.add_option("SCENE", options.scene, "A scene: TOML, Wavefront OBJ or glTF 2.0")
        ->required()
        ->type_name("FILE");
    for (const render::Option& option : render::options())
        command
            .add_option_function<std::string>(
                "--" + option.name,
                [&](const std::string& word) { as_usage([&] { option.set(options, word); }); },
                option.about)
            ->type_name(option.type);
    command.add_flag("--quiet", options.quiet, "No progress, no warnings");
}

void remove_pass_options(CLI::App& command) {
    for (const char* option : {"--renderer", "--samples", "--averaging", "--translucency",
                               "--shadow", "--reflections", "--depth", "--reflected-shadows"})
        command.remove_option(command.get_option(option));
}

render::SceneInput read_input(const PictureOptions& options, Session& session) {
    scene::SceneFile file = scene::read_scene(options.scene);
    std::optional<multipass::PassList> passes;
    if (!file.passes.empty()) passes = multipass::read_passes(file.passes);
    std::vector<std::string> lines = std::move(file.warnings);
    for (std::string& line : image::load_textures(file.scene)) lines.push_back(std::move(line));
    scene::Warnings warnings;
    scene::finish(file.scene, file.films, warnings);
    for (const std::string& line : warnings.lines()) lines.push_back(line);
    if (!options.quiet) print_warnings(lines);
    for (const std::filesystem::path& read : file.files) session.inputs.add(read);
    add_textures(session.inputs, file.scene);
    return {std::move(file.scene), std::move(passes), file.origin, std::move(file.films)};
}

scene::Scene ready_scene(const PictureOptions& options, render::SceneInput input) {
    return as_usage([&] { return render::scene_for(options, std::move(input)); });
}

scene::Scene load_scene(const PictureOptions& options, Session& session, const SceneUse& use) {
    scene::Scene scene = ready_scene(options, read_input(options, session));
    if (options.quiet) return scene;
    print_warnings({render::left_out("gw " + session.words.front(), use.leaves_out, scene)});
    print_warnings_of(scene, options.size, use.by);
    return scene;
}

Profile load_profile(const PictureOptions& options, Session& session) {
    const bool from_file = render::is_profile_file(options.profile);
    if (!from_file) return as_usage([&] { return render::load_profile(options); });
    session.inputs.add(options.profile);
    return render::load_profile(options);
}

Drawing make_drawing(const PictureOptions& options, Session& session) {
    const Profile profile = load_profile(options, session);
    render::SceneInput input = read_input(options, session);
    Drawing drawing =
        as_usage([&] { return render::make_drawing(options, profile, std::move(input)); });
    if (!options.quiet) print_warnings(render::warnings(drawing));
    return drawing;
}

std::unique_ptr<Machine> make_machine(const render::Request& request, const Profile& profile,
                                      const Session& session) {
    return recorded(render::make_machine(request, profile), request.size.width, request.size.height,
                    session.recorder);
}

void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by) {
    const scene::View view = scene::make_view(scene, size.width, size.height);
    print_warnings(scene::warnings_of(scene, view, by));
}

void print_warnings(const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
        if (!line.empty()) print_warning(line);
}

}  // namespace gw::apps
