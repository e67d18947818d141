#include "radiosity/display/display.h"

#include "gw/base/arithmetic.h"
#include "radiosity/display/display_state.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>
#include <bit>
#include <map>

namespace gw::radiosity {
namespace {

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

void name_figure(Draw& draw, std::uint32_t pixmap) {
    draw.id_base = (pixmap + 1) << figure_shift;
    draw.id_shift = figure_shift;
}

CommandList figures_of(CommandList list) {
    for (Command& command : list.commands) {
        if (auto* set = std::get_if<SetState>(&command)) {
            set->state.color_source = ColorSource::PolygonId;
            set->state.shade_model = ShadeModel::Flat;
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

}  // namespace gw::radiosity
