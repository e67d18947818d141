#include "scene/gltf/read_gltf.h"

#include "gw/base/elementary.h"
#include "gw/error.h"
#include "scene/draw/fit.h"
#include "scene/geometry/far.h"
#include "scene/geometry/transform.h"
#include "scene/gltf/gltf_camera.h"
#include "scene/gltf/gltf_film.h"
#include "scene/gltf/gltf_material.h"
#include "scene/gltf/gltf_mesh.h"
#include "scene/gltf/gltf_shape.h"
#include "scene/scene_builder.h"
#include "scene/text/suggest.h"
#include "scene/validate/rules.h"

#include <algorithm>
#include <array>
#include <list>
#include <map>

namespace gw::scene {
namespace {

/// Extensions that are read, or that change nothing here.
constexpr std::array known_extensions = std::to_array<std::string_view>({
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
});

bool is_known(std::string_view extension) {
    return std::ranges::find(known_extensions, extension) != known_extensions.end();
}

void check_extensions(const GltfDocument& document) {
    const auto required = document.root().find("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i)
        if (!is_known((*required)[i].text()))
            (*required)[i].fail_expected("only extensions that GW reads: a file without this one");
    const auto used = document.root().find("extensionsUsed");
    for (std::size_t i = 0; used && i < used->size(); ++i)
        if (const std::string& name = (*used)[i].text(); !is_known(name))
            document.warn(
                "extension " + name,
                "extension " + printable(name) + " is left out" +
                    (name == "KHR_materials_transmission" ? "; its surfaces are opaque" : ""));
}

std::string name_of(const JsonValue& value) {
    const auto name = value.find("name");
    return name && !name->text().empty() ? name->text() : value.place();
}

class GltfReader {
public:
    GltfReader(const std::filesystem::path& path, Warnings& warnings) : document_(path, warnings) {}

    GltfFile read() {
        check_extensions(document_);
        builder_.scene.name = document_.path().stem().string();
        nodes_ = placed_nodes(document_);
        places_ = places_of(document_, nodes_);
        for (place_ = 0; place_ < nodes_.size(); ++place_) add_node(nodes_[place_]);
        Scene& scene = builder_.scene;
        if (scene.objects.empty())
            throw Error(document_.file(), 0,
                        "has nothing to draw; expected a scene with a node that has a mesh");
        add_lights();
        warn_invisible(scene, document_.file(), document_.warnings());
        const dvec3 origin = place();
        std::vector<Film> films = read_gltf_films(document_, nodes_, holders_, origin);
        return {std::move(scene), origin, std::move(films)};
    }

private:
    /// One primitive of a mesh, read when a node first holds it.
    struct Part {
        MeshRef mesh;  ///< null: nothing to draw
        std::size_t material = 0;
        std::shared_ptr<const GltfMesh> shape;  ///< null: its vertices do not move
        bool single_sided = false;
    };

    void add_node(const GltfNode& node) {
        const JsonValue json = document_.root().at("nodes")[node.index];
        if (const auto mesh = json.find("mesh")) add_mesh(node, json, *mesh);
        if (const auto camera = json.find("camera")) add_camera(node, *camera);
        if (const auto extensions = json.find("extensions"))
            if (const auto light = extensions->find("KHR_lights_punctual"))
                add_light(node, json, light->at("light"));
    }

    void add_mesh(const GltfNode& node, const JsonValue& json, const JsonValue& index) {
        const JsonValue mesh = document_.element("meshes", index);
        const std::string name = json.find("name") ? name_of(json) : name_of(mesh);
        const auto parts = parts_.find(mesh.place());
        const std::vector<Part>& found =
            parts != parts_.end()
                ? parts->second
                : parts_.emplace(mesh.place(), read_parts(mesh, name)).first->second;
        const auto skin_index = json.find("skin");
        const std::shared_ptr<const GltfSkin> skin = skin_index ? skin_of(*skin_index) : nullptr;
        const std::vector<double> weights = weights_of(json, mesh);
        const std::vector<dmat4> instances = instances_of(document_, json, most_gltf_objects);
        if (instances.size() > 1) count_numbers(json, instances.size());
        for (const dmat4& instance : instances)
            for (const Part& part : found)
                if (part.mesh)
                    add_part(node.world_from_node * instance, instance, json, name, part, skin,
                             weights);
    }

    std::shared_ptr<const GltfSkin> skin_of(const JsonValue& index) {
        std::shared_ptr<const GltfSkin>& skin = skins_[document_.element("skins", index).place()];
        if (!skin)
            skin = std::make_shared<const GltfSkin>(read_gltf_skin(document_, index, places_));
        return skin;
    }

    static std::vector<double> weights_of(const JsonValue& node, const JsonValue& mesh) {
        const auto own = node.find("weights"), meshes = mesh.find("weights");
        std::vector<double> weights;
        if (const auto& list = own ? own : meshes)
            for (std::size_t i = 0; i < list->size(); ++i)
                weights.push_back((*list)[i].number({-1e6, 1e6}));
        return weights;
    }

    void add_part(const dmat4& world, const dmat4& node_from_object, const JsonValue& json,
                  const std::string& name, const Part& part, std::shared_ptr<const GltfSkin> skin,
                  const std::vector<double>& weights) {
        Scene& scene = builder_.scene;
        Object object{.name = name,
                      .mesh = part.mesh,
                      .material = part.material,
                      .world_from_object = world,
                      .single_sided = part.single_sided};
        if (part.shape && part.shape->influences == 0) skin = nullptr;
        GltfShaped shaped{scene.objects.size(), place_, part.shape, skin, weights};
        if (part.shape) {
            if (skin) {
                check_joints(json, part, *skin);
                shaped.base = dvec3(nodes_[skin->joints.front()].world_from_node[3]);
                object.world_from_object = translation(shaped.base);
            }
            object.mesh = shaped_mesh(json, shaped, part);
        }
        // What an animation scales from 0 is there at all times.
        if (fault_of(thickened(object.world_from_object)) && document_.count("animations") == 0)
            return document_.warn("singular", "object '" + printable(name) +
                                                  "' is left out: its scale leaves no area");
        object.world_from_object = drawable(object.world_from_object);
        if (scene.objects.size() == most_gltf_objects)
            json.fail("is one more than " + std::to_string(most_gltf_objects) +
                      " objects; expected fewer");
        if (part.shape) holders_.shaped.push_back(std::move(shaped));
        holders_.objects.push_back(place_);
        holders_.node_from_object.push_back(node_from_object);
        scene.objects.push_back(std::move(object));
    }

    void check_joints(const JsonValue& node, const Part& part, const GltfSkin& skin) const {
        if (part.shape->joints > skin.joints.size())
            node.at("skin").fail("has " + std::to_string(skin.joints.size()) +
                                 " joints; expected at least " +
                                 std::to_string(part.shape->joints) + ", which the mesh names");
    }

    /// Objects of one mesh share it while nothing moves its vertices.
    MeshRef shaped_mesh(const JsonValue& node, const GltfShaped& shaped, const Part& part) {
        const auto is_0 = [](double weight) { return weight == 0; };
        if (!shaped.skin && std::ranges::all_of(shaped.weights, is_0)) return part.mesh;
        const std::size_t joints = shaped.skin ? shaped.skin->joints.size() : 0;
        count_numbers(node, part.mesh->vertex_count() + joints);
        std::optional<MeshData> mesh = posed(shaped, nodes_, part.mesh->data().polygon_ids);
        if (!mesh) node.fail("has a vertex beyond 1e18, its skin included; expected less");
        return make_mesh(*std::move(mesh));
    }

    std::vector<Part> read_parts(const JsonValue& mesh, const std::string& name) {
        std::vector<Part> parts;
        const JsonValue primitives = mesh.at("primitives");
        for (std::size_t i = 0; i < primitives.size(); ++i)
            read_primitive_parts(primitives[i], name, parts);
        return parts;
    }

    void read_primitive_parts(const JsonValue& primitive, const std::string& name,
                              std::vector<Part>& parts) {
        count_numbers(primitive, numbers_of_primitive(document_, primitive));
        const auto material = primitive.find("material");
        const GltfMaterial& plain = material_of(material, std::nullopt);
        GltfMesh read = read_primitive(document_, primitive, plain.own, plain.other, name);
        if (read.mesh.positions.empty()) return;
        if (!plain.material.vertex_d) read.mesh.colors.clear();
        const bool has_map = has_maps(plain.material);
        if (has_map && read.mesh.texcoords.empty())
            document_.warn("no texcoords",
                           "object '" + printable(name) + "' has no texture coordinates of set " +
                               std::to_string(plain.own.index) + " for its texture");
        std::vector<GltfMesh> meshes;
        if (has_map || !has_color_texture(read))
            meshes = by_color(std::move(read));
        else
            meshes.push_back(std::move(read));
        if (meshes.size() > 1)
            for (const GltfMesh& mesh : meshes)
                count_numbers(primitive, mesh.mesh.positions.size());
        for (GltfMesh& mesh : meshes)
            parts.push_back(part_of(primitive, material, has_map, std::move(mesh), name));
    }

    Part part_of(const JsonValue& primitive, const std::optional<JsonValue>& material, bool has_map,
                 GltfMesh read, const std::string& name) {
        const GltfMaterial& painted = painted_material(primitive, material, has_map, read, name);
        const std::size_t index = builder_.index_of(painted.material);
        if (painted.luminance != dvec3(0)) luminances_[index] = painted.luminance;
        Part part{.mesh = builder_.numbered(drawn(read, read.mesh), {document_.file(), 0}),
                  .material = index,
                  .single_sided = !painted.double_sided};
        if (!read.targets.empty() || read.influences > 0)
            part.shape = std::make_shared<const GltfMesh>(std::move(read));
        return part;
    }

    static bool has_maps(const Material& m) {
        return !m.map_Kd.empty() || !m.map_Ke.empty() || !m.map_metal.empty();
    }

    const GltfMaterial& painted_material(const JsonValue& primitive,
                                         const std::optional<JsonValue>& material, bool has_map,
                                         GltfMesh& mesh, const std::string& name) {
        if (has_map || !has_color_texture(mesh)) {
            if (!mesh.colors.empty())
                document_.warn("COLOR_0",
                               "object '" + printable(name) + "': its vertex colours " +
                                   (triangle_count(mesh.mesh) > 0
                                        ? "beside a texture are drawn as means of triangles, in at "
                                          "most 64 colours"
                                        : "are drawn as their mean"));
            return patched_material(material_of(material, mesh.mean_color), mesh, name);
        }
        count_numbers(primitive, patch_colors(mesh));
        return add_material(material, {vec4(vec3(1), mesh.mean_color->w), color_texture(mesh)});
    }

    /// If its maps are of two sets of coordinates, a material of the mesh's own.
    const GltfMaterial& patched_material(const GltfMaterial& plain, GltfMesh& mesh,
                                         const std::string& name) {
        if (!plain.other) return plain;
        GltfMaterial patched = plain;
        const std::size_t texels = patch_maps(mesh, patched.material, patch_texels_ / 4);
        if (texels == 0) {
            document_.warn("texCoord",
                           "object '" + printable(name) + "': its textures with texCoord " +
                               std::to_string(plain.other->index) +
                               " are drawn with their mean: it has not both sets, no triangles, or "
                               "too many");
            return plain;
        }
        patch_texels_ -= texels;
        list_.push_back(std::move(patched));
        return list_.back();
    }

    /// Accessors may overlap, so a short file could ask for any amount of memory.
    void count_numbers(const JsonValue& owner, std::size_t numbers) {
        numbers_ += numbers;
        if (numbers_ > most_gltf_numbers)
            owner.fail("and those before it have more than " + std::to_string(most_gltf_numbers) +
                       " elements; expected fewer");
    }

    /// Materials that a vertex colour tints are materials of their own.
    const GltfMaterial& material_of(const std::optional<JsonValue>& index,
                                    const std::optional<vec4>& tint) {
        const vec4 color = tint.value_or(vec4(1));
        const std::string place = index ? document_.element("materials", *index).place() : "";
        const auto key = std::pair(place, std::array{color.x, color.y, color.z, color.w});
        const auto found = materials_.find(key);
        if (found != materials_.end()) return *found->second;
        return *materials_.emplace(key, &add_material(index, {color, nullptr})).first->second;
    }

    const GltfMaterial& add_material(const std::optional<JsonValue>& index, const Tint& tint) {
        if (index) {
            const JsonValue json = document_.element("materials", *index);
            list_.push_back(read_gltf_material(document_, json, name_of(json), tint));
        } else {
            list_.push_back(default_gltf_material(tint));
        }
        return list_.back();
    }

    void add_camera(const GltfNode& node, const JsonValue& index) {
        const JsonValue json = document_.element("cameras", index);
        const Camera camera = read_gltf_camera(json, node.world_from_node);
        if (builder_.scene.camera)
            return document_.warn("cameras", "has several cameras; the first one is used, and " +
                                                 printable(name_of(json)) + " is left out");
        builder_.scene.camera = camera;
        holders_.camera = place_;
    }

    void add_light(const GltfNode& node, const JsonValue& json, const JsonValue& index) {
        const JsonValue lights =
            document_.root().at("extensions").at("KHR_lights_punctual").at("lights");
        if (lights.size() == 0) index.fail_expected("an index into lights, which are none");
        const JsonValue light = lights[index.whole(0, lights.size() - 1)];
        holders_.lights.push_back(place_);
        lights_.push_back(read_gltf_light(document_, light, node.world_from_node, name_of(json)));
    }

    /// A file without lights is lit from where a bare OBJ file is, though something emits, and more
    /// from all sides: metals show little else.
    void add_lights() {
        Scene& scene = builder_.scene;
        const Bounds box = bounds(scene);
        ExposedLights shown = exposed(document_, lights_, scene);
        scene.lights = std::move(shown.lights);
        scene.white = shown.white;
        // Beside lights in candela, surfaces emit in the same unit.
        if (scene.white > 0)
            for (Object& object : scene.objects)
                if (const auto nit = luminances_.find(object.material); nit != luminances_.end())
                    object.pixmap.emission = vec3(pi * nit->second);
        if (scene.lights.empty()) {
            Light light = default_light(scene.camera ? *scene.camera : fit_camera(box, 4, 3));
            light.Ia = vec3(0.4f);
            light.Id = vec3(0.6f);
            scene.lights.push_back(light);
        }
        for (std::size_t i = 0; i < lights_.size(); ++i)
            scene.lights[i].position = vec3(lights_[i].position);
    }

    /// The origin that the scene counts from.
    dvec3 place() {
        Scene& scene = builder_.scene;
        const dvec3 origin = far_origin(scene);
        if (origin == dvec3(0)) return origin;
        count_from(scene, origin);
        for (std::size_t i = 0; i < lights_.size(); ++i)
            scene.lights[i].position = vec3(lights_[i].position - origin);
        return origin;
    }

    GltfDocument document_;
    SceneBuilder builder_;
    std::map<std::string, std::vector<Part>> parts_;
    std::map<std::string, std::shared_ptr<const GltfSkin>> skins_;
    std::list<GltfMaterial> list_;
    std::map<std::pair<std::string, std::array<float, 4>>, const GltfMaterial*> materials_;
    std::vector<GltfNode> nodes_;
    std::vector<std::size_t> places_;  ///< in nodes_, of the file's nodes
    std::vector<GltfLight> lights_;
    std::map<std::size_t, dvec3> luminances_;  ///< of materials that emit
    std::size_t numbers_ = 0;
    std::size_t patch_texels_ = std::size_t{1} << 25;  ///< left for maps of two sets
    std::size_t place_ = 0;                            ///< of the node that is being read
    GltfHolders holders_;
};

}  // namespace

GltfFile read_gltf(const std::filesystem::path& path, Warnings& warnings) {
    return GltfReader(path, warnings).read();
}

}  // namespace gw::scene
