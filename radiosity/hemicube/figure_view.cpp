#include "radiosity/hemicube/figure_view.h"

#include "gw/base/elementary.h"

namespace gw::radiosity {
namespace {

dvec3 in_eye(const scene::View& top, const dvec3& world) {
    const dvec3 eye = transform3(dmat3(top.eye_from_world), world);
    return {eye.x, eye.y, -eye.z};
}

/// (distance along the face's axis, columns, rows), and the face.
struct InFace {
    double along = 0, column = 0, row = 0;
    int face = 0;
};

// The sides' columns run around the cube: cube_views(), turned as hemicube_at() does.
InFace in_face(const dvec3& p) {
    const double x = std::abs(p.x), y = std::abs(p.y);
    if (p.z >= std::max(x, y)) return {p.z, p.x, p.y, 0};
    if (x >= y) return {x, p.x < 0 ? -p.y : p.y, p.z, p.x < 0 ? 1 : 2};
    return {y, p.y < 0 ? p.x : -p.x, p.z, p.y < 0 ? 3 : 4};
}

}  // namespace

FigureView view_without_sides(const PixmapModel& model, const Facet& facet,
                              const Hemicube& hemicube) {
    const scene::View& top = hemicube.views[0];
    FigureView view;
    const double unit = 1 / model.extent;
    view.origin = in_eye(top, facet.origin - hemicube.position) * unit;
    view.du = in_eye(top, facet.du) * unit;
    view.dv = in_eye(top, facet.dv) * unit;
    const double height = (dot3(facet.normal, hemicube.position) - facet.offset) * unit;
    view.depth = facet.texel_area * unit * unit * height;
    view.flux = view.depth / pi;
    return view;
}

FigureView view_of(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube) {
    FigureView view = view_without_sides(model, model.facets[figure.facet], hemicube);
    dvec2 middle(0);
    for (const dvec2& corner : figure.outline) middle += corner / double(figure.outline.size());
    for (std::size_t i = 0; i < figure.outline.size(); ++i) {
        const dvec2 &a = figure.outline[i],
                    &b = figure.outline[i + 1 < figure.outline.size() ? i + 1 : 0];
        const dvec3 n = cross3(view.at(a.x, a.y), view.at(b.x, b.y));
        const double in = dot3(n, view.at(middle.x, middle.y)),
                     scale = (in < 0 ? -1 : 1) / length(n);
        view.sides[view.side_count++] =
            dvec3(dot3(n, view.origin), dot3(n, view.du), dot3(n, view.dv)) * scale;
    }
    return view;
}

FacePosition face_position(const dvec3& p, int size) {
    const InFace f = in_face(p);
    const double half = size * 0.5, over = half / f.along;
    const std::size_t all = std::size_t(size) * std::size_t(size);
    return {f.column * over + half, f.row * over + (f.face == 0 ? half : 0),
            f.face == 0 ? 0 : all + std::size_t(f.face - 1) * (all / 2),
            f.face == 0 ? size : size / 2};
}

namespace {

std::uint32_t pixel_at(const SeenIds& seen, const FacePosition& at, int column, int row) {
    const int x = std::clamp(column, 0, seen.size - 1), y = std::clamp(row, 0, at.rows - 1);
    return seen.pixels[at.first + std::size_t(y) * std::size_t(seen.size) + std::size_t(x)];
}

}  // namespace

std::uint32_t look(const SeenIds& seen, const dvec3& p) {
    const FacePosition at = face_position(p, seen.size);
    return pixel_at(seen, at, static_cast<int>(at.x), static_cast<int>(at.y));
}

bool shown_near(const SeenIds& seen, const dvec3& p, std::uint32_t id) {
    const FacePosition at = face_position(p, seen.size);
    // + 1: rounds down also half a pixel before the first
    const int x = static_cast<int>(at.x + 0.5) - 1, y = static_cast<int>(at.y + 0.5) - 1;
    bool shown = false;
    for (int row : {y, y + 1})
        for (int column : {x, x + 1})
            shown = shown || (pixel_at(seen, at, column, row) & id_bits) == id;
    return shown;
}

double exact_factor(const FigureView& view, const Polygon2& polygon) {
    std::array<dvec3, std::tuple_size_v<decltype(polygon.p)>> corners;
    for (int i = 0; i < polygon.n; ++i)
        corners[std::size_t(i)] = view.at(polygon[i].x, polygon[i].y);
    return exact_factor(std::span(corners).first(std::size_t(polygon.n)));
}

double exact_factor(std::span<const dvec3> corners) {
    // cut at the horizon
    std::array<dvec3, 16> p;
    std::size_t n = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
        if (a.z >= 0) p[n++] = a;
        if ((a.z >= 0) != (b.z >= 0)) p[n++] = a + (b - a) * (a.z / (a.z - b.z));
    }
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const dvec3 &a = p[i], &b = p[i + 1 < n ? i + 1 : 0], c = cross3(a, b);
        const double size = length(c);
        if (size > 0) sum += atan2(size, dot3(a, b)) * (c.z / size);
    }
    return std::abs(sum) / (2 * pi);
}

}  // namespace gw::radiosity
