#include "radiosity/display.h"

#include "gw/arithmetic.h"
#include "gw/parallel.h"
#include "radiosity/lookup.h"
#include "scene/draw_commands.h"

#include <bit>
#include <cmath>

namespace gw::radiosity {

namespace {

State picture_state(const scene::View& view) {
    State state = scene::view_state(view);
    state.color_source = ColorSource::Vertex;
    state.lighting = {};
    state.cull.enable = true;
    return state;
}

void begin(CommandList& list, const char* name, const State& state, const vec3& background) {
    list.add(BeginPass{.name = name});
    list.add(SetState{state});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth)),
                   .color = vec4(background, 1)});
}

// --- textures

int texture_side(int texels) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(texels + 2))); }

TextureRef texture_of(const Pixmap& pixmap, const std::vector<dvec3>& colors, double scale) {
    const int width = texture_side(pixmap.width), height = texture_side(pixmap.height);
    std::vector<std::uint16_t> rgba;
    for (int y = -1; y < height - 1; ++y)
        for (int x = -1; x < width - 1; ++x) {
            const dvec3& color = texel_at(pixmap, colors, x, y);
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<std::uint16_t>(quantize(color[c] * scale, 16)));
            rgba.push_back(65535);
        }
    return make_texture(pixmap.name, width, height, rgba);
}

/// The triangles of an object that lie in one pixmap.
MeshRef mesh_in(const Model& model, const Mesh& drawn, std::uint32_t number) {
    const Pixmap& pixmap = model.pixmaps[number];
    const dvec2 side(texture_side(pixmap.width), texture_side(pixmap.height));
    MeshData data;
    for (const Triangle& triangle : drawn.triangles()) {
        const Facet& facet = model.facets[drawn.polygon_id(triangle.polygon)];
        if (facet.pixmap != number) continue;
        for (std::uint32_t vertex : triangle.vertex) {
            const vec3& p = drawn.data().positions[vertex];
            const dvec2 uv = facet.texel_of(dvec3(p));
            data.positions.push_back(p);
            data.texcoords.push_back(vec2((uv + 1.0) / side));
        }
    }
    return make_mesh(std::move(data));
}

/// The pixmaps of an object's facets, ascending.
std::vector<std::uint32_t> pixmaps_of(const Model& model, const Mesh& drawn) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t p = 0; p < drawn.polygon_count(); ++p)
        found.push_back(model.facets[drawn.polygon_id(p)].pixmap);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// --- strips

/// The colour at (u, v): the mean of the four texels around it.
dvec3 color_at(const Pixmap& pixmap, const std::vector<dvec3>& colors, const dvec2& uv) {
    const double u = uv.x - 0.5, v = uv.y - 0.5;
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    const double wx = u - x, wy = v - y;
    const auto row = [&](int j) {
        return texel_at(pixmap, colors, x, j) * (1 - wx) + texel_at(pixmap, colors, x + 1, j) * wx;
    };
    return row(y) * (1 - wy) + row(y + 1) * wy;
}

/// Rows of the longest edge of all triangles in each pixmap: sides that triangles share are divided alike.
std::vector<int> divisions(const Model& model) {
    std::vector<int> rows(model.pixmaps.size(), 1);
    for (const Facet& facet : model.facets)
        for (const Triangle2& t : facet.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const dvec2 side = t[(k + 1) % 3] - t[k];
                const double texels = std::max(std::abs(side.x), std::abs(side.y));
                rows[facet.pixmap] = std::max(rows[facet.pixmap], static_cast<int>(std::ceil(texels)));
            }
    return rows;
}

/// One triangle as one strip: rows from the side v0 v1 to v2, joined by triangles without area.
class Strip {
public:
    Strip(const Model& model, const std::vector<dvec3>& colors, double scale, const Mesh& drawn,
          const Triangle& triangle, const std::vector<int>& rows)
        : facet_(model.facets[drawn.polygon_id(triangle.polygon)]),
          pixmap_(model.pixmaps[facet_.pixmap]),
          colors_(colors),
          scale_(scale),
          rows_(rows[facet_.pixmap]) {
        data_.primitive = Primitive::TriangleStrip;
        for (std::size_t k = 0; k < 3; ++k) corner_[k] = dvec3(drawn.data().positions[triangle.vertex[k]]);
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i + j <= rows_; ++i) add_vertex(i, j);
        for (int j = 0; j < rows_; ++j) add_row(j);
    }
    MeshRef mesh() { return make_mesh(std::move(data_)); }

private:
    void add_vertex(int i, int j) {
        const dvec3 p =
            corner_[0] +
            ((corner_[1] - corner_[0]) * double(i) + (corner_[2] - corner_[0]) * double(j)) / double(rows_);
        const dvec3 color = color_at(pixmap_, colors_, facet_.texel_of(p)) * scale_;
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
            data_.indices.insert(data_.indices.end(), {data_.indices.back(), index(m, j), index(m, j)});
        for (int i = m; i > 0; --i)
            data_.indices.insert(data_.indices.end(), {index(i, j), index(i - 1, j + 1)});
        data_.indices.push_back(index(0, j));
    }

    const Facet& facet_;
    const Pixmap& pixmap_;
    const std::vector<dvec3>& colors_;
    const double scale_;
    const int rows_;
    std::array<dvec3, 3> corner_;
    MeshData data_;
};

}  // namespace

std::vector<dvec3> shown(const Model& model, const Solution& solution, bool with_ambient) {
    const dvec3 light = with_ambient ? ambient(model, solution) : dvec3(0);
    std::vector<dvec3> colors;
    for (std::size_t t = 0; t < model.texel_count(); ++t) {
        const std::size_t of = model.nearest[t];
        colors.push_back(radiosity_at(model, solution, of) + model.rho[of] * light);
    }
    return colors;
}

CommandList texture_list(const Model& model, const std::vector<dvec3>& colors, const scene::View& view,
                         const Brightness& brightness) {
    State state = picture_state(view);
    state.texture = {.wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .env = TexEnv::Replace};
    CommandList list;
    begin(list, "radiosity as textures", state, brightness.background);
    std::vector<TextureRef> textures;
    for (const Pixmap& pixmap : model.pixmaps)
        textures.push_back(texture_of(pixmap, colors, brightness.scale));
    for (const scene::Object& object : model.drawn.objects)
        for (std::uint32_t pixmap : pixmaps_of(model, *object.mesh)) {
            Draw draw = scene::placed(object, view);
            draw.mesh = mesh_in(model, *object.mesh, pixmap);
            draw.map.texture = textures[pixmap];
            list.add(std::move(draw));
        }
    return list;
}

CommandList strip_list(const Model& model, const std::vector<dvec3>& colors, const scene::View& view,
                       const Brightness& brightness, int threads) {
    CommandList list;
    begin(list, "radiosity as strips", picture_state(view), brightness.background);
    const std::vector<int> rows = divisions(model);
    for (const scene::Object& object : model.drawn.objects) {
        const auto triangles = object.mesh->triangles();
        std::vector<MeshRef> strips(triangles.size());
        parallel_for(triangles.size(), threads, [&](std::size_t i, int) {  // [F4] (3)
            strips[i] = Strip(model, colors, brightness.scale, *object.mesh, triangles[i], rows).mesh();
        });
        for (MeshRef& strip : strips) {
            Draw draw = scene::placed(object, view);
            draw.mesh = std::move(strip);
            list.add(std::move(draw));
        }
    }
    return list;
}

}  // namespace gw::radiosity
