// A plane figure in the eye of a hemicube's point: positions, form factors and borders of its
// texels, all affine in texel coordinates [F2.2]. Scalar; texel_rows.cpp has vectors of texels.
#pragma once

#include "radiosity/hemicube/hemicube.h"
#include "radiosity/hemicube/plane_figure.h"
#include "radiosity/hemicube/seen.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gw::radiosity {

/// x and y: the top face's columns and rows; z: the height over the horizon. Lengths in parts of the
/// scene's extent.
struct FigureView {
    dvec3 origin{0}, du{0}, dv{0};  ///< p = origin + u du + v dv, from the point
    double flux = 0;   ///< a texel's form factor at p, if it is small: flux * p.z / dot(p, p)^2
    double depth = 0;  ///< area of a texel in the plane at distance 1: depth / (its distance)^3
    /// A side of the figure: dot(side, (1, u, v)) is 0 on it, above 0 inside, and the distance from
    /// the plane through the side and the point.
    std::array<dvec3, PlaneFigure::most_corners> sides{};
    std::size_t side_count = 0;

    dvec3 at(double u, double v) const { return origin + (u * du + v * dv); }
};

FigureView view_of(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube);
FigureView view_without_sides(const PixmapModel& model, const Facet& facet,
                              const Hemicube& hemicube);

/// The distance of p from the point along the axis of the face that sees it.
inline double distance_in_face(const dvec3& p) {
    return std::max(p.z, std::max(std::abs(p.x), std::abs(p.y)));
}

/// A position in the faces, in pixels of a face and of SeenIds.
struct FacePosition {
    double x = 0, y = 0;
    std::size_t first = 0;  ///< pixel of the face
    int rows = 0;
};
/// p.z >= 0.
FacePosition face_position(const dvec3& p, int size);

/// The pixel of SeenIds in which p is seen.
std::uint32_t look(const SeenIds& seen, const dvec3& p);

/// Whether any of the four pixels whose middles surround p has the identifier. A figure's border
/// runs among them: if nothing hides the figure there, one of them shows it.
bool shown_near(const SeenIds& seen, const dvec3& p, std::uint32_t id);

/// A side that is nearer than this, times distance_in_face, may run among the middles that surround a
/// position.
inline double reach_of_border(int size) { return 2.8284271247461903 / size; }

/// The form factor of a part of the plane in closed form (Lambert): of the polygon (in texels),
/// above the horizon.
double exact_factor(const FigureView& view, const Polygon2& polygon);
/// Of any plane polygon, its corners seen from the point as FigureView has them.
double exact_factor(std::span<const dvec3> corners);

}  // namespace gw::radiosity
