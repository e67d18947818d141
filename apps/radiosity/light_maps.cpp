#include "apps/radiosity/light_maps.h"

#include "apps/command/terminal.h"
#include "apps/radiosity/own_textures.h"
#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "image/rgbm.h"
#include "image/write.h"
#include "inspect/text/plural.h"
#include "radiosity/display/light_atlas.h"
#include "scene/draw/view.h"
#include "scene/gltf/gltf_material.h"
#include "scene/gltf/write_gltf.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

/// As a display shows it: `scale` times the radiosity, clamped, encoded as in sRGB.
image::Picture display_picture(const radiosity::AtlasPage& page,
                               const std::vector<float>& radiosities, double scale) {
    image::Picture picture{page.width, page.height, 3, 8, {}};
    for (std::size_t i = 0; i < radiosities.size(); i += 3) {
        const vec3 color =
            scene::encoded(scale * dvec3(radiosities[i], radiosities[i + 1], radiosities[i + 2]));
        for (int c = 0; c < 3; ++c)
            picture.values.push_back(std::uint16_t(quantize(double(color[c]), 8)));
    }
    return picture;
}

/// `scale` times the radiosity, linear.
image::Picture in_rgbm(const radiosity::AtlasPage& page, const std::vector<float>& radiosities,
                       double scale, double range) {
    image::Picture picture{page.width, page.height, 4, 8, {}};
    for (std::size_t i = 0; i < radiosities.size(); i += 3)
        for (const std::uint8_t v : image::rgbm_of(
                 scale * dvec3(radiosities[i], radiosities[i + 1], radiosities[i + 2]), range))
            picture.values.push_back(v);
    return picture;
}

/// A map's coordinates are moved, so that a texture needs no other statement.
scene::WrittenMesh written(radiosity::AtlasMesh mesh, const scene::Scene& scene,
                           OwnTextures& textures, image::OutputSet& files) {
    const scene::Object& object = scene.objects[mesh.object];
    const scene::Material& material = scene.materials[object.material];
    const std::optional<std::size_t> own = textures.of(object, material, files);
    if (own)
        for (vec2& st : mesh.texcoords)
            st = st * material.map_Kd[0].scale + material.map_Kd[0].offset;
    return {.name = object.name,
            .picture = mesh.page,
            .texture = own,
            .positions = std::move(mesh.positions),
            .texcoord_0 = std::move(mesh.texcoords),
            .texcoord_1 = std::move(mesh.st)};
}

void put_page(const RadiosityOptions& options, const radiosity::AtlasPage& page,
              std::vector<float> values, const std::string& name, image::OutputSet& files) {
    image::put_values(files.add(options.output / (name + ".exr")),
                      {page.width, page.height, {"R", "G", "B"}, std::move(values)});
}

}  // namespace

void put_light_map_values(const RadiosityOptions& options, const Solved& solved,
                          const std::string& prefix, image::OutputSet& files) {
    const radiosity::DisplayedPixmaps colors = displayed(solved, options);
    const radiosity::LightAtlas atlas = radiosity::make_atlas(solved.model);
    for (std::size_t i = 0; i < atlas.pages.size(); ++i)
        put_page(options, atlas.pages[i], radiosity::page_colors(atlas, i, solved.model, colors),
                 fmt::format("{}light_map_{}", prefix, i + 1), files);
}

std::string put_light_maps(const RadiosityOptions& options, const scene::Scene& scene,
                           const Solved& solved, const std::string& prefix,
                           image::OutputSet& files) {
    const radiosity::PixmapModel& model = solved.model;
    const radiosity::DisplayedPixmaps colors = displayed(solved, options);
    const radiosity::LightAtlas atlas = radiosity::make_atlas(model);
    const double scale = shown_scale(options, scene);
    const Size size = options.picture.size;
    scene::WrittenScene out{.camera = scene::make_view(scene, size.width, size.height).camera,
                            .aspect = double(size.width) / size.height};
    double brightest = 0;
    for (std::size_t i = 0; i < atlas.pages.size(); ++i) {
        const radiosity::AtlasPage& page = atlas.pages[i];
        std::vector<float> values = radiosity::page_colors(atlas, i, model, colors);
        for (const float v : values) brightest = std::max(brightest, double(v));
        const std::string name = fmt::format("{}light_map_{}", prefix, i + 1);
        out.pictures.push_back({name + ".png", name + ".exr", scale});
        if (options.rgbm > 0) {
            out.pictures.back().rgbm = name + "_rgbm.png";
            out.pictures.back().range = options.rgbm;
            image::put_picture(files.add(options.output / out.pictures.back().rgbm),
                               in_rgbm(page, values, scale, options.rgbm));
        }
        image::put_picture(files.add(options.output / (name + ".png")),
                           display_picture(page, values, scale));
        put_page(options, page, std::move(values), name, files);
    }
    OwnTextures textures(options.output / prefix);
    for (radiosity::AtlasMesh& mesh : radiosity::atlas_meshes(atlas, scene, model))
        out.meshes.push_back(written(std::move(mesh), scene, textures, files));
    out.textures = textures.all();
    const scene::GltfText text = scene::write_gltf(out, prefix + "light_maps.bin");
    files.add(options.output / (prefix + "light_maps.gltf")).write_text(text.json);
    files.add(options.output / (prefix + "light_maps.bin")).write_text(text.bytes);
    if (options.rgbm > 0 && brightest * scale > options.rgbm)
        print_warning(fmt::format(
            "--rgbm {:.4g}: the brightest radiosity is {:.4g} times white; more than the range is cut "
            "off",
            options.rgbm, brightest * scale));
    return fmt::format(
        "{}; the brightest radiosity is {:.4g}, white in PNG is {:.4g}\n",
        inspect::plural(std::uint64_t(atlas.pages.size()), "light map", "light maps"), brightest,
        1 / scale);
}

}  // namespace gw::apps
