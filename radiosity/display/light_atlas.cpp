#include "radiosity/display/light_atlas.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

namespace gw::radiosity {
namespace {

/// Of a pixmap with its border.
AtlasPage block_of(const Pixmap& pixmap) { return {pixmap.width + 2, pixmap.height + 2}; }

/// A power of two: about the side of a square of all blocks.
int page_width(const PixmapModel& model, int most_side) {
    double area = 1;
    int widest = 1;
    for (const Pixmap& pixmap : model.pixmaps) {
        const AtlasPage block = block_of(pixmap);
        area += double(block.width) * block.height;
        widest = std::max(widest, block.width);
    }
    const int side = int(std::min(std::ceil(std::sqrt(area)), double(most_side)));
    const int power = int(std::bit_ceil(unsigned(std::max(side, widest))));
    return std::max(std::min(power, most_side), widest);
}

/// Rows of blocks from left to right, the highest blocks first.
class Shelves {
public:
    Shelves(LightAtlas& atlas, int width, int most_side)
        : atlas_(atlas), width_(width), most_side_(most_side) {
        atlas_.pages.push_back({width, 0});
    }

    AtlasPlace place(const AtlasPage& block) {
        if (x_ + block.width > width_) begin_shelf(y_ + shelf_);
        if (y_ > 0 && y_ + block.height > most_side_) {
            atlas_.pages.push_back({width_, 0});
            begin_shelf(0);
        }
        const AtlasPlace at{atlas_.pages.size() - 1, x_, y_};
        x_ += block.width;
        shelf_ = std::max(shelf_, block.height);
        atlas_.pages.back().height = std::max(atlas_.pages.back().height, y_ + block.height);
        return at;
    }

private:
    void begin_shelf(int y) {
        x_ = 0;
        y_ = y;
        shelf_ = 0;
    }

    LightAtlas& atlas_;
    const int width_, most_side_;
    int x_ = 0, y_ = 0, shelf_ = 0;
};

}  // namespace

vec2 LightAtlas::st_of(std::uint32_t pixmap, const dvec2& uv) const {
    const AtlasPlace& at = places[pixmap];
    const AtlasPage& page = pages[at.page];
    return {float((at.x + 1 + uv.x) / page.width), float((at.y + 1 + uv.y) / page.height)};
}

LightAtlas make_atlas(const PixmapModel& model, int most_side) {
    LightAtlas atlas;
    atlas.places.resize(model.pixmaps.size());
    std::vector<std::size_t> order(model.pixmaps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return model.pixmaps[a].height > model.pixmaps[b].height;
    });
    Shelves shelves(atlas, page_width(model, most_side), most_side);
    for (const std::size_t p : order) atlas.places[p] = shelves.place(block_of(model.pixmaps[p]));
    return atlas;
}

std::vector<float> page_colors(const LightAtlas& atlas, std::size_t page, const PixmapModel& model,
                               const DisplayedPixmaps& colors) {
    const auto width = std::size_t(atlas.pages[page].width);
    std::vector<float> values(width * std::size_t(atlas.pages[page].height) * 3);
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p) {
        const AtlasPlace& at = atlas.places[p];
        if (at.page != page) continue;
        for (int y = -1; y <= model.pixmaps[p].height; ++y)
            for (int x = -1; x <= model.pixmaps[p].width; ++x)
                for (int c = 0; c < 3; ++c)
                    values[(std::size_t(at.y + y + 1) * width + std::size_t(at.x + x + 1)) * 3 +
                           std::size_t(c)] = float(colors.at(p, x, y)[c]);
    }
    return values;
}

std::vector<AtlasMesh> atlas_meshes(const LightAtlas& atlas, const scene::Scene& scene,
                                    const PixmapModel& model) {
    std::vector<AtlasMesh> meshes;
    for (std::size_t i = 0; i < model.sources.size(); ++i) {
        const Source& source = model.sources[i];
        const MeshData& own = scene.objects[source.object].mesh->data();
        const Mesh& drawn = *model.drawn.objects[i].mesh;
        const auto triangles = scene.objects[source.object].mesh->triangles();
        std::map<std::size_t, AtlasMesh> of_page;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (source.facets[t] == no_facet) continue;
            const Facet& facet = model.facets[source.facets[t]];
            const std::size_t page = atlas.places[facet.pixmap].page;
            AtlasMesh& mesh = of_page[page];
            mesh.object = source.object;
            mesh.page = page;
            for (const std::uint32_t v : triangles[t].vertex) {
                const vec3& p = drawn.data().positions[v];
                mesh.positions.push_back(p);
                mesh.st.push_back(atlas.st_of(facet.pixmap, facet.texel_of(dvec3(p))));
                mesh.texcoords.push_back(own.texcoords.empty() ? vec2(0) : own.texcoords[v]);
            }
        }
        for (auto& [page, mesh] : of_page) meshes.push_back(std::move(mesh));
    }
    return meshes;
}

}  // namespace gw::radiosity
