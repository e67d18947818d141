// Pixmaps as triangle strips [F2.3, Fig. 4].
#include "gw/base/arithmetic.h"
#include "gw/base/parallel.h"
#include "radiosity/display/display.h"
#include "radiosity/display/display_state.h"
#include "scene/draw/draw_commands.h"

#include <cmath>
#include <map>

namespace gw::radiosity {
namespace {

using Corner = std::array<float, 3>;

Corner corner_of(const vec3& p) { return {p.x, p.y, p.z}; }

/// Into how many parts the sides of triangles are divided: as many as the finest pixmap at one has
/// texels along it. Triangles that share a side divide it alike, also where they belong to
/// different objects.
class Sides {
public:
    explicit Sides(const PixmapModel& model) {
        for (const scene::Object& object : model.drawn.objects)
            for (const Triangle& t : object.mesh->triangles()) {
                const Facet& facet = model.facets[object.mesh->polygon_id(t.polygon)];
                for (std::size_t k = 0; k < 3; ++k) add(facet, *object.mesh, t, k);
            }
    }

    int parts(const vec3& a, const vec3& b) const { return parts_.at(key(a, b)); }

    /// The same bits whichever end is named first.
    static dvec3 point(const vec3& a, const vec3& b, int part, int parts) {
        if (corner_of(b) < corner_of(a)) return point(b, a, parts - part, parts);
        return part == parts ? dvec3(b) : dvec3(a) + (dvec3(b) - dvec3(a)) * (double(part) / parts);
    }

private:
    using Key = std::pair<Corner, Corner>;

    static Key key(const vec3& a, const vec3& b) { return std::minmax(corner_of(a), corner_of(b)); }

    void add(const Facet& facet, const Mesh& mesh, const Triangle& t, std::size_t k) {
        const vec3 &a = mesh.data().positions[t.vertex[k]],
                   &b = mesh.data().positions[t.vertex[(k + 1) % 3]];
        const dvec2 side = facet.texel_of(dvec3(b)) - facet.texel_of(dvec3(a));
        const double texels = std::max(std::abs(side.x), std::abs(side.y));
        int& parts = parts_.try_emplace(key(a, b), 1).first->second;
        parts = std::max(parts, static_cast<int>(std::ceil(texels - 1e-6)));
    }

    std::map<Key, int> parts_;
};

/// One triangle as one strip: rows from the side v0 v1 to v2, joined by triangles without area. The
/// side with the most parts decides how many rows there are; on the other sides vertices fall
/// together.
class Strip {
public:
    Strip(const PixmapModel& model, const DisplayedPixmaps& colors, double scale, const Mesh& drawn,
          const Triangle& triangle, const Sides& sides)
        : facet_(model.facets[drawn.polygon_id(triangle.polygon)]), colors_(colors), scale_(scale) {
        data_.primitive = Primitive::TriangleStrip;
        for (std::size_t k = 0; k < 3; ++k) corner_[k] = drawn.data().positions[triangle.vertex[k]];
        for (std::size_t k = 0; k < 3; ++k)
            parts_[k] = sides.parts(corner_[k], corner_[(k + 1) % 3]);
        rows_ = std::max(std::max(parts_[0], parts_[1]), parts_[2]);
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i + j <= rows_; ++i) add_vertex(position(i, j));
        for (int j = 0; j < rows_; ++j) add_row(j);
    }
    MeshRef mesh() { return make_mesh(std::move(data_)); }

private:
    dvec3 position(int i, int j) const {
        if (j == 0) return on_side(0, i);
        if (i + j == rows_) return on_side(1, j);
        if (i == 0) return on_side(2, rows_ - j);
        const dvec3 a(corner_[0]), b(corner_[1]), c(corner_[2]);
        return a + ((b - a) * double(i) + (c - a) * double(j)) / double(rows_);
    }

    /// The nearest of the side's vertices.
    dvec3 on_side(std::size_t k, int i) const {
        const int part = (2 * i * parts_[k] + rows_) / (2 * rows_);
        return Sides::point(corner_[k], corner_[(k + 1) % 3], part, parts_[k]);
    }

    void add_vertex(const dvec3& p) {
        const dvec3 color = colors_.at(facet_.pixmap, facet_.texel_of(p)) * scale_;
        data_.positions.push_back(vec3(p));
        data_.colors.push_back(vec4(static_cast<float>(clamp01(color.x)),
                                    static_cast<float>(clamp01(color.y)),
                                    static_cast<float>(clamp01(color.z)), 1));
    }

    std::uint32_t index(int i, int j) const {
        return static_cast<std::uint32_t>(j * (rows_ + 1) - j * (j - 1) / 2 + i);
    }

    void add_row(int j) {
        const int m = rows_ - j;
        if (j > 0)  // twice: so that the row begins at an even place, and keeps its orientation
            data_.indices.insert(data_.indices.end(),
                                 {data_.indices.back(), index(m, j), index(m, j)});
        for (int i = m; i > 0; --i)
            data_.indices.insert(data_.indices.end(), {index(i, j), index(i - 1, j + 1)});
        data_.indices.push_back(index(0, j));
    }

    const Facet& facet_;
    const DisplayedPixmaps& colors_;
    const double scale_;
    int rows_ = 1;
    std::array<vec3, 3> corner_;
    std::array<int, 3> parts_{};  ///< of the sides 01, 12, 20
    MeshData data_;
};

}  // namespace

CommandList strip_list(const PixmapModel& model, const DisplayedPixmaps& colors,
                       const scene::View& view, const Brightness& brightness, int threads) {
    CommandList list;
    begin_picture(list, "radiosity as strips", picture_state(view), brightness.background);
    const Sides sides(model);
    for (const scene::Object& object : model.drawn.objects) {
        const auto triangles = object.mesh->triangles();
        std::vector<MeshRef> strips(triangles.size());
        parallel_for(triangles.size(), threads, [&](std::size_t i, int) {  // [F4] (3)
            strips[i] =
                Strip(model, colors, brightness.scale, *object.mesh, triangles[i], sides).mesh();
        });
        for (std::size_t i = 0; i < strips.size(); ++i) {
            Draw draw = scene::placed(object, view);
            draw.mesh = std::move(strips[i]);
            name_figure(draw, model.facets[object.mesh->polygon_id(triangles[i].polygon)].pixmap);
            list.add(std::move(draw));
        }
    }
    return list;
}

}  // namespace gw::radiosity
