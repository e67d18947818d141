#include "radiosity/model/changes.h"

#include "gw/error.h"

#include <set>

namespace gw::radiosity {
namespace {

void change_object(const Change& change, scene::Scene& scene, scene::Object& object) {
    scene::Material& material = scene.materials[object.material];
    if (change.what == "move") {
        object.world_from_object[3] += dvec4(change.value, 0);
    } else if (change.what == "Kd") {
        scene::Material own = material;  // others may share the material
        own.Kd = vec3(change.value);
        own.is_encoded = false;
        own.map_Kd.clear();
        object.material = scene.materials.size();
        scene.materials.push_back(std::move(own));
    } else if (change.what == "dim") {
        object.pixmap.lumen *= change.value.x;
        if (object.pixmap.lumen == 0)
            object.pixmap.emission =
                object.pixmap.emission.value_or(material.Ke) * vec3(change.value);
    } else {
        object.pixmap.lumen = 0;
        object.pixmap.emission = vec3(change.value);
    }
}

}  // namespace

void apply(const Change& change, scene::Scene& scene) {
    bool found = false;
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        names.insert(scene.objects[i].name);
        if (scene.objects[i].name != change.object) continue;
        found = true;
        change_object(change, scene, scene.objects[i]);
    }
    if (found) return;
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    throw Error("no object '" + change.object + "'; expected one of " + known);
}

}  // namespace gw::radiosity
