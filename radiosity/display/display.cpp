#include "radiosity/display/display.h"

#include "gw/base/arithmetic.h"
#include "gw/base/parallel.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace gw::radiosity {
namespace {

/// Colours of vertices, no light, sides that do not emit left out.
State picture_state(const scene::View& view) {
    State state = scene::view_state(view);
    state.color_source = ColorSource::Vertex;
    state.lighting = {};
    state.cull.enable = true;
    return state;
}

void begin_picture(CommandList& list, const char* name, const State& state,
                   const vec3& background) {
    list.add(BeginPass{.name = name});
    list.add(SetState{state});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth)),
                   .color = vec4(background, 1)});
}

/// The identifier that display.h promises.
void name_figure(Draw& draw, std::uint32_t pixmap) {
    draw.id_base = (pixmap + 1) << figure_shift;
    draw.id_shift = figure_shift;
}

int texture_side(int texels) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(texels + 2)));
}

/// An object's triangles by the pixmap that they lie in, in one pass over the object.
std::map<std::uint32_t, MeshRef> meshes_by_pixmap(const PixmapModel& model, const Mesh& drawn) {
    std::map<std::uint32_t, MeshData> parts;
    for (const Triangle& triangle : drawn.triangles()) {
        const Facet& facet = model.facets[drawn.polygon_id(triangle.polygon)];
        MeshData& data = parts[facet.pixmap];
        for (std::uint32_t vertex : triangle.vertex) {
            const vec3& p = drawn.data().positions[vertex];
            data.positions.push_back(p);
            data.texcoords.push_back(st_of(model.pixmaps[facet.pixmap], facet.texel_of(dvec3(p))));
        }
    }
    std::map<std::uint32_t, MeshRef> meshes;
    for (auto& [pixmap, data] : parts) meshes.emplace(pixmap, make_mesh(std::move(data)));
    return meshes;
}

using Corner = std::array<float, 3>;

Corner corner_of(const vec3& p) { return {p.x, p.y, p.z}; }

/// The number of parts into which each side of a triangle is divided: as many as the finest pixmap
/// beside it has texels along it. Triangles that share a side divide it alike, even if they belong
/// to different objects.
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

TextureRef texture_of(const PixmapModel& model, std::uint32_t number,
                      const DisplayedPixmaps& colors, double scale) {
    const Pixmap& pixmap = model.pixmaps[number];
    const int width = texture_side(pixmap.width), height = texture_side(pixmap.height);
    std::vector<std::uint16_t> rgba;
    for (int y = -1; y < height - 1; ++y)
        for (int x = -1; x < width - 1; ++x) {
            const dvec3& color =
                colors.at(number, std::min(x, pixmap.width), std::min(y, pixmap.height));
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<std::uint16_t>(quantize(color[c] * scale, 16)));
            rgba.push_back(65535);
        }
    return make_texture(pixmap.name, width, height, rgba);
}

vec2 st_of(const Pixmap& pixmap, const dvec2& uv) {
    return vec2((uv + 1.0) / dvec2(texture_side(pixmap.width), texture_side(pixmap.height)));
}

CommandList figures_of(CommandList list) {
    for (Command& command : list.commands) {
        if (auto* set = std::get_if<SetState>(&command)) {
            State& state = set->state.edit();
            state.color_source = ColorSource::PolygonId;
            state.shade_model = ShadeModel::Flat;
        }
        if (auto* clear = std::get_if<Clear>(&command)) clear->color = vec4(0);
        if (auto* draw = std::get_if<Draw>(&command)) draw->map = {};
    }
    return list;
}

CommandList texture_list(const PixmapModel& model, const DisplayedPixmaps& colors,
                         const scene::View& view, const Brightness& brightness) {
    State state = picture_state(view);
    state.texture = {.wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .env = TexEnv::Replace};
    CommandList list;
    begin_picture(list, "radiosity as textures", state, brightness.background);
    std::vector<TextureRef> textures;
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p)
        textures.push_back(texture_of(model, p, colors, brightness.scale));
    for (const scene::Object& object : model.drawn.objects)
        for (auto& [pixmap, mesh] : meshes_by_pixmap(model, *object.mesh)) {
            Draw draw = scene::placed(object, view);
            draw.mesh = std::move(mesh);
            draw.map.texture = textures[pixmap];
            name_figure(draw, pixmap);
            list.add(std::move(draw));
        }
    return list;
}

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
