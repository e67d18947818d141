#include "radiosity/hemicube/texel_scan.h"

#include "radiosity/hemicube/near_texels.h"

#include <algorithm>

namespace gw::radiosity {
namespace {

/// In pixels: the area and the width that a figure has at least.
constexpr double least_area = 64, least_width = 2;

constexpr std::size_t longest_vector = 64;

class TexelScan {
public:
    TexelScan(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube,
              const SeenIds& seen, TexelScratch& scratch)
        : figure_(figure),
          view_(view_of(model, figure, hemicube)),
          sight_{view_, seen, figure.facet + 1},
          scratch_(scratch) {}

    /// Finds scratch.factors.
    void scan() {
        begin();
        for (int v = figure_.first.y; v < figure_.end.y; ++v) row(v);
        for (TexelKind kind = 1; kind < near_point; ++kind) find_parts_seen(kind);
        for (const ivec2& t : scratch_.near)
            scratch_.factors[number(t.x, t.y)] =
                static_cast<float>(near_factor(view_, figure_, sight_.seen, t.x, t.y));
    }

private:
    std::size_t number(int u, int v) const {
        return pixel_index(u - figure_.first.x, v - figure_.first.y, figure_.width());
    }

    void begin() {
        const auto space = std::size_t(figure_.width()) + longest_vector,
                   all = number(figure_.first.x, figure_.end.y) + longest_vector;
        if (scratch_.kinds.size() < space)
            for (scratch_.kinds.resize(space); auto* values : {&scratch_.low, &scratch_.high})
                values->resize(space);
        if (scratch_.factors.size() < all) scratch_.factors.resize(all);
        for (TexelList& list : scratch_.lists) list.count = 0;
        scratch_.near.clear();
        find_corners(view_, row_at(figure_.first.y), scratch_.high.data());
    }

    TexelRow row_at(int v) const { return {figure_.first.x, v, figure_.width()}; }

    void row(int v) {
        std::swap(scratch_.low, scratch_.high);
        find_corners(view_, row_at(v + 1), scratch_.high.data());
        float* const factors = &scratch_.factors[number(figure_.first.x, v)];
        find_row(sight_, row_at(v), scratch_.low.data(), scratch_.high.data(), factors,
                 scratch_.kinds.data());
        for (int i = 0; i < figure_.width(); ++i) {
            const bool is_cut = next_cut_ < figure_.cuts.size() && figure_.cuts[next_cut_].v == v &&
                                figure_.cuts[next_cut_].u == figure_.first.x + i;
            const PlaneFigure::Cut* const cut = is_cut ? &figure_.cuts[next_cut_++] : nullptr;
            TexelKind kind = scratch_.kinds[std::size_t(i)];
            if (cut) kind = cut_texel(*cut, factors[i], kind);
            if (kind != decided) add_to_list(kind, figure_.first.x + i, v, cut);
        }
    }

    /// The part of a texel that is inside receives less light, or none.
    TexelKind cut_texel(const PlaneFigure::Cut& cut, float& factor, TexelKind kind) const {
        if (factor == 0) return kind;
        const dvec3 p = view_.at(cut.middle.x, cut.middle.y);
        const double r2 = dot3(p, p);
        factor = static_cast<float>(cut.share * view_.flux * std::max(p.z, 0.0) / (r2 * r2));
        return cut.share == 0 ? decided : kind;
    }

    void add_to_list(TexelKind kind, int u, int v, const PlaneFigure::Cut* cut) {
        const dvec2 middle(u + 0.5, v + 0.5);
        if (kind == near_point)
            scratch_.near.push_back({u, v});
        else
            scratch_.lists[std::size_t(kind)].add(middle, cut ? cut->middle : middle, number(u, v));
    }

    void find_parts_seen(TexelKind kind) {
        TexelList& list = scratch_.lists[std::size_t(kind)];
        if (list.count == 0) return;
        find_shares(sight_, kind, list);
        for (std::size_t i = 0; i < list.count; ++i)
            scratch_.factors[list.texel[i]] *= list.shares[i];
    }

    const PlaneFigure& figure_;
    const FigureView view_;
    const TexelSight sight_;
    TexelScratch& scratch_;
    std::size_t next_cut_ = 0;
};

/// Whether a facet at this height under the point is smaller than least_area wherever it is seen. A
/// bound, which costs less than the area: distance_in_face >= distance / sqrt(3).
bool is_surely_small(const Facet& facet, const PlaneFigure& figure, const Hemicube& hemicube,
                     double height) {
    const double nearest = length(facet.center - hemicube.position) - figure.radius,
                 half = hemicube.views[0].width * 0.5;
    if (nearest <= 0) return false;
    const dvec2 texels = facet.high - facet.low;
    const double most = texels.x * texels.y * facet.texel_area * height * half * half;
    return most * (3 * 1.7320508075688772) * (1 + 1e-6) < least_area * nearest * nearest * nearest;
}

}  // namespace

bool can_scan_texels(const PixmapModel& model, const PlaneFigure& figure,
                     const Hemicube& hemicube) {
    const Facet& facet = model.facets[figure.facet];
    const double height = dot3(facet.normal, hemicube.position) - facet.offset;
    if (height <= 0 || is_surely_small(facet, figure, hemicube, height)) return false;
    const dvec2 foot = facet.texel_of(hemicube.position),
                nearest(std::clamp(foot.x, facet.low.x, facet.high.x),
                        std::clamp(foot.y, facet.low.y, facet.high.y));
    const FigureView view = view_without_sides(model, facet, hemicube);
    const double along = distance_in_face(view.at(nearest.x, nearest.y)),
                 half = hemicube.views[0].width * 0.5;
    // of the part that is about as near: its sides
    const double long_u = length(view.du), long_v = length(view.dv),
                 u = std::min((facet.high.x - facet.low.x) * long_u, along),
                 v = std::min((facet.high.y - facet.low.y) * long_v, along);
    const double texels = u / long_u * (v / long_v),
                 area = texels * view.depth * half * half / (along * along * along);
    return area >= least_area && area >= least_width * std::max(u, v) * half / along;
}

bool scan_texels(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube,
                 const SeenIds& seen, std::span<double> factors, TexelScratch& scratch) {
    TexelScan(model, figure, hemicube, seen, scratch).scan();
    const Pixmap& pixmap = model.pixmaps[model.facets[figure.facet].pixmap];
    const auto width = std::size_t(figure.width());
    float any = 0;
    const float* from = scratch.factors.data();
    for (int v = figure.first.y; v < figure.end.y; ++v, from += width) {
        double* const to = &factors[pixmap.texel(figure.first.x, v)];
        for (std::size_t i = 0; i < width; ++i) to[i] += double(from[i]);
        for (std::size_t i = 0; i < width; ++i) any = std::max(any, from[i]);
    }
    return any > 0;
}

namespace {

/// Whether pieces of one facet are seen from a hemicube's point.
class PieceSight {
public:
    PieceSight(const PixmapModel& model, std::uint32_t facet, const Hemicube& hemicube,
               const SeenIds& seen)
        : model_(model),
          facet_(model.facets[facet]),
          id_(facet + 1),
          position_(hemicube.position),
          height_(dot3(facet_.normal, position_) - facet_.offset),
          seen_(seen) {}

    /// `p`: the same middle as FigureView has it.
    bool is_seen(const dvec3& p, const dvec2& middle) const {
        const std::uint32_t id = look(seen_, p) & id_bits;
        if (id == nothing || id == id_) return true;
        const Facet& shown = model_.facets[id - 1];
        const dvec3 d = facet_.at(middle) - position_;
        const double distance = length(d);
        return is_of_same_surface(shown, d, distance, p) || !is_before(shown, d, distance);
    }

private:
    /// A pixel shows one of the small facets in it.
    bool is_of_same_surface(const Facet& shown, const dvec3& d, double distance,
                            const dvec3& p) const {
        if (model_.figures[shown.figure].object != model_.figures[facet_.figure].object)
            return false;
        constexpr double least_cos = 0.1;
        const double pixel = distance_in_face(p) * model_.extent * 2 / seen_.size,
                     reach = 2 * pixel / std::max(height_ / distance, least_cos);
        return length(shown.center - (position_ + d)) <= shown.radius + reach;
    }

    /// Whether the shown facet is nearer than the piece: its plane, as far as the facet reaches.
    bool is_before(const Facet& shown, const dvec3& d, double distance) const {
        constexpr double nearer = 1 - 1e-3;
        const double slope = dot3(shown.normal, d),
                     t = (shown.offset - dot3(shown.normal, position_)) / slope,
                     middle = length(shown.center - position_) / distance,
                     reach = shown.radius / distance;
        return std::clamp(slope == 0 ? middle : t, middle - reach, middle + reach) < nearer;
    }

    const PixmapModel& model_;
    const Facet& facet_;
    const std::uint32_t id_;
    const dvec3 position_;
    const double height_;
    const SeenIds& seen_;
};

}  // namespace

bool can_scan_pieces(const PixmapModel& model, std::uint32_t number, const Hemicube& hemicube) {
    constexpr double far_enough = 4;  // radii
    const Facet& facet = model.facets[number];
    if (dot3(facet.normal, hemicube.position) - facet.offset <= 0) return false;
    const dvec3 d = facet.center - hemicube.position;
    return dot3(d, d) >= far_enough * far_enough * facet.radius * facet.radius;
}

void scan_pieces(const PixmapModel& model, std::uint32_t facet, std::span<const Piece> pieces,
                 const Hemicube& hemicube, const SeenIds& seen, std::span<double> factors) {
    const FigureView view = view_without_sides(model, model.facets[facet], hemicube);
    const PieceSight sight(model, facet, hemicube, seen);
    for (const Piece& piece : pieces) {
        const dvec3 p = view.at(piece.middle.x, piece.middle.y);
        if (p.z <= 0 || !sight.is_seen(p, piece.middle)) continue;
        const double r2 = dot3(p, p);
        factors[piece.texel] += double(piece.share) * view.flux * p.z / (r2 * r2);
    }
}

double sum_of(std::span<const double> values) {
    constexpr std::size_t lanes = 8;
    double sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= values.size(); i += lanes)
        for (std::size_t k = 0; k < lanes; ++k) sums[k] += values[i + k];
    for (; i < values.size(); ++i) sums[0] += values[i];
    return ((sums[0] + sums[4]) + (sums[1] + sums[5])) +
           ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

}  // namespace gw::radiosity
