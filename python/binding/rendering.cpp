// The papers' renderers: passes, item buffer and rays.
#include "hiddensurface/run/scan_line_renderer.h"
#include "itembuffer/adaptive.h"
#include "itembuffer/differences.h"
#include "itembuffer/render.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "multipass/frame/driver.h"
#include "multipass/frame/superpose.h"
#include "multipass/passes/validate_passes.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"
#include "python/binding/running.h"
#include "python/binding/views.h"
#include "raytrace/casting/cast_picture.h"
#include "scene/draw/item_buffer.h"

namespace pybind11::detail {

/// A pass's parameter: a number, three, or "object", "object Ks", "object Tf".
template <>
struct type_caster<gw::multipass::Parameter> {
    using Parameter = gw::multipass::Parameter;
    PYBIND11_TYPE_CASTER(Parameter, const_name("Union[str, Tuple[float, float, float]]"));

    bool load(handle source, bool convert) {
        if (isinstance<str>(source)) {
            const auto word = source.cast<std::string>();
            if (word == "object")
                value = gw::multipass::object;
            else if (word == "object Ks")
                value = gw::multipass::object_Ks;
            else if (word == "object Tf")
                value = gw::multipass::object_Tf;
            else
                return false;
            return true;
        }
        if (PyFloat_Check(source.ptr()) || PyLong_Check(source.ptr())) {
            value = Parameter(source.cast<double>());
            return true;
        }
        make_caster<gw::vec3> three;
        if (!three.load(source, convert)) return false;
        const auto& c = cast_op<gw::vec3&>(three);
        value = Parameter(c.x, c.y, c.z);
        return true;
    }
    static handle cast(const Parameter& p, return_value_policy, handle) {
        using Kind = Parameter::Kind;
        if (p.kind == Kind::Object) return str("object").release();
        if (p.kind == Kind::ObjectKs) return str("object Ks").release();
        if (p.kind == Kind::ObjectTf) return str("object Tf").release();
        return pybind11::make_tuple(p.value[0], p.value[1], p.value[2]).release();
    }
};

}  // namespace pybind11::detail

namespace gw::python {
namespace {

namespace mp = multipass;

void add_passes(py::module_& m) {
    add_enum<mp::PassMap>(m, "PassMap", "Which of the object's maps modulates a pass.",
                          {{"NoMap", mp::PassMap::None},
                           {"Ambient", mp::PassMap::Ambient},
                           {"Diffuse", mp::PassMap::Diffuse},
                           {"Specular", mp::PassMap::Specular},
                           {"Emission", mp::PassMap::Emission},
                           {"Reflection", mp::PassMap::Reflection},
                           {"Refraction", mp::PassMap::Refraction},
                           {"Object", mp::PassMap::Object}});
    add_enum<mp::PassLights>(m, "PassLights", "How often a pass runs, and by which light.",
                             {{"NoLight", mp::PassLights::None},
                              {"Each", mp::PassLights::Each},
                              {"First", mp::PassLights::First},
                              {"All", mp::PassLights::All}});
    add_enum<mp::PassObjects>(m, "PassObjects", "The objects that take part.",
                              {{"All", mp::PassObjects::All},
                               {"Opaque", mp::PassObjects::Opaque},
                               {"Translucent", mp::PassObjects::Translucent},
                               {"Glaring", mp::PassObjects::Glaring},
                               {"Casting", mp::PassObjects::Casting},
                               {"Named", mp::PassObjects::Named}});
    add_enum<mp::PassFog>(m, "PassFog", "The fog that a pass goes through [K3.5].",
                          {{"NoFog", mp::PassFog::None},
                           {"Black", mp::PassFog::Black},
                           {"Scene", mp::PassFog::Scene}});
    add_enum<mp::PassAction>(m, "PassAction", "The work of a pass.",
                             {{"Draw", mp::PassAction::Draw},
                              {"Shadow", mp::PassAction::Shadow},
                              {"Add", mp::PassAction::Add},
                              {"Trace", mp::PassAction::Trace}});
    Fields<mp::PassMaterial>(m, "PassMaterial",
                             "The parameter set [K3p]: a number, three, or the object's own value "
                             "(\"object\", \"object Ks\", \"object Tf\").")
        .field("Ka", &mp::PassMaterial::Ka, "Ambient.")
        .field("Kd", &mp::PassMaterial::Kd, "Diffuse.")
        .field("Ks", &mp::PassMaterial::Ks, "Specular.")
        .field("Ke", &mp::PassMaterial::Ke, "Emission.")
        .field("Map", &mp::PassMaterial::Map, "The map.");
    using P = mp::Pass;
    Fields<P> pass(m, "Pass", "A pass as the paper writes one [K3p].");
    pass.property(
            "name", [](const P& p) { return p.name.str(); },
            [](P& p, const std::string& name) {
                if (name.size() > mp::Name::most)
                    throw Error("name: " + std::to_string(name.size()) +
                                " bytes; expected at most " + std::to_string(mp::Name::most));
                p.name = mp::Name(std::string_view(name));
            },
            "At most 31 bytes.")
        .field("action", &P::action, "Its work.")
        .property(
            "clear",
            [](const P& p) {
                std::vector<Plane> planes;
                for (const Plane plane : every_plane)
                    if (p.clear & mask_of(plane)) planes.push_back(plane);
                return planes;
            },
            [](P& p, const std::vector<Plane>& planes) {
                p.clear = 0;
                for (const Plane plane : planes) p.clear = PlaneMask(p.clear | mask_of(plane));
            },
            "Planes that are cleared before.")
        .field("material", &P::material, "(Ka, Kd, Ks, Ke, Map).")
        .field("depth", &P::depth, "The depth test.")
        .field("stencil", &P::stencil, "The stencil test.")
        .field("blend", &P::blend, "Blending.")
        .field("color", &P::color, "False: colours are kept.")
        .field("fog", &P::fog, "Its fog.")
        .field("lights", &P::lights, "Its lights.")
        .field("objects", &P::objects, "Its objects.")
        .field("names", &P::names, "Of PassObjects.Named.");
    pass.type().def("__str__", [](const P& p) { return mp::to_string(p); });
    add_enum<mp::Translucency>(m, "Translucency", "How translucent objects are ordered [K3.4].",
                               {{"Sorted", mp::Translucency::Sorted},
                                {"Unsorted", mp::Translucency::Unsorted},
                                {"Layers", mp::Translucency::Layers}});
}

enum class RendererName { Hardware, Multipass, ScanLine, RayTrace, Adaptive };

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
        choice_.rays.threads = threads;
        choice_.rays.counts = &counts_;
    }
    void draw(const std::optional<scene::Camera>& camera) {
        const SceneInView now(given_, camera, held_->width(), held_->height());
        counts_ = {};
        without_lock([&] { draw(now); });
        check_signals();
    }
    std::shared_ptr<MachineHolder> machine() const { return held_; }
    const raytrace::RayCounts& counts() const { return counts_; }

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
    RendererMachine machine_;
    std::unique_ptr<mp::Driver> driver_;
    raytrace::RayCounts counts_;
};

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
            "rays", [](const SceneRenderer& r) { return counts_dict(r.counts()); },
            "The rays of the last picture, by kind [K4f].");
}

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

py::dict components(const scene::Scene& given, int width, int height, const Profile& profile) {
    const SceneInView now(given, {}, width, height);
    MachineHolder held(profile, width, height, false, 0, false);
    RendererMachine machine(held);
    auto images = without_lock([&] {
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
    const SceneInView now(given, {}, width, height);
    auto picture = without_lock([&] {
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
    auto d =
        without_lock([&] { return itembuffer::differences(*machine, now.scene, now.view, {}); });
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
    add_passes(m);
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
