#include "scene/validate/warnings_of.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "scene/draw/corners.h"
#include "scene/draw/fit.h"
#include "scene/draw/nearest.h"
#include "scene/maps/alpha.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/validate/coincident.h"
#include "scene/validate/shadow_maps.h"

#include <algorithm>
#include <set>

namespace gw::scene {
namespace {

std::string name_in_quotes(const Scene& scene, std::size_t object) {
    return "'" + printable(scene.objects[object].name) + "'";
}

std::string lines_and_points(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].mesh->kind() != MeshKind::Triangles)
            return "lines and points are left out, as of object " + name_in_quotes(scene, i) +
                   "; expected renderer multipass or hardware for them";
    return {};
}

std::string coincident(const Scene& scene) {
    const auto pair = coincident_objects(scene);
    if (!pair) return {};
    return "objects " + name_in_quotes(scene, pair->first) + " and " +
           name_in_quotes(scene, pair->second) +
           " share a part of a plane: which of them is seen there depends on rounding; expected "
           "them a little apart";
}

/// A map whose texels may differ.
const Map* picture_of(const Material& m) {
    for (const auto* maps : {&m.map_Kd, &m.map_Ka, &m.map_Ks, &m.map_Ke, &m.map_d})
        for (const Map& map : *maps)
            if (map.texture && !map.file.empty() && map.texture->levels.front().rgba.size() > 4)
                return &map;
    return nullptr;
}

std::string without_texcoords(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Map* const map = picture_of(scene.materials[object.material]);
        if (map && object.mesh->data().texcoords.empty())
            return "object " + name_in_quotes(scene, i) + " has no texture coordinates for " +
                   printable(map->file.filename().string()) +
                   ": one texel of it is everywhere; expected some (vt)";
    }
    return {};
}

std::string color_in_bytes(const std::string& whose, const vec3& color) {
    const float most = std::max({color.x, color.y, color.z});
    return most > in_bytes
               ? whose + " " + number_text(double(most)) + "; expected 0 to 1, not 0 to 255"
               : std::string();
}

std::string colors_in_bytes(const Scene& scene) {
    std::string line = color_in_bytes("the background is", scene.background);
    if (line.empty() && scene.fog) line = color_in_bytes("the fog is", scene.fog->color);
    for (std::size_t i = 0; i < scene.objects.size() && line.empty(); ++i) {
        const Material& m = scene.materials[scene.objects[i].material];
        const std::pair<const char*, vec3> colors[] = {
            {" has Ka", m.Ka}, {" has Kd", m.Kd}, {" has Ks", m.Ks}};
        for (const auto& [has, color] : colors)
            if (line.empty())
                line = color_in_bytes("object " + name_in_quotes(scene, i) + has, color);
    }
    return line;
}

/// Whether the normals of a triangle's corners look to the side from which it is clockwise.
bool is_against_normals(const MeshData& mesh, const Triangle& t) {
    const auto at = [&](std::size_t k) { return dvec3(mesh.positions[t.vertex[k]]); };
    const dvec3 area = cross3(at(1) - at(0), at(2) - at(0));
    dvec3 normal(0);
    for (const std::uint32_t v : t.vertex) normal += dvec3(mesh.normals[v]);
    return dot3(area, normal) < 0;
}

std::string normals_against_faces(const Scene& scene) {
    std::set<const Mesh*> seen;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Mesh& mesh = *scene.objects[i].mesh;
        if (mesh.data().normals.empty() || !mesh.data().w.empty()) continue;
        if (!seen.insert(&mesh).second) continue;
        const auto count = std::ranges::count_if(mesh.triangles(), [&](const Triangle& t) {
            return is_against_normals(mesh.data(), t);
        });
        if (2 * std::size_t(count) > mesh.triangles().size())
            return "object " + name_in_quotes(scene, i) +
                   " has faces that are clockwise seen from where their normals point, so it is lit "
                   "from behind; expected them counter-clockwise";
    }
    return {};
}

/// OBJ's and glTF's readers let the faces' own stand in.
std::string normals_of_length_0(const Scene& scene) {
    const auto is_0 = [](const vec3& normal) { return normal == vec3(0); };
    std::set<const Mesh*> seen;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Mesh& mesh = *scene.objects[i].mesh;
        if (seen.insert(&mesh).second && std::ranges::any_of(mesh.data().normals, is_0))
            return "object " + name_in_quotes(scene, i) +
                   " has normals of length 0, which no light reaches; expected others, or none";
    }
    return {};
}

std::string unused_alpha(const Scene& scene) {
    std::set<const Texture*> opaque;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material& m = scene.materials[scene.objects[i].material];
        if (m.is_encoded || scene.objects[i].mesh->data().texcoords.empty()) continue;
        for (const Map& map : m.map_Kd) {
            if (!map.texture || !opaque.insert(map.texture.get()).second) continue;
            if (alpha_of(*map.texture).low < 1)
                return "object " + name_in_quotes(scene, i) + " has a map of Kd, " +
                       printable(map.file.filename().string()) +
                       ", whose alpha is not used; expected map_d with it for opacity";
        }
    }
    return {};
}

/// Whether the ray from p along d, of any length, meets the triangle.
bool meets(const dvec3& p, const dvec3& d, const WorldCorners& corners) {
    const dvec3 u = corners[1] - corners[0], v = corners[2] - corners[0], n = cross3(d, v);
    const double det = dot3(u, n);
    if (det == 0) return false;
    const dvec3 from = p - corners[0], m = cross3(from, u);
    const double a = dot3(from, n) / det, b = dot3(d, m) / det;
    return a >= 0 && b >= 0 && a + b <= 1 && dot3(v, m) / det > 0;
}

/// Passes light vertices: a cone between them lights nothing.
std::string spot_between_vertices(const Scene& scene) {
    for (const Light& light : scene.lights) {
        if (light.kind != LightKind::Spot || light.Id == vec3(0)) continue;
        const dvec3 axis = normalized(dvec3(light.direction)), place(light.position);
        const double least = cos(light.cone_angle * (pi / 180));
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const Object& object = scene.objects[i];
            if (!light.only.empty() && !light.only.contains(object.name)) continue;
            for (const Triangle& t : object.mesh->triangles()) {
                const WorldCorners corners = world_corners(object, t);
                const bool is_lit = std::ranges::any_of(corners, [&](const dvec3& p) {
                    return dot3(axis, normalized(p - place)) >= least;
                });
                if (!is_lit && meets(place, axis, corners))
                    return "object " + name_in_quotes(scene, i) + " has no vertex in the cone of " +
                           (light.name.empty() ? "a spot"
                                               : "spot '" + printable(light.name) + "'") +
                           " that shines on it, and passes light vertices: expected it divided "
                           "(divide = N), or --renderer raytrace";
            }
        }
    }
    return {};
}

std::string opaque_in_radiosity(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (const float d = scene.materials[scene.objects[i].material].d; d < 1)
            return "object " + name_in_quotes(scene, i) + " has opacity " + number_text(double(d)) +
                   "; radiosity takes it as opaque: expected d 1";
    return {};
}

std::string without_maps(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Material& m = scene.materials[scene.objects[i].material];
        if (!m.map_Kd.empty())
            return "object " + name_in_quotes(scene, i) + " has a map of Kd, " +
                   printable(m.map_Kd[0].file.filename().string()) +
                   "; radiosity reflects the mean of its texels everywhere: expected no map";
    }
    return {};
}

/// A light of an object's name stands for this object where there are no areas.
std::string without_unit(const Scene& scene) {
    const auto stands_for_object = [&](const Light& light) {
        return !light.name.empty() &&
               std::ranges::find(scene.objects, light.name, &Object::name) != scene.objects.end();
    };
    const auto is_left_out = [&](const Light& light) {
        return !light.luminous && light.Id != vec3(0) && light.name != default_light_name &&
               !stands_for_object(light);
    };
    const auto light = std::ranges::find_if(scene.lights, is_left_out);
    if (light == scene.lights.end()) return {};
    return (light->name.empty() ? "a light" : "light '" + printable(light->name) + "'") +
           " is not in candela or lumen, so radiosity leaves it out; expected one of these, or an "
           "object that emits";
}

}  // namespace

std::vector<std::string> warnings_of(const Scene& scene, const View& view, DrawnBy by) {
    if (scene.objects.empty()) return {"the scene has nothing to draw; expected an object"};
    std::vector<std::string> lines;
    const auto add = [&](std::string line) {
        if (!line.empty()) lines.push_back(std::move(line));
    };
    if (by != DrawnBy::Rays) add(near_warning(scene, view));
    if (by != DrawnBy::Passes) add(lines_and_points(scene));
    if (by == DrawnBy::Passes) add(cut_by_shadow_map(scene));
    if (by == DrawnBy::Passes) add(cut_by_scene_map(scene));
    if (by == DrawnBy::Passes) add(spot_between_vertices(scene));
    add(without_texcoords(scene));
    add(unused_alpha(scene));
    add(colors_in_bytes(scene));
    add(normals_against_faces(scene));
    add(normals_of_length_0(scene));
    add(coincident(scene));
    return lines;
}

std::vector<std::string> left_out_by_radiosity(const Scene& scene) {
    std::vector<std::string> lines{opaque_in_radiosity(scene), without_maps(scene),
                                   without_unit(scene)};
    std::erase(lines, "");
    return lines;
}

std::string empty_picture(const Scene& scene, std::span<const Rgba> picture, int color_bits) {
    if (scene.objects.empty() || picture.empty()) return {};
    for (const Rgba& pixel : picture)
        for (int k = 0; k < 3; ++k)
            if (pixel[std::size_t(k)] != quantize(double(scene.background[k]), color_bits))
                return {};
    return "the picture is empty: no pixel differs from the background; expected the scene before "
           "the eye, lit, and not of opacity 0";
}

}  // namespace gw::scene
