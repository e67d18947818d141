#include "study/distance.h"

#include "hiddensurface/run/scan_line_renderer.h"
#include "multipass/frame/driver.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::study {
namespace {

MeshData torus(const Rings& rings, int sides) {
    const auto& all = scene::shapes();
    const auto shape = std::find_if(all.begin(), all.end(),
                                    [](const scene::Shape& s) { return s.name == "torus"; });
    return shape->make({rings.radius, rings.tube, 2.0 * sides, double(sides)});
}

scene::Scene with_sides(const Rings& rings, int sides) {
    scene::Scene scene = rings.scene;
    std::uint32_t id = 0;
    for (scene::Object& object : scene.objects)
        object.mesh = scene::make_numbered_mesh(torus(rings, sides), id);
    return scene;
}

Distance distance(const scene::Scene& scene, int sides, Machine& machine, const scene::View& view) {
    machine.execute(hiddensurface::scan_line_picture(scene, view, machine.profile()));
    const Fractions truth = fractions(machine);
    const auto rms = [&](multipass::Renderer renderer) {
        multipass::render(machine, scene, view, {.renderer = renderer});
        return difference(fractions(machine), truth).rms;
    };
    return {machine.profile().name, sides, rms(multipass::Renderer::Hardware),
            rms(multipass::Renderer::Multipass)};
}

}  // namespace

std::vector<Distance> distances(const Rings& rings, const std::vector<int>& sides,
                                const std::vector<Profile>& profiles, const MachineMaker& make,
                                int width, int height,
                                const std::function<void(const std::string&)>& say) {
    std::vector<Distance> rows;
    const scene::View view = scene::make_view(rings.scene, width, height);
    for (const Profile& profile : profiles)
        for (const int n : sides) {
            say(fmt::format("{}, {} sides", profile.name, n));
            rows.push_back(distance(with_sides(rings, n), n, *make(profile), view));
        }
    return rows;
}

plot::Plot distance_plot(const std::vector<Distance>& rows) {
    plot::Plot plot{
        .title = "Distance from the picture shaded at every pixel",
        .caption =
            "Rings of 2n x n quads, each of two triangles: equations 1 and 2, lit at vertices, against "
            "equation 3 of the same polygons.",
        .x = {"sides n of a ring's tube", 2},
        .y = {"distance (rms), 255ths of white", 10}};
    for (const Distance& row : rows) {
        const std::string names[] = {row.profile + ", hardware", row.profile + ", multi-pass"};
        const double values[] = {row.hardware, row.multipass};
        for (int i = 0; i < 2; ++i) {
            auto series = std::find_if(plot.series.begin(), plot.series.end(),
                                       [&](const plot::Series& s) { return s.name == names[i]; });
            if (series == plot.series.end()) {
                plot.series.push_back({.name = names[i], .dashed = i == 0});
                series = plot.series.end() - 1;
            }
            series->points.push_back({double(row.sides), values[i]});
        }
    }
    return plot;
}

}  // namespace gw::study
