// gw styles: one scene in six styles [L1 a to f], as one figure.
#include "hiddensurface/interface/styles.h"
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/hidden/pictures.h"
#include "apps/picture/picture_options.h"
#include "gw/error.h"
#include "image/output/output_file.h"
#include "image/write.h"
#include "multipass/frame/driver.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

struct StylesOptions {
    PictureOptions picture{{.size = {320, 240}}};
    std::filesystem::path output;
};

/// The scene without maps; all lights cast shadows in this way.
scene::Scene plain(scene::Scene scene, scene::Shadow shadow) {
    for (scene::Material& m : scene.materials)
        for (auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
            maps->clear();
    for (scene::Light& light : scene.lights) light.shadow = shadow;
    return scene;
}

class Figure {
public:
    Figure(const StylesOptions& options, const Profile& profile, const scene::Scene& scene,
           const Session& session)
        : profile_(profile),
          view_(scene::make_view(scene, options.picture.size.width, options.picture.size.height)),
          machine_(make_machine(options.picture, profile, session)) {}

    image::Picture of(const CommandList& list) {
        machine_->execute(list);
        return picture();
    }
    image::Picture of(const scene::Scene& scene) {
        multipass::render(*machine_, scene, view_, {});
        return picture();
    }
    const scene::View& view() const { return view_; }

private:
    image::Picture picture() {
        image::Picture shown = image::picture_of(machine_->planes().color, view_.width,
                                                 view_.height, profile_.color_bits);
        for (std::uint16_t& v : shown.values)
            v = static_cast<std::uint16_t>(v >> (profile_.color_bits - 8));
        shown.bits = 8;
        return shown;
    }

    Profile profile_;
    scene::View view_;
    std::unique_ptr<Machine> machine_;
};

int styles(const StylesOptions& options, Session& session) {
    check_picture_target(options.output);
    const Progress progress("drawing", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    session.inputs.check(options.output);
    Figure figure(options, profile, scene, session);
    const image::Picture a = figure.of(hs::wireframe(scene, figure.view())),
                         b = figure.of(hs::depth_cueing(scene, figure.view())),
                         c = figure.of(hs::hidden_lines(scene, figure.view(), profile)),
                         d = figure.of(plain(scene, scene::Shadow::None)),
                         e = figure.of(plain(scene, scene::Shadow::Volume)), f = figure.of(scene);
    image::write_picture(options.output, sheet_of({{a, b, c}, {d, e, f}}));
    return Done;
}

}  // namespace

Command add_styles(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("styles",
                           "One scene six ways: wireframe, depth cueing, hidden lines "
                           "removed; shaded, with shadows, with texture");
    const auto options = std::make_shared<StylesOptions>();
    add_picture_options(*command, options->picture);
    remove_pass_options(*command);
    command->get_option("--size")->description(
        "Pixels of each of the six, both sides 1..4096 (default 320x240)");
    command->add_option("-o,--output", options->output, "The figure")
        ->required()
        ->type_name("IMAGE");
    command->footer("Example:\n  build/release/bin/gw styles scenes/styles.toml -o styles.png");
    return {command, [options](Session& session) { return styles(*options, session); }};
}

}  // namespace gw::apps
