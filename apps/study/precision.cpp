#include "apps/study/precision.h"

#include "gw/base/elementary.h"
#include "hiddensurface/run/scan_line_renderer.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::study {
namespace {

/// The strength of all lights together. No vertex reaches white, at which one pass would clamp and
/// several would not.
constexpr double brightness = 0.6;

/// n directional lights, evenly over the half sphere behind the viewer's left shoulder, of `strength`
/// in total.
std::vector<scene::Light> lights_around(int n, double strength) {
    std::vector<scene::Light> lights;
    for (int i = 0; i < n; ++i) {
        const double up = 0.25 + 0.7 * (i + 0.5) / n, turn = 2 * pi * 0.6180339887498949 * i;
        const double side = std::sqrt(1 - up * up);
        const vec3 to_light(dvec3(-0.4 + side * gw::cos(turn), up, 0.6 + side * gw::sin(turn)));
        lights.push_back({.name = fmt::format("{}", i + 1),
                          .direction = -to_light,
                          .Id = vec3(float(strength / n))});
    }
    return lights;
}

scene::Scene lit(scene::Scene scene, int n, double strength) {
    scene.lights = lights_around(n, strength);
    return scene;
}

struct AddingStudy {
    const scene::Scene& scene;
    scene::View view;
    Machine& machine;

    Fractions draw(const scene::Scene& s, const multipass::Options& options) const {
        multipass::render(machine, s, view, options);
        return fractions(machine);
    }

    Fractions in_frame_buffer(int n) const { return draw(lit(scene, n, brightness), {}); }

    Fractions in_accumulation(int n) const {
        const scene::Scene s = lit(scene, n, brightness);
        multipass::PassList list = multipass::passes_for(s, multipass::Renderer::Multipass);
        const auto specular = std::find_if(list.begin(), list.end(), [](const multipass::Pass& p) {
            return p.name == multipass::specular_pass.name;
        });
        multipass::Pass add = multipass::add_pass;
        add.lights = multipass::PassLights::Each;
        list.insert(specular + 1, add);
        return draw(s, {.pass_list = list});
    }

    Fractions at_full_strength(int n) const {
        const std::vector<scene::Light> lights = lights_around(n, n * brightness);
        scene::Scene one = scene;
        CommandList list;
        list.add(BeginPass{.name = "clear sum"});
        list.add(Clear{.planes = mask_of(Plane::Accum)});
        for (const scene::Light& light : lights) {
            one.lights = {light};
            const auto passes = multipass::passes_for(one, multipass::Renderer::Multipass);
            list.append(multipass::frame_list(one, view, passes, vec3(0), true));
            list.add(BeginPass{.name = "add"});
            list.add(Accumulate{AccumOp::Accum, 1});
        }
        list.add(BeginPass{.name = "return"});
        list.add(Accumulate{AccumOp::Return, 1.0f / float(n)});
        machine.execute(list);
        return fractions(machine);
    }

    double saturated(int n) const {
        const Fractions values = draw(lit(scene, n, n * brightness), {});
        const auto lit_ones =
            std::count_if(values.begin(), values.end(), [](double v) { return v > 0; });
        return double(std::count(values.begin(), values.end(), 1.0)) / double(lit_ones);
    }
};

Profile exact(Profile profile) {
    profile.name += " at 16 bits";
    profile.color_bits = profile.lit_bits = 16;
    profile.accum_bits = 32;
    profile.max_lights = 1024;
    return profile;
}

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

std::vector<Adding> adding(scene::Scene scene, const std::vector<int>& lights,
                           const std::vector<Profile>& profiles, const MachineMaker& make,
                           int width, int height,
                           const std::function<void(const std::string&)>& say) {
    scene.background = vec3(0);
    const scene::View view = scene::make_view(scene, width, height);
    std::vector<Adding> rows;
    for (const Profile& profile : profiles) {
        const auto machine = make(profile), exact_machine = make(exact(profile));
        const AddingStudy study{scene, view, *machine}, truth_study{scene, view, *exact_machine};
        for (const int n : lights) {
            say(fmt::format("{}, {} lights", profile.name, n));
            const Fractions truth = truth_study.draw(lit(scene, n, brightness),
                                                     {.renderer = multipass::Renderer::Hardware});
            rows.push_back({profile.name, n, difference(study.in_frame_buffer(n), truth),
                            difference(study.in_accumulation(n), truth),
                            difference(study.at_full_strength(n), truth), study.saturated(n)});
        }
    }
    return rows;
}

plot::Plot adding_plot(const std::vector<Adding>& rows) {
    plot::Plot plot{
        .title = "Rounding of added passes",
        .caption =
            "n lights of 1/n each, a diffuse and a specular pass for each light, against one pass at 16 "
            "bits. Full strength: lights of 1, summed in the accumulation buffer, returned times 1/n.",
        .x = {"lights n", 2},
        .y = {"error (rms), 255ths of white", 10}};
    std::vector<std::string> profiles;
    for (const Adding& row : rows)
        if (std::find(profiles.begin(), profiles.end(), row.profile) == profiles.end())
            profiles.push_back(row.profile);
    for (const std::string& profile : profiles) {
        plot::Series frame{profile + ", frame buffer"}, full{profile + ", full strength"};
        full.dashed = true;
        for (const Adding& row : rows) {
            if (row.profile != profile) continue;
            frame.points.push_back({double(row.lights), row.frame_buffer.rms});
            full.points.push_back({double(row.lights), row.full_strength.rms});
        }
        plot.series.push_back(std::move(frame));
        plot.series.push_back(std::move(full));
    }
    return plot;
}

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
