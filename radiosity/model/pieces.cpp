#include "radiosity/model/pieces.h"

#include "radiosity/model/texel_parts.h"

namespace gw::radiosity {
namespace {

constexpr double smallest_piece = 1e-9;

/// visit(quarter) of the part of a texel in each of its quarters.
template <class Visit>
void for_each_quarter(const Polygon2& part, int x, int y, Visit visit) {
    for (const int right : {0, 1})
        for (const int upper : {0, 1}) {
            const dvec2 low(x + right * 0.5, y + upper * 0.5);
            const Polygon2 quarter = cut_to_box(part, low, low + dvec2(0.5));
            if (quarter.n >= 3 && area(quarter) > smallest_piece) visit(quarter);
        }
}

}  // namespace

Pieces::Pieces(const PixmapModel& model) {
    for (const Facet& facet : model.facets) {
        first_.push_back(pieces_.size());
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        if (!is_curved(pixmap)) continue;
        for (const Triangle2& triangle : facet.triangles)
            for_each_part(triangle, pixmap, [&](int x, int y, const Polygon2& part) {
                for_each_quarter(part, x, y, [&](const Polygon2& quarter) {
                    pieces_.push_back({static_cast<std::uint32_t>(pixmap.texel(x, y)),
                                       static_cast<float>(area(quarter)), centroid(quarter)});
                });
            });
    }
    first_.push_back(pieces_.size());
}

}  // namespace gw::radiosity
