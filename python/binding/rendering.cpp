// The papers' renderers: passes, item buffer and rays.
#include "hiddensurface/run/scan_line_renderer.h"
#include "inspect/report/prices.h"
#include "itembuffer/adaptive.h"
#include "itembuffer/differences.h"
#include "itembuffer/render.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "multipass/frame/driver.h"
#include "multipass/frame/superpose.h"
#include "multipass/passes/validate_passes.h"
#include "multipass/steps/schedule.h"
#include "python/binding/arrays.h"
#include "python/binding/checked.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"
#include "raytrace/casting/cast_picture.h"
#include "scene/draw/item_buffer.h"

namespace gw::python {
namespace {

namespace mp = multipass;

enum class RendererName { Hardware, Multipass, ScanLine, RayTrace, Adaptive };

mp::PassList passes_of(const scene::Scene& scene, RendererName renderer, bool traced,
                       mp::Translucency translucency) {
    if (renderer == RendererName::Multipass && traced)
        return itembuffer::passes_with_tracing(scene, translucency);
    if (renderer != RendererName::Multipass && renderer != RendererName::Hardware)
        throw Error("the renderer has no passes; expected hardware or multipass");
    return mp::passes_for(
        scene,
        renderer == RendererName::Hardware ? mp::Renderer::Hardware : mp::Renderer::Multipass,
        translucency);
}

/// A scene that is drawn from one view after the other.
class SceneRenderer {
public:
    struct Choice {
        RendererName renderer = RendererName::Multipass;
        mp::Options passes;
        itembuffer::Options rays;
        bool traced = true;
    };
    SceneRenderer(const scene::Scene& scene, int width, int height, const Profile& profile,
                  Choice choice, bool reference, int threads, bool record)
        : in_view_(scene, {}, width, height),
          given_(scene),
          choice_(std::move(choice)),
          held_(
              std::make_shared<MachineHolder>(profile, width, height, reference, threads, record)),
          machine_(*held_) {
        if (choice_.renderer == RendererName::Hardware)
            choice_.passes.renderer = mp::Renderer::Hardware;
        if (choice_.passes.passes) check(*choice_.passes.passes);
        check_range("samples", choice_.passes.samples, 1, 32768);
        check_range("depth", choice_.rays.depth, 1, 64);
        choice_.rays.threads = threads;
        choice_.rays.counts = &counts_;
    }
    void draw(const std::optional<scene::Camera>& camera) {
        const SceneInView now(given_, camera, held_->width(), held_->height());
        try {
            cancelable(turn_, cancel_, [&] {
                counts_ = {};
                draw(now);
            });
        } catch (...) {
            in_turn(turn_, [&] { driver_.reset(); });  // what it keeps may be half made
            throw;
        }
    }
    std::shared_ptr<MachineHolder> machine() const { return held_; }
    raytrace::RayCounts counts() {
        return in_turn(turn_, [&] { return counts_; });
    }
    /// Passes that the driver adds have none.
    std::map<std::string, std::string> parameter_sets() const {
        std::map<std::string, std::string> sets;
        const RendererName renderer = choice_.renderer;
        if (renderer != RendererName::Hardware && renderer != RendererName::Multipass) return sets;
        const scene::Scene& scene = in_view_.scene;
        const mp::PassModel model = mp::make_pass_model(scene);
        const mp::PassList passes =
            choice_.passes.passes
                ? *choice_.passes.passes
                : passes_of(scene, renderer, choice_.traced, choice_.passes.translucency);
        for (const mp::Step& step : mp::schedule(passes, model))
            sets[mp::name_of(step, model)] = mp::to_string(step.pass.material);
        return sets;
    }

private:
    static void check(const mp::PassList& passes) {
        if (const auto fault = mp::first_fault(passes))
            throw Error("pass " + std::to_string(fault->pass) + ", " + fault->key + ": " +
                        fault->what);
    }
    void draw(const SceneInView& now) {
        const int samples = choice_.passes.samples;
        switch (choice_.renderer) {
            case RendererName::Hardware:
            case RendererName::Multipass: draw_passes(now); return;
            case RendererName::ScanLine: draw_scan_lines(now); return;
            case RendererName::RayTrace:
                itembuffer::superpose_ray_traced(machine_, now.scene, now.view, samples,
                                                 choice_.rays, choice_.passes.weighted);
                return;
            case RendererName::Adaptive:
                itembuffer::render_adaptive(machine_, now.scene, now.view, samples, choice_.rays);
                return;
        }
    }
    /// The driver keeps what no view changes. Without a camera of its own the scene's lights may
    /// follow the view.
    void draw_passes(const SceneInView& now) {
        if (!driver_) {
            const bool traced = choice_.traced && choice_.renderer == RendererName::Multipass;
            driver_ =
                traced ? itembuffer::make_driver(machine_, now.scene, choice_.passes, choice_.rays)
                       : std::make_unique<mp::Driver>(machine_, now.scene, choice_.passes);
        }
        driver_->draw(now.view);
    }
    void draw_scan_lines(const SceneInView& now) {
        scene::Scene moved = now.scene;
        const Profile& profile = machine_.profile();
        mp::superpose(machine_, choice_.passes.samples, 0, [&](const mp::Sample& sample) {
            mp::move_to(moved, now.scene, sample);
            machine_.execute(
                hiddensurface::scan_line_picture(moved, mp::view_at(now.view, sample), profile,
                                                 mp::jitter_of(sample, profile.subpixel_bits)));
        });
    }

    SceneInView in_view_;  ///< checks the window and the scene when it is made
    scene::Scene given_;
    Choice choice_;
    std::shared_ptr<MachineHolder> held_;
    std::atomic<bool> cancel_ = false;
    RendererMachine machine_;
    std::unique_ptr<mp::Driver> driver_;
    raytrace::RayCounts counts_;
    std::mutex turn_;  ///< of draw
};

/// The machine's rows, each with the paper's parameter set and its estimated time on a VGX.
py::list table_of(SceneRenderer& renderer) {
    static const report::PriceList prices = report::vgx_prices();
    const auto passes =
        renderer.machine()->in_turn([](Machine& machine) { return machine.passes(); });
    const auto sets = renderer.parameter_sets();
    py::list rows = pass_rows(passes);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const auto set = sets.find(passes[i].name);
        rows[i]["set"] = set == sets.end() ? "" : set->second;
        rows[i]["vgx_seconds"] = report::estimated_seconds(passes[i].counters, prices);
    }
    return rows;
}

py::dict counts_dict(const raytrace::RayCounts& c) {
    py::dict out;
    out["primary"] = c.primary;
    out["reflected"] = c.reflected;
    out["transmitted"] = c.transmitted;
    out["shadow"] = c.shadow;
    out["shaded"] = c.shaded;
    return out;
}

void add_renderer(py::module_& m) {
    add_enum<RendererName>(m, "RendererName", "The renderers: equations 1, 2 to 5, 3, and rays.",
                           {{"hardware", RendererName::Hardware},
                            {"multipass", RendererName::Multipass},
                            {"scanline", RendererName::ScanLine},
                            {"raytrace", RendererName::RayTrace},
                            {"adaptive", RendererName::Adaptive}});
    py::class_<SceneRenderer>(
        m, "Renderer", "Draws a scene from one view after the other on a machine of its own.")
        .def(py::init([](const scene::Scene& scene, int width, int height, RendererName renderer,
                         const Profile& profile, const std::optional<mp::PassList>& passes,
                         int samples, bool weighted, mp::Translucency translucency, bool traced,
                         int depth, bool shadow_maps, bool reference, int threads, bool record) {
                 SceneRenderer::Choice choice;
                 choice.renderer = renderer;
                 choice.passes.passes = passes;
                 choice.passes.samples = samples;
                 choice.passes.weighted = weighted;
                 choice.passes.translucency = translucency;
                 choice.traced = traced;
                 choice.rays.depth = depth;
                 choice.rays.shadow_maps = shadow_maps;
                 return std::make_unique<SceneRenderer>(scene, width, height, profile, choice,
                                                        reference, threads, record);
             }),
             py::arg("scene"), py::arg("width") = 640, py::arg("height") = 480,
             py::arg("renderer") = RendererName::Multipass, py::kw_only(),
             py::arg("profile") = vgx(), py::arg("passes") = py::none(), py::arg("samples") = 1,
             py::arg("weighted") = false, py::arg("translucency") = mp::Translucency::Sorted,
             py::arg("traced") = true, py::arg("depth") = 2, py::arg("shadow_maps") = false,
             py::arg("reference") = false, py::arg("threads") = 0, py::arg("record") = false,
             "passes: a list of Pass instead of the renderer's. samples: superposed pictures. "
             "traced: reflections by rays (eq. 5), paths of `depth` rays.")
        .def(
            "draw", [](SceneRenderer& r, const std::optional<scene::Camera>& c) { r.draw(c); },
            py::arg("camera") = py::none(), "Draws the scene; None: with its own camera.")
        .def_property_readonly("machine", &SceneRenderer::machine,
                               "The machine, with the picture in its colour plane.")
        .def(
            "rays", [](SceneRenderer& r) { return counts_dict(r.counts()); },
            "The rays of the last picture, by kind [K4f].")
        .def("passes", &table_of,
             "Machine.passes() with the paper's parameter set of each pass (\"set\") and its "
             "estimated seconds on a VGX (\"vgx_seconds\"), as gw passes prints them.");
}

py::dict components(const scene::Scene& given, int width, int height, const Profile& profile) {
    const SceneInView now(given, {}, width, height);
    MachineHolder held(profile, width, height, false, 0, false);
    auto images = cancelable([&] {
        RendererMachine machine(held);
        mp::Options options;
        options.trace = itembuffer::tracing(now.scene, {});
        options.passes = itembuffer::passes_with_tracing(now.scene, options.translucency);
        return mp::render_components(machine, now.scene, now.view, options);
    });
    py::dict out;
    for (mp::ComponentImage& image : images)
        out[py::str(image.name)] =
            array_of<std::uint16_t>(std::move(image.color), rows(height, width, 4));
    return out;
}

py::array item_buffer(const scene::Scene& given, int width, int height) {
    const SceneInView now(given, {}, width, height);
    const auto machine = make_fast(vgx(), width, height);
    auto ids =
        without_lock([&] { return scene::draw_item_buffer(*machine, now.scene, now.view, {}); });
    return array_of<std::uint32_t>(std::move(ids), rows(height, width));
}

py::dict cast_rays(const scene::Scene& given, const std::string& method, int width, int height,
                   int threads) {
    using M = raytrace::CastMethod;
    const std::map<std::string, M> methods{{"brute_force", M::BruteForce},
                                           {"bounding_volumes", M::BoundingVolumes},
                                           {"hierarchy", M::Hierarchy},
                                           {"grid", M::Grid}};
    const auto found = methods.find(method);
    if (found == methods.end())
        throw Error("method '" + method +
                    "'; expected brute_force, bounding_volumes, hierarchy or grid");
    check_threads(threads);
    const SceneInView now(given, {}, width, height);
    auto picture = cancelable([&] {
        const auto shapes = raytrace::cast_shapes(now.scene);
        const auto caster = raytrace::make_caster(found->second, shapes);
        return raytrace::cast_picture(*caster, shapes, now.scene, now.view, threads);
    });
    py::dict out, counts;
    counts["rays"] = picture.counts.rays;
    counts["shapes"] = picture.counts.shapes;
    counts["boxes"] = picture.counts.boxes;
    counts["voxels"] = picture.counts.voxels;
    out["color"] = array_of<std::uint16_t>(std::move(picture.color), rows(height, width, 4));
    out["tests"] = array_of<std::uint32_t>(std::move(picture.tests), rows(height, width));
    out["counts"] = counts;
    return out;
}

py::dict renderer_differences(const scene::Scene& given, int width, int height,
                              const Profile& profile) {
    const SceneInView now(given, {}, width, height);
    const auto machine = make_fast(profile, width, height);
    auto d = cancelable([&] { return itembuffer::differences(*machine, now.scene, now.view, {}); });
    py::dict out;
    py::list reasons;
    for (const itembuffer::Reason reason : itembuffer::reasons) {
        const auto count = itembuffer::count_of(d, reason);
        py::dict row;
        row["reason"] = std::string(name_of(reason));
        row["pixels"] = count.pixels;
        row["largest"] = count.largest;
        row["mean"] = count.mean;
        reasons.append(row);
    }
    out["reasons"] = reasons;
    out["by_passes"] = array_of<std::uint16_t>(std::move(d.by_passes), rows(height, width, 4));
    out["by_rays"] = array_of<std::uint16_t>(std::move(d.by_rays), rows(height, width, 4));
    out["units"] = array_of<std::int32_t>(std::move(d.units), rows(height, width));
    return out;
}

}  // namespace

void add_rendering(py::module_& m) {
    add_renderer(m);
    m.def("passes_for", &passes_of, py::arg("scene"), py::arg("renderer") = RendererName::Multipass,
          py::kw_only(), py::arg("traced") = true,
          py::arg("translucency") = mp::Translucency::Sorted,
          "The passes that a renderer draws the scene with [K2, K3, K4].");
    m.def("components", &components, py::arg("scene"), py::arg("width") = 640,
          py::arg("height") = 480, py::arg("profile") = vgx(),
          "A picture of each component (Fig. 4); their saturated sum is the picture.");
    m.def("item_buffer", &item_buffer, py::arg("scene"), py::arg("width") = 640,
          py::arg("height") = 480,
          "The identifier of the polygon that each pixel shows [K4i]; 0: the background.");
    m.def("cast_rays", &cast_rays, py::arg("scene"), py::arg("method") = "hierarchy",
          py::arg("width") = 320, py::arg("height") = 240, py::kw_only(), py::arg("threads") = 0,
          "Ray casting as it is taught [L9]: color, tests of each pixel, counts. method: "
          "brute_force, bounding_volumes, hierarchy, grid.");
    m.def("renderer_differences", &renderer_differences, py::arg("scene"), py::arg("width") = 320,
          py::arg("height") = 240, py::arg("profile") = vgx(),
          "Passes with an item buffer beside ordinary ray tracing: both pictures, and the pixels "
          "that differ by reason.");
}

}  // namespace gw::python
