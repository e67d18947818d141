#include "radiosity/model/figures.h"

#include "gw/error.h"
#include "radiosity/model/geometry.h"
#include "radiosity/model/model_builder.h"
#include "radiosity/model/patches.h"
#include "radiosity/model/texel_parts.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace gw::radiosity {
namespace {

constexpr double least_share = 1.0 / 2;

/// Breadth first from the covered texels, in the order of the texels.
void find_nearest(PixmapModel& model, Pixmap& pixmap, const std::vector<char>& covered) {
    std::deque<std::size_t> queue;
    for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t) {
        model.nearest[t] = covered[t] ? static_cast<std::uint32_t>(t) : no_texel;
        if (covered[t]) queue.push_back(t);
    }
    pixmap.whole = queue.size() == pixmap.count();
    const auto width = std::size_t(pixmap.width);
    for (; !queue.empty(); queue.pop_front()) {
        const std::size_t t = queue.front(), local = t - pixmap.first;
        const auto spread = [&](bool inside, std::size_t neighbour) {
            if (!inside || model.nearest[neighbour] != no_texel) return;
            model.nearest[neighbour] = model.nearest[t];
            queue.push_back(neighbour);
        };
        spread(local % width > 0, t - 1);
        spread(local % width + 1 < width, t + 1);
        spread(local >= width, t - width);
        spread(local + width < pixmap.count(), t + width);
    }
}

/// The texels that become elements: those covered enough, or the fullest one of a pixmap that has
/// none.
std::vector<char> covered_enough(const PixmapModel& model, const std::vector<double>& share) {
    std::vector<char> covered(share.size());
    for (const Pixmap& pixmap : model.pixmaps) {
        const auto first = share.begin() + static_cast<std::ptrdiff_t>(pixmap.first);
        const auto fullest =
            std::max_element(first, first + static_cast<std::ptrdiff_t>(pixmap.count()));
        const double least = std::min(least_share, *fullest);
        for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t)
            covered[t] = share[t] > 0 && share[t] >= least;
    }
    return covered;
}

/// A texel with too little area and its nearest neighbours are one element.
void join_elements(PixmapModel& model) {
    const std::size_t count = model.texel_count();
    model.element_area = model.area;
    model.next_of_element.assign(count, no_texel);
    for (std::size_t t = count; t-- > 0;) {
        const std::size_t first = model.nearest[t];
        if (first == t || model.area[t] == 0) continue;
        model.element_area[first] += model.area[t];
        model.next_of_element[t] = model.next_of_element[first];
        model.next_of_element[first] = static_cast<std::uint32_t>(t);
    }
}

void refuse_overlap(const PixmapModel& model, const std::vector<double>& share) {
    for (const Pixmap& pixmap : model.pixmaps)
        for (std::size_t i = 0; i < pixmap.count(); ++i) {
            if (share[pixmap.first + i] <= most_share) continue;
            const auto width = std::size_t(pixmap.width);
            throw Error(fmt::format(
                "pixmap '{}': figures cover texel ({}, {}) {:.3f} times; expected ST that cover it once",
                pixmap.name, i % width, i / width, share[pixmap.first + i]));
        }
}

/// Fills in the model's texels; its figures, facets and pixmaps are there already. A texel of which
/// less than half is covered forms one element with its nearest neighbour. Few pixels of an ID
/// buffer fall on it, and a quotient by almost nothing is noise. Throws Error if figures cover a
/// texel twice.
void cover_texels(PixmapModel& model) {
    const std::size_t count =
        model.pixmaps.empty() ? 0 : model.pixmaps.back().first + model.pixmaps.back().count();
    model.area.assign(count, 0);
    model.rho.assign(count, dvec3(0));
    model.E.assign(count, dvec3(0));
    model.nearest.assign(count, 0);
    model.share.assign(count, 0);
    model.middle.assign(count, dvec3(0));
    model.facet_of.assign(count, no_facet);
    std::vector<double> most(count, 0);  // of a texel, covered by one triangle
    std::vector<double>& share = model.share;
    for (std::uint32_t number = 0; number < model.facets.size(); ++number) {
        const Facet& facet = model.facets[number];
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        const Figure& figure = model.figures[facet.figure];
        for (const Triangle2& triangle : facet.triangles)
            for_each_part(triangle, pixmap, [&](int x, int y, const Polygon2& part) {
                const std::size_t t = pixmap.texel(x, y);
                const double covered = area(part), a = covered * facet.texel_area;
                share[t] += covered;
                model.area[t] += a;
                model.rho[t] += a * figure.rho;
                model.E[t] += a * figure.E;
                if (covered > 0) model.middle[t] += a * facet.at(centroid(part));
                if (covered <= most[t]) return;
                most[t] = covered;
                model.facet_of[t] = number;
            });
    }
    refuse_overlap(model, share);
    const std::vector<char> covered = covered_enough(model, share);
    for (Pixmap& pixmap : model.pixmaps) find_nearest(model, pixmap, covered);
    join_elements(model);
    for (std::size_t t = 0; t < count; ++t) {
        if (model.area[t] > 0) {
            model.rho[t] /= model.area[t];
            model.E[t] /= model.area[t];
            model.middle[t] /= model.area[t];
        } else {
            model.rho[t] = model.E[t] = dvec3(0);
        }
    }
}

/// The objects as one mesh; polygon identifiers are facets, which ascend from object to object.
scene::Scene joined(const scene::Scene& drawn) {
    MeshData whole;
    for (const scene::Object& object : drawn.objects) {
        const auto first = static_cast<std::uint32_t>(whole.positions.size());
        const MeshData& mesh = object.mesh->data();
        whole.positions.insert(whole.positions.end(), mesh.positions.begin(), mesh.positions.end());
        whole.polygon_ids.insert(whole.polygon_ids.end(), mesh.polygon_ids.begin(),
                                 mesh.polygon_ids.end());
        for (const std::uint32_t vertex : mesh.indices) whole.indices.push_back(first + vertex);
    }
    scene::Scene scene;
    scene.name = drawn.name;
    scene.materials = drawn.materials;
    scene.objects.push_back({.name = drawn.name, .mesh = make_mesh(std::move(whole))});
    return scene;
}

}  // namespace

// The sums of cover_texels, in its order: if all factors are 1, its bits.
std::vector<dvec3> emission_times(const PixmapModel& model,
                                  const std::function<dvec3(const Figure&)>& factor) {
    std::vector<dvec3> E(model.texel_count(), dvec3(0));
    for (const Facet& facet : model.facets) {
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        const Figure& figure = model.figures[facet.figure];
        const dvec3 emitted = figure.E * factor(figure);
        if (emitted == dvec3(0)) continue;
        for (const Triangle2& triangle : facet.triangles)
            for_each_part(triangle, pixmap, [&](int x, int y, const Polygon2& part) {
                E[pixmap.texel(x, y)] += area(part) * facet.texel_area * emitted;
            });
    }
    for (std::size_t t = 0; t < E.size(); ++t)
        E[t] = model.area[t] > 0 ? E[t] / model.area[t] : dvec3(0);
    return E;
}

std::vector<std::string> left_out(const PixmapModel& model) {
    if (model.without_area.empty()) return {};
    const std::string name = scene::printable(model.without_area[0]);
    const std::size_t others = model.without_area.size() - 1;
    const std::string more = others > 0 ? fmt::format(", and {} more like it", others) : "";
    return {fmt::format("object '{}' has no area, so radiosity leaves it out{}", name, more)};
}

void check_emission(const PixmapModel& model) {
    if (!model.direct.empty()) return;
    for (const Figure& figure : model.figures)
        if (figure.E != dvec3(0)) return;
    throw Error("scene '" + model.drawn.name +
                "': nothing emits light; expected a material with Ke, pixmap = {emission = ...} of "
                "an object, or a light in candela or lumen");
}

PixmapModel make_model(const scene::Scene& scene, const ModelOptions& options) {
    ModelBuilder builder(scene, options);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        // lines, points have no area
        if (scene.objects[i].mesh->kind() != MeshKind::Triangles) continue;
        builder.begin(i);
        if (!builder.has_area()) {
            builder.leave_out();
            continue;
        }
        scene.objects[i].pixmap.given_st ? add_given(builder) : add_automatic(builder);
        builder.end();
    }
    cover_texels(builder.model);
    builder.model.patches = patches_of(builder.model, options.patch);
    builder.model.joined = joined(builder.model.drawn);
    return std::move(builder.model);
}

}  // namespace gw::radiosity
