// The papers' passes as Python reads and changes them [K3p].
#include "multipass/passes/passes.h"
#include "gw/error.h"
#include "multipass/passes/pass_toml.h"
#include "python/binding/fields.h"
#include "python/binding/module.h"
#include "scene/toml/read_scene.h"

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

void add_pass_types(py::module_& m) {
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

}  // namespace

void add_passes(py::module_& m) {
    add_pass_types(m);
    m.def(
        "read_passes",
        [](const std::filesystem::path& file) -> std::optional<mp::PassList> {
            const scene::SceneFile read = scene::read_scene(file);
            if (read.passes.empty()) return {};
            return mp::read_passes(read.passes);
        },
        py::arg("file"), "The passes that a scene file brings itself; None: it has none.");
}

}  // namespace gw::python
