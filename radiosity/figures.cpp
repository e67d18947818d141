#include "radiosity/figures.h"

#include "gw/error.h"
#include "radiosity/charts.h"
#include "radiosity/coverage.h"
#include "radiosity/facet.h"
#include "radiosity/patches.h"
#include "scene/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gw::radiosity {

namespace {

constexpr int automatic_texels = 48;  ///< along the scene's longest side
constexpr int largest_pixmap = 4096;
constexpr std::size_t most_texels = std::size_t{1} << 26;

class Builder {
public:
    Builder(const scene::Scene& scene, const ModelOptions& options) : scene_(scene) {
        const scene::Bounds box = scene::bounds(scene);
        const dvec3 diagonal = box.high - box.low;
        model.extent = std::sqrt(dot3(diagonal, diagonal));
        const double longest = std::max(std::max(diagonal.x, diagonal.y), diagonal.z);
        texels_per_unit_ = options.texels_per_unit > 0 ? options.texels_per_unit
                           : scene.texels_per_unit > 0 ? scene.texels_per_unit
                                                       : automatic_texels / longest;
        model.drawn.name = scene.name;
        model.drawn.materials.push_back({});
    }

    Model model;

    void add(std::uint32_t object) {
        object_ = object;
        const scene::Object& o = scene_.objects[object];
        if (o.mesh->kind() != MeshKind::Triangles) return;  // lines and points have no area
        surface_ = surface_of(o);
        facet_of_triangle_.assign(surface_.triangles.size(), no_facet);
        o.pixmap.given_st ? add_given(o) : add_charts(o);
        add_drawn(o);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        const scene::Object& o = scene_.objects[object_];
        const std::string text = fmt::format("object '{}': {}", o.name, what);
        if (o.pixmap.origin.file.empty()) throw Error(text);
        throw Error(o.pixmap.origin.file, o.pixmap.origin.line, text);
    }

    /// World positions as float32: what the machine draws is what is computed with.
    static Surface surface_of(const scene::Object& o) {
        std::vector<vec3> positions;
        for (const vec3& p : o.mesh->data().positions)
            positions.push_back(
                vec3(transform3(dmat3(o.world_from_object), dvec3(p)) + dvec3(o.world_from_object[3])));
        const std::vector<std::uint32_t> first = scene::weld(positions);
        Surface surface;
        for (const vec3& p : positions) surface.points.push_back(dvec3(p));
        for (const Triangle& t : o.mesh->triangles())
            surface.triangles.push_back({first[t.vertex[0]], first[t.vertex[1]], first[t.vertex[2]]});
        return surface;
    }

    std::uint32_t add_figure(const scene::Object& o, std::uint32_t pixmap) {
        const scene::Material& m = scene_.materials[o.material];
        const dvec3 rho(m.Kd), E(o.pixmap.emission.value_or(m.Ke));
        for (int c = 0; c < 3; ++c) {
            if (rho[c] > 1)
                fail(fmt::format(
                    "material '{}' reflects {} of the light that falls on it; expected Kd of at most 1",
                    m.name, m.Kd[c]));
            if (!(E[c] >= 0)) fail(fmt::format("emission is {}; expected 0 or more", E[c]));
        }
        model.figures.push_back({o.name, object_, pixmap, rho, E});
        return static_cast<std::uint32_t>(model.figures.size() - 1);
    }

    std::uint32_t add_pixmap(std::string name, int width, int height) {
        if (std::max(width, height) > largest_pixmap)
            fail(
                fmt::format("its pixmap has {}x{} texels; expected sides of at most {} (fewer texels a unit)",
                            width, height, largest_pixmap));
        const std::size_t first =
            model.pixmaps.empty() ? 0 : model.pixmaps.back().first + model.pixmaps.back().count();
        model.pixmaps.push_back({std::move(name), width, height, first, {}, false});
        if (first + model.pixmaps.back().count() > most_texels)
            fail(
                fmt::format("more than {} texels in all pixmaps; expected fewer texels a unit", most_texels));
        return static_cast<std::uint32_t>(model.pixmaps.size() - 1);
    }

    std::uint32_t add_facet(Facet facet, std::uint32_t figure) {
        const auto number = static_cast<std::uint32_t>(model.facets.size());
        facet.figure = figure;
        facet.pixmap = model.figures[figure].pixmap;
        finish(facet);
        model.pixmaps[facet.pixmap].facets.push_back(number);
        model.facets.push_back(std::move(facet));
        return number;
    }

    // Automatic ST: every chart is projected along its normal.
    void add_charts(const scene::Object& o) {
        const std::vector<Chart> found = charts(surface_);
        if (found.empty()) fail("has no area" + emitter_note(o) + "; expected a figure with an area");
        for (std::size_t i = 0; i < found.size(); ++i)
            add_chart(o, found[i], found.size() > 1 ? fmt::format("{} {}", o.name, i + 1) : o.name);
    }

    std::string emitter_note(const scene::Object& o) const {
        const dvec3 E(o.pixmap.emission.value_or(scene_.materials[o.material].Ke));
        return E == dvec3(0) ? "" : " and is to emit";
    }

    void add_chart(const scene::Object& o, const Chart& chart, const std::string& name) {
        const dvec3 along = chart.along, up = cross3(chart.normal, along);
        const dvec3& zero = surface_.points[surface_.triangles[chart.triangles.front()][0]];
        dvec2 low(0), high(0);
        for (std::uint32_t t : chart.triangles)
            for (std::uint32_t corner : surface_.triangles[t]) {
                const dvec3 p = surface_.points[corner] - zero;
                const dvec2 st(dot3(p, along), dot3(p, up));
                low = {std::min(low.x, st.x), std::min(low.y, st.y)};
                high = {std::max(high.x, st.x), std::max(high.y, st.y)};
            }
        const dvec2 size = high - low;
        const scene::PixmapChoice& choice = o.pixmap;
        const int width = choice.width ? choice.width : texels(size.x),
                  height = choice.height ? choice.height : texels(size.y);
        const std::uint32_t figure = add_figure(o, add_pixmap(name, width, height));
        const dvec3 corner = zero + (low.x * along + low.y * up);
        const Facet map = facet_along(corner, along * (size.x / width), up * (size.y / height), chart.normal);
        chart.planar ? add_planar(chart, map, figure) : add_curved(chart, map, figure);
    }

    int texels(double length) const {
        const double per_unit = scene_.objects[object_].pixmap.texels_per_unit;
        const double n = length * (per_unit > 0 ? per_unit : texels_per_unit_);
        if (n > largest_pixmap)
            fail(fmt::format(
                "its pixmap would be {:.0f} texels long; expected at most {} (fewer texels a unit)", n,
                largest_pixmap));
        return std::max(1, static_cast<int>(std::ceil(n - 1e-6)));
    }

    std::array<dvec3, 3> corners(std::uint32_t t) const {
        const auto& [a, b, c] = surface_.triangles[t];
        return {surface_.points[a], surface_.points[b], surface_.points[c]};
    }

    static Triangle2 mapped(const Facet& map, const std::array<dvec3, 3>& p) {
        return {map.texel_of(p[0]), map.texel_of(p[1]), map.texel_of(p[2])};
    }

    void add_planar(const Chart& chart, Facet facet, std::uint32_t figure) {
        for (std::uint32_t t : chart.triangles) {
            facet.triangles.push_back(mapped(facet, corners(t)));
            facet_of_triangle_[t] = static_cast<std::uint32_t>(model.facets.size());
        }
        add_facet(std::move(facet), figure);
    }

    void add_curved(const Chart& chart, const Facet& map, std::uint32_t figure) {
        for (std::uint32_t t : chart.triangles) {
            const std::array<dvec3, 3> p = corners(t);
            add_triangle(t, p, mapped(map, p), figure);
        }
    }

    void add_triangle(std::uint32_t t, const std::array<dvec3, 3>& p, const Triangle2& uv,
                      std::uint32_t figure) {
        std::optional<Facet> facet = facet_of(p, uv);
        if (!facet)
            fail("a triangle has an area, but its ST have none; expected ST that spread it in its pixmap");
        facet->triangles.push_back(uv);
        facet_of_triangle_[t] = add_facet(std::move(*facet), figure);
    }

    // Given ST: one figure in a pixmap that may be shared.
    void add_given(const scene::Object& o) {
        const MeshData& data = o.mesh->data();
        if (data.texcoords.empty())
            fail("its vertices have no texture coordinates; expected some beside st = \"texcoords\"");
        for (const vec2& st : data.texcoords)
            if (!(st.x >= -1e-6f && st.x <= 1 + 1e-6f && st.y >= -1e-6f && st.y <= 1 + 1e-6f))
                fail(fmt::format("ST ({}, {}) lie outside its pixmap; expected 0 to 1", st.x, st.y));
        const std::uint32_t figure = add_figure(o, shared_pixmap(o));
        std::size_t added = 0;
        for (std::uint32_t t = 0; t < surface_.triangles.size();) {
            std::uint32_t end = t + 1;
            const std::uint32_t polygon = o.mesh->triangles()[t].polygon;
            while (end < surface_.triangles.size() && o.mesh->triangles()[end].polygon == polygon) ++end;
            added += add_polygon(o, t, end, figure);
            t = end;
        }
        if (added == 0) fail("has no area" + emitter_note(o) + "; expected a figure with an area");
    }

    std::uint32_t shared_pixmap(const scene::Object& o) {
        const scene::PixmapChoice& choice = o.pixmap;
        if (choice.name.empty()) return add_pixmap(o.name, choice.width, choice.height);
        const auto [found, is_new] = shared_.try_emplace(choice.name, 0);
        if (is_new) return found->second = add_pixmap(choice.name, choice.width, choice.height);
        const Pixmap& pixmap = model.pixmaps[found->second];
        if (pixmap.width != choice.width || pixmap.height != choice.height)
            fail(fmt::format("pixmap '{}' is {}x{} here and {}x{} before; expected one size", choice.name,
                             choice.width, choice.height, pixmap.width, pixmap.height));
        return found->second;
    }

    Triangle2 given_uv(const scene::Object& o, std::uint32_t t) const {
        const Pixmap& pixmap = model.pixmaps[model.figures.back().pixmap];
        Triangle2 uv;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec2 st = o.mesh->data().texcoords[o.mesh->triangles()[t].vertex[k]];
            uv[k] = {std::clamp(double(st.x), 0.0, 1.0) * pixmap.width,
                     std::clamp(double(st.y), 0.0, 1.0) * pixmap.height};
        }
        return uv;
    }

    // One facet where the whole polygon has one affine map, else one for each triangle.
    std::size_t add_polygon(const scene::Object& o, std::uint32_t first, std::uint32_t end,
                            std::uint32_t figure) {
        std::vector<std::uint32_t> solid;
        for (std::uint32_t t = first; t < end; ++t)
            if (surface_.solid(t)) solid.push_back(t);
        if (solid.empty()) return 0;
        if (std::optional<Facet> facet = one_map(o, solid)) {
            for (std::uint32_t t : solid) {
                facet->triangles.push_back(given_uv(o, t));
                facet_of_triangle_[t] = static_cast<std::uint32_t>(model.facets.size());
            }
            add_facet(std::move(*facet), figure);
        } else {
            for (std::uint32_t t : solid) add_triangle(t, corners(t), given_uv(o, t), figure);
        }
        return solid.size();
    }

    std::optional<Facet> one_map(const scene::Object& o, const std::vector<std::uint32_t>& solid) const {
        const auto by_area = [&](std::uint32_t a, std::uint32_t b) {
            const dvec3 m = surface_.cross(a), n = surface_.cross(b);
            return dot3(m, m) < dot3(n, n);
        };
        const std::uint32_t largest = *std::max_element(solid.begin(), solid.end(), by_area);
        std::optional<Facet> facet = facet_of(corners(largest), given_uv(o, largest));
        for (std::uint32_t t : solid) {
            const std::array<dvec3, 3> p = corners(t);
            const Triangle2 uv = given_uv(o, t);
            for (std::size_t k = 0; facet && k < 3; ++k) {
                const dvec2 off = facet->texel_of(p[k]) - uv[k];
                const bool same = std::abs(off.x) < 1e-3 && std::abs(off.y) < 1e-3 &&
                                  std::abs(dot3(facet->normal, p[k]) - facet->offset) < 1e-6 * model.extent;
                if (!same) facet.reset();
            }
        }
        return facet;
    }

    // What id_pass draws: the triangles with the identifier of their facet.
    void add_drawn(const scene::Object& o) {
        MeshData mesh;
        for (const dvec3& p : surface_.points) mesh.positions.push_back(vec3(p));
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
            if (facet_of_triangle_[t] == no_facet) continue;
            mesh.indices.insert(mesh.indices.end(), surface_.triangles[t].begin(),
                                surface_.triangles[t].end());
            mesh.polygon_ids.push_back(facet_of_triangle_[t]);
        }
        model.drawn.objects.push_back({.name = o.name, .mesh = make_mesh(std::move(mesh))});
        model.sources.push_back({object_, facet_of_triangle_});
    }

    const scene::Scene& scene_;
    double texels_per_unit_ = 0;
    std::uint32_t object_ = 0;
    Surface surface_;
    std::vector<std::uint32_t> facet_of_triangle_;
    std::map<std::string, std::uint32_t> shared_;
};

void check_emission(const Model& model) {
    for (const Figure& figure : model.figures)
        if (figure.E != dvec3(0)) return;
    throw Error(
        "scene '" + model.drawn.name +
        "': nothing emits light; expected a material with Ke, or pixmap = {emission = ...} of an object");
}

}  // namespace

Model make_model(const scene::Scene& scene, const ModelOptions& options) {
    Builder builder(scene, options);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) builder.add(i);
    check_emission(builder.model);
    cover_texels(builder.model);
    builder.model.patches = patches_of(builder.model, options.patch);
    return std::move(builder.model);
}

}  // namespace gw::radiosity
