#include "apps/render/turntable.h"

#include "image/output/output_set.h"
#include "image/write.h"
#include "itembuffer/render.h"
#include "multipass/maps/scene_maps.h"

#include <fmt/format.h>

#include <functional>

namespace gw::apps {
namespace {

// "rings.png" becomes "rings_007.png".
std::filesystem::path numbered(const std::filesystem::path& file, int number) {
    std::filesystem::path name = file.stem();
    name += fmt::format("_{:03}", number);
    name += file.extension();
    return file.parent_path() / name;
}

// Draws views of the scene. Passes keep from view to view what no view decides, unless maps are
// generated from the scene: those hold for one.
std::function<void(const scene::View&)> view_drawer(const Drawing& drawing, Machine& machine) {
    DrawOptions options = draw_options(drawing.options);
    if (drawing.renderer.passes) options.passes.passes = passes_of(drawing);
    const bool by_passes = drawing.renderer.passes == multipass::Renderer::Multipass &&
                           options.traced &&
                           !multipass::has_scene_maps(drawing.scene, options.passes);
    if (!by_passes) return [&](const scene::View& view) { draw(drawing, view, machine); };
    const std::shared_ptr<multipass::Driver> driver =
        itembuffer::make_driver(machine, drawing.scene, options.passes, options.rays);
    return [driver](const scene::View& view) { driver->draw(view); };
}

}  // namespace

void draw_turntable(Drawing& drawing, const FrameFiles& files, int pictures,
                    std::pair<int, int> first_last, Progress& progress, const Session& session) {
    const Size size = drawing.options.size;
    const scene::Camera camera = *drawing.scene.camera;
    const auto machine = make_machine(drawing.options, drawing.profile, session);
    const auto draw_view = view_drawer(drawing, *machine);
    const auto [first, last] = first_last;
    for (int number = first; number <= last; ++number)
        session.inputs.check(numbered(files.picture, number));
    for (int number = first; number <= last; ++number) {
        progress.at(fmt::format("drawing picture {} of {}", number, pictures));
        drawing.scene.camera = scene::turntable(camera, 360.0 * (number - 1) / pictures);
        draw_view(scene::make_view(drawing.scene, size.width, size.height));
        image::OutputSet output(session.inputs);
        const image::Picture picture = image::picture_of(machine->planes().color, size.width,
                                                         size.height, drawing.profile.color_bits);
        image::put_picture(output.add(numbered(files.picture, number)),
                           image::toned(picture, files.tone));
        output.commit();
    }
}

}  // namespace gw::apps
