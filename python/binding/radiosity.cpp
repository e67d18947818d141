// Pixmap radiosity, shot by shot.
#include "radiosity/display/display.h"
#include "radiosity/model/figures.h"
#include "radiosity/solver/direct_light.h"
#include "radiosity/solver/solver.h"
#include "radiosity/solver/stall.h"
#include "scene/draw/nearest.h"
#include "scene/validate/check.h"
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

namespace rd = radiosity;

/// A solver with the scene that it solves.
class HeldSolver {
public:
    HeldSolver(const scene::Scene& scene, int hemicube, double texels_per_unit, int patch,
               int threads)
        : scene_(scene), options_{.texels_per_unit = texels_per_unit, .patch = patch} {
        scene::check_scene(scene);
        check_threads(threads);
        check_whole("patch", patch, 1, 4096);
        check_range("texels_per_unit", texels_per_unit, 0, 1e9);
        rd::SolverOptions options;
        options.form_factors.hemicube = hemicube;
        options.form_factors.threads = threads;
        options.form_factors.cancel = &cancel_;
        form_factors_ = options.form_factors;
        solver_ = without_lock([&] {
            return std::make_unique<rd::Solver>(rd::make_lit_model(scene_, options_, form_factors_),
                                                options);
        });
        watch();
        warn(without_lock([&] { return scene::warnings_of(scene_, {}, scene::DrawnBy::Rays); }));
        warn(scene::left_out_by_radiosity(scene_));
        warn(rd::left_out(solver_->model()));
    }

    py::object shoot() {
        std::uint64_t shots = 0;
        double unshot = 0;
        const auto shot = cancelable(turn_, cancel_, [&] {
            const auto done = solver_->shoot();
            shots = solver_->solution().shots;
            unshot = books(solver_->model(), solver_->solution()).unshot_share();
            if (done && stall_->after_shot(unshot))
                why_stalled_ = rd::why_stalled(solver_->model(), shots, unshot);
            return done;
        });
        if (!shot) return py::none();
        py::dict out;
        out["shot"] = shots;
        out["patch"] = shot->patch;
        out["flux"] = shot->flux;
        out["hemicubes"] = shot->hemicubes;
        out["unshot"] = unshot;
        return out;
    }

    /// The next shot of the iterator, which ends if the unshot light cannot fall.
    py::object next() {
        const auto stalled = in_turn(turn_, [&] { return why_stalled_; });
        const py::object shot = stalled ? py::none() : shoot();
        if (stalled) warn({*stalled});
        if (shot.is_none()) throw py::stop_iteration();
        return shot;
    }

    py::dict books_now() const {
        const rd::Books b =
            in_turn(turn_, [&] { return books(solver_->model(), solver_->solution()); });
        py::dict out;
        out["emitted"] = b.emitted;
        out["absorbed"] = b.absorbed;
        out["unshot"] = b.unshot;
        out["escaped"] = b.escaped;
        out["unshot_share"] = b.unshot_share();
        out["imbalance"] = b.imbalance();
        return out;
    }

    /// "radiosity", "irradiance", "unshot", "area": of all texels, as arrays by pixmap.
    py::dict pixmaps(const std::string& what) const {
        struct Values {
            std::string name;
            int width = 0, height = 0;
            std::vector<double> values;
        };
        auto all = in_turn(turn_, [&] {
            const rd::PixmapModel& model = solver_->model();
            std::vector<Values> found;
            for (const rd::Pixmap& pixmap : model.pixmaps) {
                found.push_back({pixmap.name, pixmap.width, pixmap.height, {}});
                for (std::size_t i = 0; i < pixmap.count(); ++i) {
                    const dvec3 v = value_of(what, pixmap.first + i);
                    found.back().values.insert(found.back().values.end(), {v.x, v.y, v.z});
                }
            }
            return found;
        });
        py::dict out;
        for (Values& pixmap : all) {
            std::string name = pixmap.name;
            for (int k = 2; out.contains(name); ++k) name = pixmap.name + " " + std::to_string(k);
            out[py::str(name)] =
                array_of<double>(std::move(pixmap.values), rows(pixmap.height, pixmap.width, 3));
        }
        return out;
    }

    py::dict form_factors(std::int64_t patch) {
        rd::Row row = cancelable(turn_, cancel_, [&] {
            const rd::PixmapModel& model = solver_->model();
            check_whole("patch", double(patch), 0, double(model.patches.size()) - 1);
            return rd::FormFactors(model, form_factors_).from_patch(std::size_t(patch));
        });
        py::dict out;
        const auto count = py::ssize_t(row.texels.size());
        out["texels"] = array_of<std::uint32_t>(std::move(row.texels), {count});
        out["factors"] = array_of<double>(std::move(row.factors), {count});
        out["backs"] = row.backs;
        out["escaped"] = row.escaped;
        out["hemicubes"] = row.hemicubes;
        return out;
    }

    py::dict update(const scene::Scene& given) {
        scene::check_scene(given);
        scene::Scene scene = given;  // which another thread may change
        const rd::Update done = cancelable(turn_, cancel_, [&] {
            const rd::Update update =
                solver_->update(rd::make_lit_model(scene, options_, form_factors_));
            scene_ = std::move(scene);
            watch();
            return update;
        });
        py::dict out;
        out["hemicubes"] = done.hemicubes;
        out["patches"] = done.patches;
        out["anew"] = done.anew;
        return out;
    }

    std::shared_ptr<MachineHolder> draw(const std::optional<scene::Camera>& camera, int width,
                                        int height, double brightness, bool ambient, bool strips,
                                        const Profile& profile) {
        check_range("brightness", brightness, 0, 1e9);
        const auto machine =
            std::make_shared<MachineHolder>(profile, width, height, false, 0, false);
        std::string cut_off;
        const CommandList list = in_turn(turn_, [&] {
            const SceneInView now(scene_, camera, width, height);
            cut_off = scene::near_warning(now.scene, now.view);
            const rd::Brightness scale{.scale = brightness * rd::scale_of_white(scene_),
                                       .background = scene_.background};
            const rd::PixmapModel& model = solver_->model();
            const auto colors = displayed_pixmaps(model, solver_->solution(), ambient);
            return strips ? rd::strip_list(model, colors, now.view, scale)
                          : rd::texture_list(model, colors, now.view, scale);
        });
        machine->execute(list);
        if (!cut_off.empty()) warn({cut_off});
        return machine;
    }

    std::uint64_t shots() const {
        return in_turn(turn_, [&] { return solver_->solution().shots; });
    }
    std::size_t patches() const {
        return in_turn(turn_, [&] { return solver_->model().patches.size(); });
    }
    std::size_t texels() const {
        return in_turn(turn_, [&] { return solver_->model().texel_count(); });
    }

private:
    void watch() {
        stall_.emplace(solver_->model().patches.size());
        why_stalled_.reset();
    }

    dvec3 value_of(const std::string& what, std::size_t texel) const {
        const rd::PixmapModel& model = solver_->model();
        const rd::Solution& solution = solver_->solution();
        if (what == "radiosity") return rd::radiosity_at(model, solution, texel);
        if (what == "irradiance") return solution.H[texel];
        if (what == "unshot") return solution.unshot[texel];
        if (what == "area") return dvec3(model.area[texel]);
        throw Error("what: '" + what + "'; expected radiosity, irradiance, unshot or area");
    }

    scene::Scene scene_;
    rd::ModelOptions options_;
    rd::FormFactorOptions form_factors_;
    std::atomic<bool> cancel_ = false;
    std::unique_ptr<rd::Solver> solver_;
    std::optional<rd::Stall> stall_;
    std::optional<std::string> why_stalled_;
    mutable std::mutex turn_;
};

}  // namespace

void add_radiosity(py::module_& m) {
    py::class_<HeldSolver>(m, "Radiosity",
                           "Progressive refinement [F1c]: the patch with the most unshot energy "
                           "shoots. An iterator of shots, which ends with a warning if the unshot "
                           "light neither escapes nor is absorbed.")
        .def(py::init<const scene::Scene&, int, double, int, int>(), py::arg("scene"),
             py::kw_only(), py::arg("hemicube") = 128, py::arg("texels_per_unit") = 0.0,
             py::arg("patch") = 4, py::arg("threads") = 0,
             "hemicube: pixels across. texels_per_unit 0: the scene's. patch: texels along a side.")
        .def("shoot", &HeldSolver::shoot,
             "One shot: its number, patch, flux, hemicubes drawn and the share of light still "
             "unshot; None if nothing is unshot. Ctrl-C leaves the solution as it was.")
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &HeldSolver::next)
        .def("books", &HeldSolver::books_now,
             "Energy by channel: emitted = absorbed + unshot + "
             "escaped.")
        .def("pixmaps", &HeldSolver::pixmaps, py::arg("what") = "radiosity",
             "Arrays (height, width, 3) by name, row 0 at t = 0: radiosity, irradiance, unshot or "
             "area.")
        .def("form_factors", &HeldSolver::form_factors, py::arg("patch"),
             "From a patch: texels, the factor to each, and the parts that meet backs or escape.")
        .def("update", &HeldSolver::update, py::arg("scene"),
             "Goes on with a scene in which emitters, reflectances or places were changed [F4].")
        .def("draw", &HeldSolver::draw, py::arg("camera") = py::none(), py::kw_only(),
             py::arg("width") = 640, py::arg("height") = 480, py::arg("brightness") = 1.0,
             py::arg("ambient") = true, py::arg("strips") = false, py::arg("profile") = vgx(),
             "A machine with the pixmaps drawn as textures or as triangle strips [F2.3].")
        .def_property_readonly("shots", &HeldSolver::shots, "Shots so far.")
        .def_property_readonly("patches", &HeldSolver::patches, "Patches.")
        .def_property_readonly("texels", &HeldSolver::texels, "Texels.");
}

}  // namespace gw::python
