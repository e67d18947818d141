#include "apps/radiosity/changes.h"

#include "apps/command/command.h"
#include "apps/render/picture_options.h"

#include <set>

namespace gw::apps {
namespace {

constexpr const char* expected =
    "expected NAME:emission=R,G,B, NAME:dim=FACTOR, NAME:Kd=R,G,B or NAME:move=X,Y,Z";

void check_range(const std::string& word, const dvec3& v, double high) {
    for (int c = 0; c < 3; ++c)
        if (!(v[c] >= 0 && v[c] <= high))
            throw UsageError("--change '" + word + "': expected numbers of 0 " +
                             (high == 1 ? "to 1" : "and more"));
}

void change_object(const Change& change, scene::Scene& scene, scene::Object& object) {
    scene::Material& material = scene.materials[object.material];
    if (change.what == "move") {
        object.world_from_object[3] += dvec4(change.value, 0);
    } else if (change.what == "Kd") {
        scene::Material own = material;  // others may share the material
        own.Kd = vec3(change.value);
        object.material = scene.materials.size();
        scene.materials.push_back(std::move(own));
    } else if (change.what == "dim") {
        object.pixmap.emission = object.pixmap.emission.value_or(material.Ke) * vec3(change.value);
    } else {
        object.pixmap.emission = vec3(change.value);
    }
}

}  // namespace

Change change_from(const std::string& word) {
    const std::size_t equals = word.rfind('='), colon = word.rfind(':', equals);
    if (equals == word.npos || colon == word.npos || colon == 0)
        throw UsageError("--change '" + word + "': " + expected);
    Change change{word.substr(0, colon), word.substr(colon + 1, equals - colon - 1)};
    const std::string value = word.substr(equals + 1);
    if (change.what == "dim")
        change.value = dvec3(number_from("--change dim", value, 0, 1e9));
    else if (change.what == "emission" || change.what == "Kd" || change.what == "move")
        change.value = point_from("--change " + change.what, value);
    else
        throw UsageError("--change '" + word + "': " + expected);
    if (change.what != "move") check_range(word, change.value, change.what == "Kd" ? 1 : 1e30);
    return change;
}

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
    throw UsageError("--change: no object '" + change.object + "'; expected one of " + known);
}

}  // namespace gw::apps
