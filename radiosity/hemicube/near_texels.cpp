#include "radiosity/hemicube/near_texels.h"

#include <array>
#include <span>
#include <vector>

namespace gw::radiosity {
namespace {

constexpr int most_divisions = 6;

/// The light of a square's parts, and what of it is shown.
class Division {
public:
    Division(const FigureView& view, const SeenIds& seen, std::uint32_t id)
        : view_(view), seen_(seen), id_(id) {
        for (int c = 0; c < 3; ++c) reach_[c] = std::abs(view.du[c]) + std::abs(view.dv[c]);
        most_ = std::max(reach_.x, std::max(reach_.y, reach_.z));
    }

    /// A square about (u, v), `half` to each side, in texels.
    void add(double u, double v, double half, int divisions) {
        const dvec3 p = view_.at(u, v);
        const double rise = half * reach_.z, spread = half * most_;
        if (p.z + rise <= 0) return;
        const double along = distance_in_face(p), room = along - spread;
        const std::uint32_t pixel = look(seen_, p);
        if (double(pixel >> 24) * room >=
            seen_.size * spread)  // all of it is seen as its middle is
            return add_light(u, v, p, half, (pixel & id_bits) == id_);
        if (divisions == 0 || seen_.size * spread <= 0.5 * room || is_dim(p, half, spread))
            return add_light(u, v, p, half, is_shown(u, v, p, pixel));
        const double q = half / 2;
        add(u - q, v - q, q, divisions - 1);
        add(u + q, v - q, q, divisions - 1);
        add(u - q, v + q, q, divisions - 1);
        add(u + q, v + q, q, divisions - 1);
    }

    double share() const { return all_ > 0 ? shown_ / all_ : 0; }

private:
    /// Whether a part that is not near itself receives less light than a quarter of a pixel.
    bool is_dim(const dvec3& p, double half, double spread) const {
        const double r2 = dot3(p, p), side = 2 * half, pixel = 2.0 / seen_.size;
        return r2 > 16 * spread * spread && view_.depth * (p.z + half * reach_.z) * (side * side) <
                                                0.25 * pixel * pixel * r2 * r2;
    }

    void add_light(double u, double v, const dvec3& p, double half, bool shown) {
        const double r2 = dot3(p, p);
        if (p.z <= 0 || from_border(u, v) < 0) return;
        const double light = p.z / (r2 * r2) * (half * half);
        all_ += light;
        if (shown) shown_ += light;
    }

    bool is_shown(double u, double v, const dvec3& p, std::uint32_t pixel) const {
        return (pixel & id_bits) == id_ ||
               (from_border(u, v) < reach_of_border(seen_.size) * distance_in_face(p) &&
                shown_near(seen_, p, id_));
    }

    double from_border(double u, double v) const {
        double least = 1e300;
        for (std::size_t k = 0; k < view_.side_count; ++k)
            least = std::min(least, dot3(view_.sides[k], dvec3(1, u, v)));
        return least;
    }

    const FigureView& view_;
    const SeenIds& seen_;
    const std::uint32_t id_;
    dvec3 reach_{0};
    double most_ = 0;
    double all_ = 0, shown_ = 0;
};

}  // namespace

double near_factor(const FigureView& view, const PlaneFigure& figure, const SeenIds& seen, int u,
                   int v) {
    const Polygon2 part = part_in_texel(figure, u, v);
    if (part.n < 3) return 0;
    Division division(view, seen, figure.facet + 1);
    division.add(u + 0.5, v + 0.5, 0.5, most_divisions);
    const double share = division.share();
    return share > 0 ? share * exact_factor(view, part) : 0;
}

namespace {

/// A texel's light from points of a part, the part's plane being z = 0.
class Beside {
public:
    Beside(const PixmapModel& model, const NearPart& part, const NearTexels& texels)
        : own_(model.facets[part.facet]), facet_(model.facets[texels.facet]), texels_(texels) {
        const double long_u = length(own_.du);
        x_ = own_.du / long_u;
        y_ = cross3(own_.normal, x_);
    }

    double factor(const Part& part, int u, int v) {
        add_pieces(u, v);
        if (pieces_.empty()) return 0;
        middle_ = in_plane(facet_.at({u + 0.5, v + 0.5}));
        radius_ = 0.5 * std::max(length(facet_.du + facet_.dv), length(facet_.du - facet_.dv));
        return mean(part, most_divisions);
    }

private:
    dvec3 in_plane(const dvec3& world) const {
        const dvec3 p = world - own_.origin;
        return {dot3(x_, p), dot3(y_, p), dot3(own_.normal, p)};
    }

    /// The texel's covered part, by triangles of the facet.
    void add_pieces(int u, int v) {
        for (const Triangle2& triangle : facet_.triangles) {
            Polygon2 polygon;
            for (const dvec2& corner : triangle) polygon.add(corner);
            polygon = cut_to_box(polygon, {u, v}, {u + 1, v + 1});
            for (const dvec3& side : texels_.sides) polygon = cut(polygon, side);
            if (polygon.n < 3) continue;
            std::vector<dvec3> corners;
            for (int i = 0; i < polygon.n; ++i) corners.push_back(in_plane(facet_.at(polygon[i])));
            pieces_.push_back(std::move(corners));
        }
    }

    /// In the mean over the part.
    double mean(const Part& part, int divisions) const {
        const dvec2 size = part.high - part.low, middle = (part.low + part.high) / 2.0;
        const double extent = std::max(length(own_.du) * size.x, length(own_.dv) * size.y);
        const double distance = length(middle_ - in_plane(own_.at(middle))) - radius_;
        const bool divided = divisions > 0 && 2 * extent > distance;
        const dvec2 offset = divided ? size / 4.0 : size / (2 * std::sqrt(3.0));  // Gauss' points
        double sum = 0;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const dvec2 uv = middle + dvec2(quarter & 1 ? 1 : -1, quarter & 2 ? 1 : -1) * offset;
            sum += divided ? mean({uv - size / 4.0, uv + size / 4.0}, divisions - 1) : from(uv);
        }
        return sum / 4;
    }

    double from(const dvec2& uv) const {
        const dvec3 point = in_plane(own_.at(uv));
        double sum = 0;
        for (const std::vector<dvec3>& piece : pieces_) {
            std::array<dvec3, std::tuple_size_v<decltype(Polygon2::p)>> corners;
            for (std::size_t i = 0; i < piece.size(); ++i) corners[i] = piece[i] - point;
            sum += exact_factor(std::span(corners).first(piece.size()));
        }
        return sum;
    }

    static constexpr int most_divisions = 4;
    const Facet &own_, &facet_;
    const NearTexels& texels_;
    dvec3 x_, y_;
    std::vector<std::vector<dvec3>> pieces_;
    dvec3 middle_{0};
    double radius_ = 0;
};

}  // namespace

double near_factor(const PixmapModel& model, const NearPart& part, const NearTexels& texels, int u,
                   int v) {
    return Beside(model, part, texels).factor(part.part, u, v);
}

}  // namespace gw::radiosity
