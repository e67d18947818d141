// The papers' renderers: passes, item buffer and rays.
#include "inspect/report/prices.h"
#include "itembuffer/differences.h"
#include "multipass/passes/validate_passes.h"
#include "python/binding/arrays.h"
#include "python/binding/checked.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/warn.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"
#include "raytrace/casting/cast_picture.h"
#include "render/drawing.h"
#include "render/options.h"
#include "render/words/option_words.h"
#include "scene/draw/item_buffer.h"
#include "scene/validate/check.h"

#include <algorithm>
#include <cctype>
#include <variant>

namespace gw::python {
namespace {

namespace mp = multipass;

/// A row of render::renderers().
enum class RendererName : int {};

std::string name_of(RendererName renderer) {
    return render::renderers().at(std::size_t(renderer)).name;
}

/// An option that has an enumeration: its value, or its word.
template <class Enum>
using Named = std::variant<Enum, std::string>;

/// The words are those of the command; names of the enumerations have capitals.
std::string word_of(const Named<mp::Translucency>& given) {
    if (const auto* value = std::get_if<mp::Translucency>(&given))
        return scene::word_of(render::translucency_words, *value);
    std::string word = std::get<std::string>(given);
    for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    return word;
}
std::string word_of(const Named<scene::Shadow>& given) {
    const auto* value = std::get_if<scene::Shadow>(&given);
    return value ? scene::word_of(scene::shadow_words, *value) : std::get<std::string>(given);
}
std::string word_of(const Named<RendererName>& given) {
    const auto* value = std::get_if<RendererName>(&given);
    return value ? name_of(*value) : std::get<std::string>(given);
}

render::Request request_of(int width, int height) {
    render::Request request;
    render::set(request, "size", std::to_string(width) + "x" + std::to_string(height));
    return request;
}

[[noreturn]] void refuse_passes(const std::string& renderer) {
    throw Error("renderer " + renderer + " has no passes; expected hardware or multipass");
}

mp::PassList passes_for(const scene::Scene& scene, const Named<RendererName>& renderer, bool traced,
                        const Named<mp::Translucency>& translucency) {
    render::Request request{.traced = traced};
    render::set(request, "renderer", word_of(renderer));
    render::set(request, "translucency", word_of(translucency));
    if (!render::renderer_named(request.renderer).pass_owner) refuse_passes(request.renderer);
    return render::pass_list({.request = request, .profile = vgx(), .scene = scene});
}

/// The scene as the request wants it, after it was checked.
render::Drawing checked_drawing(const render::Request& request, const Profile& profile,
                                const scene::Scene& scene) {
    scene::check_scene(scene);
    return render::make_drawing(request, profile, {.scene = scene});
}

/// A scene that is drawn from one view after the other.
class SceneRenderer {
public:
    SceneRenderer(const scene::Scene& scene, const render::Request& request, const Profile& profile,
                  const std::optional<mp::PassList>& passes, bool record)
        : drawing_(checked_drawing(request, profile, scene)),
          camera_(*drawing_.scene.camera),
          held_(std::make_shared<MachineHolder>(profile, request.size.width, request.size.height,
                                                request.machine == "reference", request.threads,
                                                record)),
          machine_(*held_) {
        drawing_.view();  // refuses a camera that sees nothing
        drawing_.counts = &counts_;
        if (!passes) return;
        if (!drawing_.renderer().pass_owner) refuse_passes(request.renderer);
        if (const auto fault = mp::first_fault(*passes))
            throw Error("pass " + std::to_string(fault->pass) + ", " + fault->key + ": " +
                        fault->what);
        drawing_.pass_list = passes;
    }
    void draw(const std::optional<scene::Camera>& camera) {
        scene::check_scene({.camera = camera});
        std::vector<std::string> lines;
        try {
            cancelable(turn_, cancel_, [&] {
                counts_ = {};
                machine_.reset_passes();
                drawing_.scene.camera = camera.value_or(camera_);
                const scene::View view = drawing_.view();
                if (!draw_view_) {
                    lines = render::warnings(drawing_);
                    draw_view_ = render::view_drawer(drawing_, machine_);
                }
                draw_view_(view);
                const std::string empty = render::empty_warning(drawing_, machine_);
                if (!empty.empty()) lines.push_back(empty);
            });
        } catch (...) {
            // what it keeps may be half made
            in_turn(turn_, [&] { draw_view_ = nullptr; });
            throw;
        }
        warn(lines);
    }
    std::shared_ptr<MachineHolder> machine() const { return held_; }
    raytrace::RayCounts counts() {
        return in_turn(turn_, [&] { return counts_; });
    }
    std::map<std::string, std::string> parameter_sets() {
        return in_turn(turn_, [&] { return render::parameter_sets(drawing_); });
    }

private:
    render::Drawing drawing_;
    scene::Camera camera_;  ///< the scene's own
    std::shared_ptr<MachineHolder> held_;
    std::atomic<bool> cancel_ = false;
    RendererMachine machine_;
    std::function<void(const scene::View&)> draw_view_;
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
    return out;
}
py::dict work_dict(const raytrace::RayCounts& c) {
    py::dict out;
    out["shaded"] = c.shaded;
    out["boxes"] = c.tests.boxes;
    out["triangles"] = c.tests.triangles;
    return out;
}

void add_renderer(py::module_& m) {
    std::vector<std::pair<std::string, RendererName>> names;
    for (const render::Renderer& renderer : render::renderers())
        names.emplace_back(renderer.name, RendererName(int(names.size())));
    add_enum<RendererName>(m, "RendererName", "The renderers: equations 1, 2 to 5, 3, and rays.",
                           names);
    py::class_<SceneRenderer>(
        m, "Renderer", "Draws a scene from one view after the other on a machine of its own.")
        .def(py::init([](const scene::Scene& scene, int width, int height,
                         const Named<RendererName>& renderer, const Profile& profile,
                         const std::optional<mp::PassList>& passes, int samples, bool weighted,
                         const Named<mp::Translucency>& translucency,
                         const std::optional<Named<scene::Shadow>>& shadow, bool traced, int depth,
                         bool shadow_maps, bool reference, int threads, bool record) {
                 render::Request request = request_of(width, height);
                 render::set(request, "renderer", word_of(renderer));
                 render::set(request, "samples", std::to_string(samples));
                 render::set(request, "translucency", word_of(translucency));
                 if (shadow) render::set(request, "shadow", word_of(*shadow));
                 render::set(request, "depth", std::to_string(depth));
                 if (threads != 0) render::set(request, "threads", std::to_string(threads));
                 request.weighted = weighted;
                 request.traced = traced;
                 request.shadow_maps = shadow_maps;
                 if (reference) request.machine = "reference";
                 return std::make_unique<SceneRenderer>(scene, request, profile, passes, record);
             }),
             py::arg("scene"), py::arg("width") = 640, py::arg("height") = 480,
             py::arg("renderer") = "multipass", py::kw_only(), py::arg("profile") = vgx(),
             py::arg("passes") = py::none(), py::arg("samples") = 1, py::arg("weighted") = false,
             py::arg("translucency") = "sorted", py::arg("shadow") = py::none(),
             py::arg("traced") = true, py::arg("depth") = 2, py::arg("shadow_maps") = false,
             py::arg("reference") = false, py::arg("threads") = 0, py::arg("record") = false,
             "passes: a list of Pass instead of the renderer's. samples: superposed pictures; "
             "weighted: their mean. shadow: none, volume or map, for all lights that cast one. "
             "traced: reflections by rays (eq. 5), paths of `depth` rays; shadow_maps: their "
             "shadows by the lights' maps.")
        .def(
            "draw", [](SceneRenderer& r, const std::optional<scene::Camera>& c) { r.draw(c); },
            py::arg("camera") = py::none(), "Draws the scene; None: with its own camera.")
        .def_property_readonly("machine", &SceneRenderer::machine,
                               "The machine, with the picture in its colour plane.")
        .def(
            "rays", [](SceneRenderer& r) { return counts_dict(r.counts()); },
            "The rays of the last picture, by kind [K4f].")
        .def(
            "ray_work", [](SceneRenderer& r) { return work_dict(r.counts()); },
            "What these rays took: points that were shaded, boxes and triangles that were tested.")
        .def(
            "passes", &table_of,
            "Machine.passes() of the last picture with the paper's parameter set of each pass (\"set\") and its "
            "estimated seconds on a VGX (\"vgx_seconds\"), as gw passes prints them.");
}

py::dict components(const scene::Scene& given, int width, int height, const Profile& profile) {
    const render::Drawing drawing = checked_drawing(request_of(width, height), profile, given);
    warn(render::warnings(drawing));
    MachineHolder held(profile, width, height, false, 0, false);
    auto images = cancelable([&] {
        RendererMachine machine(held);
        return render::components(drawing, drawing.view(), machine);
    });
    py::dict out;
    for (mp::ComponentImage& image : images)
        out[py::str(image.name)] =
            array_of<std::uint16_t>(std::move(image.color), rows(height, width, 4));
    return out;
}

void warn_if_empty(const scene::Scene& scene, std::span<const Rgba> picture, int color_bits) {
    const std::string line = scene::empty_picture(scene, picture, color_bits);
    if (!line.empty()) warn({line});
}

py::array item_buffer(const scene::Scene& given, int width, int height) {
    const SceneInView now(given, {}, width, height);
    warn(scene::warnings_of(now.scene, now.view, scene::DrawnBy::Depth));
    const auto machine = make_fast(vgx(), width, height);
    auto ids =
        without_lock([&] { return scene::draw_item_buffer(*machine, now.scene, now.view, {}); });
    return array_of<std::uint32_t>(std::move(ids), rows(height, width));
}

py::dict cast_rays(const scene::Scene& given, const std::string& method, int width, int height,
                   int threads) {
    std::string word = method == "bounding_volumes" ? "volumes" : method;
    std::ranges::replace(word, '_', '-');
    const raytrace::CastMethod found =
        render::value_from("method", word, render::cast_method_words);
    check_threads(threads);
    const SceneInView now(given, {}, width, height);
    warn(scene::warnings_of(now.scene, now.view, scene::DrawnBy::Rays));
    auto picture = cancelable([&] {
        const auto shapes = raytrace::cast_shapes(now.scene);
        const auto caster = raytrace::make_caster(found, shapes);
        return raytrace::cast_picture(*caster, shapes, now.scene, now.view, threads);
    });
    warn_if_empty(now.scene, picture.color, 8);
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
    warn(scene::warnings_of(now.scene, now.view, scene::DrawnBy::Depth));
    const auto machine = make_fast(profile, width, height);
    auto d = cancelable([&] { return itembuffer::differences(*machine, now.scene, now.view, {}); });
    warn_if_empty(now.scene, d.by_passes, profile.color_bits);
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
    m.def("passes_for", &passes_for, py::arg("scene"), py::arg("renderer") = "multipass",
          py::kw_only(), py::arg("traced") = true, py::arg("translucency") = "sorted",
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
          "brute-force, volumes, hierarchy or grid.");
    m.def("renderer_differences", &renderer_differences, py::arg("scene"), py::arg("width") = 320,
          py::arg("height") = 240, py::arg("profile") = vgx(),
          "Passes with an item buffer beside ordinary ray tracing: both pictures, and the pixels "
          "that differ by reason.");
}

}  // namespace gw::python
