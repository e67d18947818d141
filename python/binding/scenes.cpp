// Scenes from files or built in code, and shapes.
#include "scene/scene.h"

#include "image/textures.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/warn.h"
#include "python/binding/module.h"
#include "scene/draw/fit.h"
#include "scene/geometry/mirrored_faces.h"
#include "scene/maps/finish.h"
#include "scene/scene_builder.h"
#include "scene/toml/read_scene.h"

#include <fmt/format.h>

namespace gw::python {
namespace {

using scene::Scene;

Scene open_scene(const std::filesystem::path& file) {
    scene::SceneFile read = cancelable([&] {
        scene::SceneFile loaded = scene::read_scene(file);
        for (std::string& warning : image::load_textures(loaded.scene))
            loaded.warnings.push_back(std::move(warning));
        scene::Warnings warnings;
        scene::finish(loaded.scene, warnings);
        for (const std::string& line : warnings.lines()) loaded.warnings.push_back(line);
        return loaded;
    });
    if (read.origin != dvec3(0))
        read.warnings.push_back(fmt::format(
            "{}: lies far from 0; coordinates are counted from ({:.17g}, {:.17g}, {:.17g})",
            file.string(), read.origin.x, read.origin.y, read.origin.z));
    warn(read.warnings);
    return std::move(read.scene);
}

/// The next free identifier.
std::uint32_t next_polygon(const Scene& scene) {
    std::uint32_t next = 0;
    for (const scene::Object& object : scene.objects)
        if (object.mesh) next += object.mesh->polygon_count();
    return next;
}

void add_object(Scene& scene, const std::string& name, const Mesh& mesh,
                const scene::Material& material, const std::optional<dmat4>& world_from_object,
                bool casts_shadow) {
    if (!mesh.data().colors.empty())
        warn(
            {fmt::format("object '{}': colors of its mesh are not drawn; expected a texture "
                         "(map_Kd)",
                         name)});
    std::uint32_t next = next_polygon(scene);
    scene::Object object;
    object.name = name;
    if (world_from_object) object.world_from_object = *world_from_object;
    object.mesh = scene::make_numbered_mesh(
        scene::is_mirrored(object.world_from_object) ? scene::reversed(mesh) : mesh.data(), next);
    object.casts_shadow = casts_shadow;
    object.material = scene.materials.size();
    scene.materials.push_back(material);
    scene.objects.push_back(std::move(object));
}

using Maps = std::vector<scene::Map> scene::Material::*;

/// A component's maps as textures.
void add_maps(Fields<scene::Material>& type, const char* name, Maps member, const char* doc) {
    type.property(
        name,
        [member](const scene::Material& m) {
            std::vector<std::shared_ptr<Texture>> textures;
            for (const scene::Map& map : m.*member)
                textures.push_back(std::const_pointer_cast<Texture>(map.texture));
            return textures;
        },
        [member](scene::Material& m, const std::vector<std::shared_ptr<Texture>>& textures) {
            (m.*member).clear();
            for (const auto& texture : textures) {
                if (!texture) throw py::type_error("a map is None; expected a Texture");
                scene::Map map;
                map.texture = texture;
                (m.*member).push_back(map);
            }
        },
        doc);
}

void add_material(py::module_& m) {
    using M = scene::Material;
    Fields<M> type(m, "SceneMaterial", "MTL's material in MTL's words [K2, K3].");
    type.field("name", &M::name, "In the scene.")
        .field("Ka", &M::Ka, "Ambient.")
        .field("Kd", &M::Kd, "Diffuse.")
        .field("Ks", &M::Ks, "Specular.")
        .field("Ke", &M::Ke, "Emission.")
        .field("Ns", &M::Ns, "Exponent of the highlight.")
        .field("Ni", &M::Ni, "Index of refraction.")
        .field("d", &M::d, "Opacity.")
        .field("Tf", &M::Tf, "Transmission filter.")
        .field("illum", &M::illum, "3 and up: ray-traced reflection.");
    add_maps(type, "map_Ka", &M::map_Ka, "Textures of the ambient component.");
    add_maps(type, "map_Kd", &M::map_Kd, "Textures of the diffuse component.");
    add_maps(type, "map_Ks", &M::map_Ks, "Textures of the specular component.");
    add_maps(type, "map_Ke", &M::map_Ke, "Textures of the emission.");
    add_maps(type, "refl", &M::refl, "Sphere maps of the reflection [K3.1].");
    add_maps(type, "refraction", &M::refraction, "Sphere maps of the refraction [K1].");
}

void add_lights(py::module_& m) {
    add_enum<scene::LightKind>(m, "LightKind", "The kind of a light.",
                               {{"Directional", scene::LightKind::Directional},
                                {"Point", scene::LightKind::Point},
                                {"Spot", scene::LightKind::Spot}});
    add_enum<scene::Shadow>(m, "Shadow", "How a light's shadows are drawn.",
                            {{"NoShadow", scene::Shadow::None},
                             {"Volume", scene::Shadow::Volume},
                             {"Map", scene::Shadow::Map}});
    using A = scene::AreaLight;
    add_enum<A::Shape>(m, "AreaShape", "The shape of a light that is no point.",
                       {{"NoArea", A::Shape::None},
                        {"Disc", A::Shape::Disc},
                        {"Rectangle", A::Shape::Rectangle},
                        {"Line", A::Shape::Line}});
    Fields<A>(m, "AreaLight", "The range of a light's positions: soft shadows [K3.3].")
        .field("shape", &A::shape, "Its shape.")
        .field("u", &A::u, "A half axis in world units.")
        .field("v", &A::v, "The other one; not of a line.")
        .field("samples", &A::samples, "Superposed pictures, at least, 1 .. 4096.");
    using L = scene::Light;
    Fields<L> light(m, "SceneLight", "A light in world space.");
    light.field("name", &L::name, "In pass names.")
        .field("kind", &L::kind, "Directional, point or spot.")
        .field("position", &L::position, "Of point and spot lights.")
        .field("direction", &L::direction, "In which the light travels.")
        .field("Ia", &L::Ia, "Ambient.")
        .field("Id", &L::Id, "Diffuse.")
        .field("Is", &L::Is, "Specular; None: Id.")
        .field("cone_angle", &L::cone_angle, "Half angle in degrees.")
        .field("spot_exponent", &L::spot_exponent, "Of the cone.")
        .field("constant_attenuation", &L::constant_attenuation, "Of distance 0.")
        .field("linear_attenuation", &L::linear_attenuation, "Per unit.")
        .field("quadratic_attenuation", &L::quadratic_attenuation, "Per unit squared.")
        .field("area", &L::area, "The range of its positions.")
        .field("shadow", &L::shadow, "Its shadows.")
        .field("only", &L::only, "Names of the objects that it lights; empty: all.");
    light.type()
        .def_property_readonly(
            "candela",
            [](const L& l) -> std::optional<dvec3> {
                if (!l.luminous) return std::nullopt;
                return scene::intensity(l, l.kind == scene::LightKind::Point
                                               ? dvec3(0, -1, 0)
                                               : dvec3(l.direction) / length(dvec3(l.direction)));
            },
            "Its intensity for radiosity, of a spot along its direction; None: it has no unit.")
        .def_property_readonly(
            "lumen",
            [](const L& l) -> std::optional<dvec3> {
                return l.luminous ? std::optional(scene::luminous_flux(l)) : std::nullopt;
            },
            "Its flux for radiosity; None: it has no unit.");
}

void add_views(py::module_& m) {
    using C = scene::Camera;
    Fields<C>(m, "Camera", "A camera; lengths in world units.")
        .field("eye", &C::eye, "Its place.")
        .field("at", &C::at, "The point in the middle of the picture.")
        .field("up", &C::up, "Up in the picture.")
        .field("fov", &C::fov, "Vertical angle in degrees.")
        .field("near_plane", &C::near_plane, "Distance; 0: fitted.")
        .field("far_plane", &C::far_plane, "Distance; 0: fitted.")
        .field("ortho_height", &C::ortho_height, "Above 0: orthographic.")
        .field("aperture", &C::aperture, "Radius of the lens [K1].")
        .field("focus", &C::focus, "Distance that is sharp; 0: that of at.");
    using F = scene::Fog;
    Fields<F>(m, "Fog", "Fog of a scene [K3.5].")
        .field("mode", &F::mode, "Its law.")
        .field("color", &F::color, "R, G, B.")
        .field("density", &F::density, "Of Exp and Exp2.")
        .field("start", &F::start, "Of Linear.")
        .field("end", &F::end, "Of Linear.");
}

void add_objects(py::module_& m) {
    using G = scene::Glare;
    Fields<G>(m, "Glare", "Light around an object that emits [K3.3].")
        .field("radius", &G::radius, "Of the range, world units.")
        .field("strength", &G::strength, "Relative to the object's emission.")
        .field("rays", &G::rays, "0: a disc; else a star of so many rays.")
        .field("samples", &G::samples, "Superposed pictures, at least.");
    using P = scene::PixmapChoice;
    Fields<P>(m, "PixmapChoice", "The pixmap that holds an object's radiosity [F2.1].")
        .field("name", &P::name, "Objects of one name share a pixmap; empty: its own.")
        .field("width", &P::width, "Texels; 0: by texels_per_unit.")
        .field("height", &P::height, "Texels; 0: by texels_per_unit.")
        .field("texels_per_unit", &P::texels_per_unit, "0: the scene's.")
        .field("given_st", &P::given_st, "Texture coordinates are the mesh's; else generated.")
        .field("emission", &P::emission, "Instead of the material's Ke; None: that.");
    using O = scene::Object;
    Fields<O> object(m, "Object", "A mesh with one material, placed in the world.");
    object.field("name", &O::name, "In the scene.")
        .field("material", &O::material, "Index into the scene's materials.")
        .field("world_from_object", &O::world_from_object, "M[row, column].")
        .field("move", &O::move, "While the shutter is open [K1].")
        .field("glare", &O::glare, "None: no glare.")
        .field("pixmap", &O::pixmap, "Of its radiosity.")
        .field("casts_shadow", &O::casts_shadow, "Whether it casts shadows.");
    object.type().def_property_readonly(
        "mesh", [](const O& o) { return std::const_pointer_cast<Mesh>(o.mesh); }, "Its mesh.");
}

void add_scene(py::module_& m) {
    Fields<Scene> type(m, "Scene",
                       "Objects, materials, lights, camera and fog. Members are values: change a "
                       "copy and assign it.");
    type.field("name", &Scene::name, "For messages.")
        .field("objects", &Scene::objects, "Meshes in the world.")
        .field("materials", &Scene::materials, "Of the objects.")
        .field("lights", &Scene::lights, "In world space.")
        .field("camera", &Scene::camera, "None: fitted to the scene.")
        .field("fog", &Scene::fog, "None: no fog.")
        .field("background", &Scene::background, "R, G, B.")
        .field("texels_per_unit", &Scene::texels_per_unit, "Of pixmaps; 0: fitted [F2.1].")
        .field("reflection_in_shadow", &Scene::reflection_in_shadow,
               "Reflection maps are drawn in shadow too [K3.2].");
    type.type()
        .def_property_readonly(
            "white", [](const Scene& s) { return s.white; },
            "The illuminance in lux that makes a white surface white; 0: light has no unit.")
        .def_static("open", &open_scene, py::arg("file"),
                    "Reads a TOML scene or an OBJ file with its textures; warns of statements that "
                    "it does not honour.")
        .def("add", &add_object, py::arg("name"), py::arg("mesh"),
             py::arg("material") = scene::Material{}, py::kw_only(),
             py::arg("world_from_object") = py::none(), py::arg("casts_shadow") = true,
             "Adds an object; its polygons get the scene's next identifiers.")
        .def(
            "bounds",
            [](const Scene& s) {
                const scene::Bounds b = scene::bounds(s);
                return std::pair(b.low, b.high);
            },
            "The lower and the upper corner of its box in world space.");
}

}  // namespace

void add_scenes(py::module_& m) {
    add_material(m);
    add_lights(m);
    add_views(m);
    add_objects(m);
    add_scene(m);
}

}  // namespace gw::python
