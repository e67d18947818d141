#include "scene/maps/finish.h"

#include "scene/geometry/mirrored_faces.h"
#include "scene/maps/alpha.h"
#include "scene/maps/cut_mesh.h"
#include "scene/maps/map_lists.h"
#include "scene/maps/mean.h"
#include "scene/maps/metal.h"
#include "scene/maps/mirrored.h"
#include "scene/maps/patches.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace gw::scene {
namespace {

bool has_opacity(const Material& m) { return m.vertex_d || m.d_cutoff || !m.map_d.empty(); }

/// As many as a glTF file may place.
constexpr std::size_t most_objects = 1'000'000;

/// Makes objects of one d each.
class OpacityCutter {
public:
    OpacityCutter(Scene& scene, Warnings& warnings) : scene_(scene), warnings_(warnings) {
        for (Material& m : scene.materials)
            if (has_opacity(m)) make_maps_opaque(m);
    }

    void cut() {
        std::vector<Object> objects;
        for (Object& object : scene_.objects) {
            std::vector<Portion> portions = portions_of(object);
            if (portions.size() > 1 && objects.size() + portions.size() > most_objects) {
                warn_budget(object, "drawn with one opacity");
                portions = whole(object, 1);
            }
            for (const Portion& portion : portions) {
                Object& part = objects.emplace_back(object);
                part.mesh = portion.mesh;
                part.material = portion.material;
            }
        }
        if (!objects.empty()) {
            scene_.objects = std::move(objects);
            return;
        }
        for (Object& object : scene_.objects) object.material = level_material(object.material, 0);
    }

private:
    struct Portion {
        MeshRef mesh;
        std::size_t material = 0;
    };

    std::vector<Portion> portions_of(const Object& object) {
        if (!has_opacity(material(object.material))) return {{object.mesh, object.material}};
        const auto [found, is_new] = cut_.try_emplace({object.mesh, object.material});
        if (is_new) found->second = cut(object);
        return found->second;
    }

    std::vector<Portion> cut(const Object& object) {
        const Material& m = material(object.material);
        const Map* const map = opacity_map(object);
        const AlphaRange alpha = map ? alpha_in(map->texture) : AlphaRange{};
        OpacityLevels levels = m.d_cutoff ? mask_levels(double(*m.d_cutoff)) : blend_levels();
        const ColorUse use = m.vertex_d ? ColorUse::Opacity : ColorUse::Color;
        const bool has_colors = m.vertex_d && !object.mesh->data().colors.empty();
        const bool is_even = alpha.is_even() && !has_colors;
        if (is_even || object.mesh->kind() != MeshKind::Triangles)
            return whole(object, m.d_cutoff ? levels.values[levels.of(alpha.mean)] : alpha.mean);
        const auto try_levels = [&] {
            return cut_by_opacity(*object.mesh, alpha.low == 1 ? nullptr : map, use, levels,
                                  budget_);
        };
        auto meshes = try_levels();
        if (!meshes && !m.d_cutoff && alpha.is_mask()) {
            levels = mask_levels(0.5);
            meshes = try_levels();
            if (meshes) warn_budget(object, "cut at 0.5");
        }
        if (!meshes) {
            warn_budget(object, "drawn with one opacity");
            return whole(object, m.d_cutoff ? 1 : alpha.mean);
        }
        std::vector<Portion> portions;
        for (std::size_t level = 0; level < meshes->size(); ++level)
            if (!(*meshes)[level].positions.empty())
                portions.push_back({make_mesh((*meshes)[level]),
                                    level_material(object.material, levels.values[level])});
        return portions;
    }

    const Map* opacity_map(const Object& object) {
        const Material& m = material(object.material);
        if (m.map_d.empty() || !m.map_d[0].texture) return nullptr;
        if (!object.mesh->data().texcoords.empty()) return &m.map_d[0];
        warnings_.add(m.map_d[0].origin.file, m.map_d[0].origin.line, "opacity without st",
                      "object '" + printable(object.name) +
                          "' has no texture coordinates; expected some for its map of opacity, "
                          "which is not used");
        return nullptr;
    }

    std::vector<Portion> whole(const Object& object, double opacity) {
        if (opacity == 0) return {};
        return {{object.mesh, level_material(object.material, opacity)}};
    }

    /// The material with d times this.
    std::size_t level_material(std::size_t index, double opacity) {
        const auto [found, is_new] = levels_.try_emplace({index, opacity}, scene_.materials.size());
        if (!is_new) return found->second;
        Material m = scene_.materials[index];
        m.d = float(double(m.d) * opacity);
        m.map_d.clear();
        m.vertex_d = false;
        m.d_cutoff.reset();
        scene_.materials.push_back(std::move(m));
        return found->second;
    }

    const Material& material(std::size_t index) const { return scene_.materials[index]; }

    const AlphaRange& alpha_in(const TextureRef& texture) {
        const auto [found, is_new] = alphas_.try_emplace(texture);
        if (is_new) found->second = alpha_of(*texture);
        return found->second;
    }

    /// Their alpha became geometry.
    void make_maps_opaque(Material& m) {
        for_each_color_map(m, [&](Map& map) { map.texture = opaque_.of(map.texture); });
    }

    void warn_budget(const Object& object, const std::string& instead) {
        const Material& m = material(object.material);
        const std::string& file = m.map_d.empty() ? scene_.name : m.map_d[0].origin.file;
        warnings_.add(file, 0, "opacity",
                      "object '" + printable(object.name) +
                          "': its opacity would cut the scene into more than " +
                          std::to_string(CutBudget{}.triangles) + " triangles or " +
                          std::to_string(most_objects) + " objects; expected fewer, so it is " +
                          instead);
    }

    Scene& scene_;
    Warnings& warnings_;
    CutBudget budget_;
    std::map<std::pair<MeshRef, std::size_t>, std::vector<Portion>> cut_;
    std::map<std::pair<std::size_t, double>, std::size_t> levels_;
    std::map<TextureRef, AlphaRange> alphas_;
    OpaqueTextures opaque_;
};

void finish_objects(Scene& scene, Warnings& warnings) {
    reverse_mirrored(scene);
    if (std::ranges::any_of(scene.materials, has_opacity)) OpacityCutter(scene, warnings).cut();
}

}  // namespace

void finish(Scene& scene, Warnings& warnings) {
    std::vector<Film> none;
    finish(scene, none, warnings);
}

void finish(Scene& scene, std::vector<Film>& films, Warnings& warnings) {
    leave_out_missing(scene, warnings);
    resample_patched(scene, warnings);
    choose_opacity_channels(scene);
    apply_metal_maps(scene, warnings);
    replace_by_means(scene);
    unfold_mirrored(scene, warnings);
    const auto whole =
        films.empty()
            ? nullptr
            : std::make_shared<const std::pair<std::vector<Object>, std::vector<Material>>>(
                  scene.objects, scene.materials);
    for (Film& film : films)
        film.pose = [whole, pose = film.pose](Scene& posed, double time) {
            std::tie(posed.objects, posed.materials) = *whole;
            pose(posed, time);
            Warnings said_before;
            finish_objects(posed, said_before);
        };
    finish_objects(scene, warnings);
}

}  // namespace gw::scene
