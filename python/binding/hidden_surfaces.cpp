// The lecture's hidden-surface algorithms with their steps, and algorithms written in Python.
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/run/compare.h"
#include "hiddensurface/run/estimate.h"
#include "hiddensurface/run/play.h"
#include "hiddensurface/run/step_json.h"
#include "hiddensurface/run/step_words.h"
#include "render/renderers.h"
#include "scene/validate/warnings_of.h"

#include "python/binding/arrays.h"
#include "python/binding/checked.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/warn.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"

namespace gw::python {
namespace {

namespace hs = hiddensurface;

/// What one run of an algorithm made, compared with the Z-buffer.
struct HiddenRun {
    HiddenRun(const scene::Scene& scene, const std::optional<scene::Camera>& camera, int width,
              int height, const Profile& profile)
        : in_view(scene, camera, width, height),
          input(hs::make_input(in_view.scene, in_view.view, profile)) {}
    SceneInView in_view;
    hs::Input input;
    std::string name, title;
    bool in_world = false;
    hs::Level level = hs::Level::Polygon;
    hs::Result result;
    std::vector<std::uint32_t> expected;
    std::vector<hs::Step> steps;

    hs::PictureGrid grid() const { return hs::grid_of(input); }
    std::string step(std::size_t i) const { return hs::to_json(steps[i], i + 1, grid()); }
};
using RunRef = std::shared_ptr<HiddenRun>;

/// Projects the scene without the interpreter's lock; from a copy, since a thread may change it.
RunRef projected(const scene::Scene& scene, const std::optional<scene::Camera>& camera, int width,
                 int height, const Profile& profile) {
    const scene::Scene copy = scene;
    return without_lock(
        [&] { return std::make_shared<HiddenRun>(copy, camera, width, height, profile); });
}

RunRef with_warnings(RunRef run) {
    const SceneInView& now = run->in_view;
    std::vector<std::string> lines{
        render::left_out("gw.hidden", render::left_out_by_algorithms, now.scene)};
    std::erase(lines, "");
    warn(lines);
    warn(without_lock(
        [&] { return scene::warnings_of(now.scene, now.view, scene::DrawnBy::Depth); }));
    return run;
}

void run(HiddenRun& run, const hs::Algorithm& algorithm, int threads) {
    run.name = algorithm.name;
    run.title = algorithm.title;
    run.in_world = algorithm.in_world;
    MachineHolder held(run.input.profile, run.in_view.view.width, run.in_view.view.height, false,
                       threads, false);
    cancelable([&] {
        RendererMachine machine(held);
        hs::StepLog none, log(run.level);
        run.expected = hs::run_on(machine, hs::algorithm_named("z-buffer"), run.input, none).ids;
        run.result = hs::run_on(machine, algorithm, run.input, log);
        hs::compare(run.result, run.expected, run.input);
        run.steps = log.steps();
    });
}

RunRef run_algorithm(const scene::Scene& scene, const std::string& name, hs::Level level, int width,
                     int height, const Profile& profile, const std::optional<scene::Camera>& camera,
                     double limit, int threads) {
    const hs::Algorithm& algorithm = hs::algorithm_named(name);
    check_range("limit", limit, 0, 1e9);
    const RunRef out = with_warnings(projected(scene, camera, width, height, profile));
    out->level = level;
    const hs::Estimate estimate = hs::estimate(algorithm, out->input);
    if (limit > 0 && hs::is_beyond(estimate, limit))
        throw Error(text_of(estimate) + "; limit=0 to try");
    run(*out, algorithm, threads);
    if (algorithm.in_world && out->result.one_plane.pixels > 0)
        warn({hs::one_plane_warning(name, out->input, out->result.one_plane)});
    return out;
}

RunRef play(const scene::Scene& scene, const std::string& lines, const std::string& name, int width,
            int height, const Profile& profile, const std::optional<scene::Camera>& camera) {
    const RunRef out = projected(scene, camera, width, height, profile);
    hs::Play steps = hs::read_play(out->input, name, lines);
    out->level = steps.level;
    run(*out, hs::played(std::move(steps)), 0);
    out->name = out->title = name;
    return out;
}

std::string log_of(const HiddenRun& run) {
    std::string text =
        hs::log_header(run.input, {run.name, run.title, false, run.in_world, run.level},
                       hs::hex_colors(run.input)) +
        "\n";
    for (std::size_t i = 0; i < run.steps.size(); ++i) text += run.step(i) + "\n";
    const auto blame = hs::blame_of(run.steps, run.result, run.input.view.width);
    return text + hs::log_end(run.steps.size(), run.result.counts, hs::grid_of(run.input), blame) +
           "\n";
}

py::dict counts_of(const HiddenRun& run) {
    py::dict out;
    for (const auto& [name, count] : hs::count_names()) out[name] = run.result.counts.*count;
    return out;
}

py::list grades(const HiddenRun& run) {
    py::list out;
    for (const hs::PolygonGrade& g : hs::grades_of(run.result, run.expected)) {
        py::dict row;
        row["polygon"] = g.id;
        row["expected"] = g.expected;
        row["shown"] = g.shown;
        row["missing"] = g.missing;
        row["extra"] = g.extra;
        out.append(row);
    }
    return out;
}

template <class T, class V>
auto picture_of(V hs::Result::*member) {
    return [member](const py::object& self) {
        const auto& run = self.cast<const HiddenRun&>();
        return view_of<T>((run.result.*member).data(),
                          rows(run.in_view.view.height, run.in_view.view.width), self);
    };
}

void add_run(py::module_& m) {
    py::class_<HiddenRun, RunRef>(
        m, "HiddenRun", "A run of a hidden-surface algorithm, compared with the Z-buffer.")
        .def_readonly("name", &HiddenRun::name, "The algorithm's.")
        .def_readonly("title", &HiddenRun::title, "For people, with the lecture's row.")
        .def_property_readonly("ids", picture_of<std::uint32_t>(&hs::Result::ids),
                               "The polygon at each pixel, a view; 0: the background.")
        .def_property_readonly("writes", picture_of<std::uint8_t>(&hs::Result::writes),
                               "The number of writes of each pixel, at most 255, a view.")
        .def_property_readonly("difference", picture_of<std::uint8_t>(&hs::Result::difference),
                               "From the Z-buffer: 0 none, 1 tie, 2 edge, 3 snap, 4 wrong; a view.")
        .def("counts", &counts_of, "All counts by name.")
        .def("grades", &grades, "Pixels by polygon: expected, shown, missing, extra.")
        .def("__len__", [](const HiddenRun& r) { return r.steps.size(); })
        .def(
            "step_json",
            [](const HiddenRun& r, std::size_t i) {
                if (i >= r.steps.size()) throw py::index_error("step " + std::to_string(i));
                return r.step(i);
            },
            py::arg("step"), "Step 0, 1, ... as a line of the log.")
        .def(
            "sentence",
            [](const HiddenRun& r, std::size_t i, const std::string& language) {
                if (i >= r.steps.size()) throw py::index_error("step " + std::to_string(i));
                if (language != "en" && language != "ja")
                    throw Error("language: '" + language + "'; expected en or ja");
                return hs::sentence_of(r.steps[i], r.grid(), language);
            },
            py::arg("step"), py::arg("language") = "en",
            "What decided the step, in English (en) or Japanese (ja).")
        .def("log", &log_of, "The step log: a header, a line for each step, an end.");
}

}  // namespace

void add_hidden_surfaces(py::module_& m) {
    add_enum<hs::Level>(m, "Level", "The detail of a step log.",
                        {{"Polygon", hs::Level::Polygon},
                         {"Line", hs::Level::Line},
                         {"Span", hs::Level::Span},
                         {"Pixel", hs::Level::Pixel}});
    add_run(m);
    m.def(
        "hidden_algorithms",
        [] {
            py::dict out;
            for (const hs::Algorithm& a : hs::algorithms()) out[py::str(a.name)] = a.title;
            return out;
        },
        "Titles by name, in the lecture's order.");
    m.def("run_hidden", &run_algorithm, py::arg("scene"), py::arg("algorithm"),
          py::arg("level") = hs::Level::Polygon, py::kw_only(), py::arg("width") = 320,
          py::arg("height") = 240, py::arg("profile") = vgx(), py::arg("camera") = py::none(),
          py::arg("limit") = 300.0, py::arg("threads") = 0,
          "Runs an algorithm. Throws Error if it would take more than `limit` seconds; 0: tries.");
    m.def(
        "hidden_polygons_json",
        [](const scene::Scene& scene, int width, int height, const Profile& profile,
           const std::optional<scene::Camera>& camera) {
            const RunRef run = with_warnings(projected(scene, camera, width, height, profile));
            return hs::polygons_json(run->input, hs::hex_colors(run->input));
        },
        py::arg("scene"), py::kw_only(), py::arg("width") = 320, py::arg("height") = 240,
        py::arg("profile") = vgx(), py::arg("camera") = py::none(),
        "The polygons on the window grid, for an algorithm of one's own.");
    m.def("play_hidden", &play, py::arg("scene"), py::arg("lines"), py::arg("name") = "mine",
          py::kw_only(), py::arg("width") = 320, py::arg("height") = 240,
          py::arg("profile") = vgx(), py::arg("camera") = py::none(),
          "Draws and grades the steps of such an algorithm, lines of JSON.");
}

}  // namespace gw::python
