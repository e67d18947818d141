#include "radiosity/model/patches.h"

#include "radiosity/model/facet_tree.h"
#include "radiosity/model/geometry.h"
#include "radiosity/model/texel_parts.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

/// A line of contact, in texels.
struct Segment {
    dvec2 from, to;
};

/// Of a triangle that stands on a facet's plane, or pierces it.
void add_contact(const std::array<dvec3, 3>& triangle, const Facet& facet, double touching_height,
                 std::vector<Segment>& contacts) {
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) {
        height[i] = dot3(facet.normal, triangle[i]) - facet.offset;
        if (std::abs(height[i]) <= touching_height) height[i] = 0;
    }
    if (*std::max_element(height.begin(), height.end()) <= 0) return;  // lies under it, or in it
    std::vector<dvec2> on;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (height[i] == 0) on.push_back(facet.texel_of(triangle[i]));
        if (height[i] * height[j] < 0)
            on.push_back(facet.texel_of(triangle[i] + (triangle[j] - triangle[i]) *
                                                          (height[i] / (height[i] - height[j]))));
    }
    if (!on.empty()) contacts.push_back({on.front(), on.back()});
}

/// Where the figures of other pixmaps stand on this facet or pierce it.
std::vector<Segment> contacts_of(const PixmapModel& model, const FacetTree& tree,
                                 const Facet& facet) {
    const double height = touching * model.extent;
    std::vector<Segment> contacts;
    tree.for_each_near(facet.center, facet.radius + height, [&](std::uint32_t i) {
        const Facet& other = model.facets[i];
        if (other.pixmap == facet.pixmap) return;
        const double middle = dot3(facet.normal, other.center) - facet.offset;
        if (std::abs(middle) > other.radius + height ||
            length(other.center - facet.center) > other.radius + facet.radius)
            return;
        for (const Triangle2& t : other.triangles)
            add_contact({other.at(t[0]), other.at(t[1]), other.at(t[2])}, facet, height, contacts);
    });
    return contacts;
}

/// Of all plane figures of a pixmap; curved ones are not divided.
std::vector<Segment> contacts_of(const PixmapModel& model, const FacetTree& tree,
                                 const Pixmap& pixmap) {
    std::vector<Segment> contacts;
    if (is_curved(pixmap)) return contacts;
    for (const std::uint32_t facet : pixmap.facets)
        for (const Segment& contact : contacts_of(model, tree, model.facets[facet]))
            contacts.push_back(contact);
    return contacts;
}

bool is_crossed(const Patch& patch, const Segment& segment) {
    constexpr double border = 1e-3;  // texels: a line along the border divides nothing
    const dvec2 low = dvec2(patch.x, patch.y) + dvec2(border),
                high = dvec2(patch.x + patch.width, patch.y + patch.height) - dvec2(border);
    double begin = 0, end = 1;
    for (int axis : {0, 1}) {
        const double from = segment.from[axis], along = segment.to[axis] - from;
        if (along == 0) {
            if (from < low[axis] || from > high[axis]) return false;
            continue;
        }
        const double a = (low[axis] - from) / along, b = (high[axis] - from) / along;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return begin <= end;
}

/// Adds up the texels of a patch.
void cover(const PixmapModel& model, Patch& patch) {
    patch.area = 0;
    patch.emits = false;
    for_each_texel(model, patch, [&](std::size_t t) {
        patch.area += model.area[t];
        patch.emits = patch.emits || (model.area[t] > 0 && model.E[t] != dvec3(0));
    });
}

void add(const PixmapModel& model, Patch patch, const std::vector<Segment>& contacts,
         std::vector<Patch>& patches) {
    const bool divided = std::max(patch.width, patch.height) > 1 &&
                         std::any_of(contacts.begin(), contacts.end(), [&](const Segment& contact) {
                             return is_crossed(patch, contact);
                         });
    if (!divided) {
        cover(model, patch);
        if (patch.area > 0) patches.push_back(patch);
        return;
    }
    const int half_x = (patch.width + 1) / 2, half_y = (patch.height + 1) / 2;
    for (int y = 0; y < patch.height; y += half_y)
        for (int x = 0; x < patch.width; x += half_x)
            add(model,
                {patch.pixmap, patch.x + x, patch.y + y, std::min(half_x, patch.width - x),
                 std::min(half_y, patch.height - y)},
                contacts, patches);
}

}  // namespace

std::vector<Patch> patches_of(const PixmapModel& model, int side) {
    const FacetTree tree(model.facets);
    std::vector<Patch> patches;
    for (std::uint32_t i = 0; i < model.pixmaps.size(); ++i) {
        const Pixmap& pixmap = model.pixmaps[i];
        const std::vector<Segment> contacts = contacts_of(model, tree, pixmap);
        for (int y = 0; y < pixmap.height; y += side)
            for (int x = 0; x < pixmap.width; x += side)
                add(model,
                    {i, x, y, std::min(side, pixmap.width - x), std::min(side, pixmap.height - y)},
                    contacts, patches);
    }
    return patches;
}

std::vector<Patch> same_patches(const PixmapModel& model, std::vector<Patch> patches) {
    for (Patch& patch : patches) cover(model, patch);
    return patches;
}

}  // namespace gw::radiosity
