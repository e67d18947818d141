#include "radiosity/model/model_builder.h"

#include "gw/error.h"
#include "scene/geometry/weld.h"
#include "scene/maps/mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

constexpr int automatic_texels = 48;  ///< along the scene's longest side
constexpr std::size_t most_texels = std::size_t{1} << 26;

/// World positions as float32: the same numbers are drawn and computed with.
Surface surface_of(const scene::Object& o) {
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

double area_of(const Surface& surface) {
    double area = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const dvec3& p = surface.points[a];
        area += length(cross3(surface.points[b] - p, surface.points[c] - p)) / 2;
    }
    return area;
}

/// After its triangles are in: bounds, the region's corners, the sphere.
void finish(Facet& facet) {
    // Rounding must not lead out of the pixmap.
    for (Triangle2& t : facet.triangles)
        for (dvec2& uv : t) uv = {std::max(uv.x, 0.0), std::max(uv.y, 0.0)};
    facet.low = facet.high = facet.triangles.front()[0];
    for (const Triangle2& t : facet.triangles)
        for (const dvec2& uv : t) {
            facet.low = {std::min(facet.low.x, uv.x), std::min(facet.low.y, uv.y)};
            facet.high = {std::max(facet.high.x, uv.x), std::max(facet.high.y, uv.y)};
        }
    if (facet.triangles.size() == 1) {
        facet.corner_count = 3;
        for (std::size_t k = 0; k < 3; ++k) facet.corners[k] = facet.at(facet.triangles[0][k]);
    } else {
        facet.corner_count = 4;
        facet.corners = {facet.at(facet.low), facet.at({facet.high.x, facet.low.y}),
                         facet.at(facet.high), facet.at({facet.low.x, facet.high.y})};
    }
    facet.center = facet.at((facet.low + facet.high) / 2.0);
    for (int k = 0; k < facet.corner_count; ++k)
        facet.radius = std::max(facet.radius, length(facet.corners[std::size_t(k)] - facet.center));
}

}  // namespace

Facet facet_along(const dvec3& origin, const dvec3& du, const dvec3& dv, const dvec3& normal) {
    Facet facet;
    facet.normal = normal;
    facet.offset = dot3(normal, origin);
    facet.origin = origin;
    facet.du = du;
    facet.dv = dv;
    const dvec3 to_u = cross3(dv, normal), to_v = cross3(du, normal);
    facet.grad_u = to_u / dot3(du, to_u);
    facet.grad_v = to_v / dot3(dv, to_v);
    facet.texel_area = length(cross3(du, dv));
    return facet;
}

std::optional<Facet> facet_of(const std::array<dvec3, 3>& p, const std::array<dvec2, 3>& uv) {
    const dvec3 e = p[1] - p[0], f = p[2] - p[0], cross = cross3(e, f);
    const dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double det = a.x * b.y - a.y * b.x, twice_area = length(cross);
    const double size =
        std::max(std::max(std::abs(a.x), std::abs(a.y)), std::max(std::abs(b.x), std::abs(b.y)));
    if (!(std::abs(det) > 1e-9 * size * size) || !(twice_area > 0)) return std::nullopt;
    const dvec3 du = (e * b.y - f * a.y) / det, dv = (f * a.x - e * b.x) / det;
    return facet_along(p[0] - (uv[0].x * du + uv[0].y * dv), du, dv, cross / twice_area);
}

ModelBuilder::ModelBuilder(const scene::Scene& scene, const ModelOptions& options) : scene_(scene) {
    const scene::Bounds box = scene::bounds(scene);
    const dvec3 diagonal = box.high - box.low;
    model.extent = length(diagonal);
    const double longest = std::max(std::max(diagonal.x, diagonal.y), diagonal.z);
    texels_per_unit_ = options.texels_per_unit > 0 ? options.texels_per_unit
                       : scene.texels_per_unit > 0 ? scene.texels_per_unit
                                                   : automatic_texels / longest;
    model.drawn.name = scene.name;
    model.drawn.white = scene.white;
    model.drawn.materials.push_back({});
}

void ModelBuilder::begin(std::uint32_t object) {
    object_ = object;
    surface_ = surface_of(scene_.objects[object]);
    facet_of_triangle_.assign(surface_.triangles.size(), no_facet);
}

// The triangles with the identifier of their facet.
void ModelBuilder::end() {
    MeshData mesh;
    for (const dvec3& p : surface_.points) mesh.positions.push_back(vec3(p));
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
        if (facet_of_triangle_[t] == no_facet) continue;
        mesh.indices.insert(mesh.indices.end(), surface_.triangles[t].begin(),
                            surface_.triangles[t].end());
        mesh.polygon_ids.push_back(facet_of_triangle_[t]);
    }
    model.drawn.objects.push_back({.name = object().name, .mesh = make_mesh(std::move(mesh))});
    model.sources.push_back({object_, facet_of_triangle_});
}

void ModelBuilder::fail(const std::string& what) const {
    const scene::Object& o = object();
    const std::string text = fmt::format("object '{}': {}", o.name, what);
    if (o.pixmap.origin.file.empty()) throw Error(text);
    throw Error(o.pixmap.origin.file, o.pixmap.origin.line, text);
}

bool ModelBuilder::has_area() const {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
        if (surface_.solid(t)) return true;
    return false;
}

void ModelBuilder::leave_out() {
    const scene::PixmapChoice& choice = object().pixmap;
    const dvec3 E(choice.emission.value_or(scene_.materials[object().material].Ke));
    if (choice.lumen > 0 || E != dvec3(0))
        fail("has no area and is to emit; expected a figure with an area");
    model.without_area.push_back(object().name);
}

std::uint32_t ModelBuilder::add_figure(std::uint32_t pixmap) {
    const scene::Object& o = object();
    const scene::Material& m = scene_.materials[o.material];
    const dvec3 rho = scene::reflectance_of(m),
                E = o.pixmap.lumen > 0
                        ? dvec3(o.pixmap.color) * (o.pixmap.lumen / area_of(surface_))
                        : dvec3(o.pixmap.emission.value_or(m.Ke));
    for (int c = 0; c < 3; ++c) {
        if (rho[c] > 1)
            fail(fmt::format(
                "material '{}' reflects {} of the light that falls on it; expected Kd of at most 1",
                m.name, rho[c]));
        if (!(E[c] >= 0)) fail(fmt::format("emission is {}; expected 0 or more", E[c]));
    }
    model.figures.push_back({o.name, object_, pixmap, rho, E});
    return static_cast<std::uint32_t>(model.figures.size() - 1);
}

std::uint32_t ModelBuilder::add_pixmap(std::string name, int width, int height) {
    if (std::max(width, height) > largest_pixmap)
        fail(fmt::format(
            "its pixmap has {}x{} texels; expected sides of at most {} (fewer texels a unit)",
            width, height, largest_pixmap));
    const std::size_t first =
        model.pixmaps.empty() ? 0 : model.pixmaps.back().first + model.pixmaps.back().count();
    model.pixmaps.push_back({std::move(name), width, height, first, {}, false});
    if (first + model.pixmaps.back().count() > most_texels)
        fail(fmt::format("more than {} texels in all pixmaps; expected fewer texels a unit",
                         most_texels));
    return static_cast<std::uint32_t>(model.pixmaps.size() - 1);
}

std::uint32_t ModelBuilder::add_shared_pixmap() {
    const scene::PixmapChoice& choice = object().pixmap;
    if (choice.name.empty()) return add_pixmap(object().name, choice.width, choice.height);
    const auto [found, is_new] = shared_.try_emplace(choice.name, 0);
    if (is_new) return found->second = add_pixmap(choice.name, choice.width, choice.height);
    const Pixmap& pixmap = model.pixmaps[found->second];
    if (pixmap.width != choice.width || pixmap.height != choice.height)
        fail(fmt::format("pixmap '{}' is {}x{} here and {}x{} before; expected one size",
                         choice.name, choice.width, choice.height, pixmap.width, pixmap.height));
    return found->second;
}

void ModelBuilder::add_facet(Facet facet, const std::vector<std::uint32_t>& triangles,
                             std::uint32_t figure) {
    constexpr std::size_t most = (1 << 24) - 1;  // 0 is a pixel that sees none
    if (model.facets.size() == most)
        throw Error(fmt::format("more than {} facets; an ID buffer tells no more apart", most));
    const auto number = static_cast<std::uint32_t>(model.facets.size());
    facet.figure = figure;
    facet.pixmap = model.figures[figure].pixmap;
    finish(facet);
    model.pixmaps[facet.pixmap].facets.push_back(number);
    model.facets.push_back(std::move(facet));
    for (std::uint32_t t : triangles) facet_of_triangle_[t] = number;
}

void ModelBuilder::add_triangle(std::uint32_t triangle, const Triangle2& uv, std::uint32_t figure) {
    std::optional<Facet> facet = facet_of(corners(triangle), uv);
    if (!facet)
        fail(
            "a triangle has an area, but its ST have none; expected ST that spread it in its pixmap");
    facet->triangles.push_back(uv);
    add_facet(std::move(*facet), {triangle}, figure);
}

int ModelBuilder::texels(double length) const {
    const double per_unit = object().pixmap.texels_per_unit;
    const double n = length * (per_unit > 0 ? per_unit : texels_per_unit_);
    if (n > largest_pixmap)
        fail(fmt::format(
            "its pixmap would be {:.0f} texels long; expected at most {} (fewer texels a unit)", n,
            largest_pixmap));
    return std::max(1, static_cast<int>(std::ceil(n - 1e-6)));
}

std::array<dvec3, 3> ModelBuilder::corners(std::uint32_t t) const {
    const auto& [a, b, c] = surface_.triangles[t];
    return {surface_.points[a], surface_.points[b], surface_.points[c]};
}

}  // namespace gw::radiosity
