#include "scene/toml/read_scene.h"

#include "scene/draw/fit.h"
#include "scene/geometry/far.h"
#include "scene/geometry/transform.h"
#include "scene/gltf/read_gltf.h"
#include "scene/obj/read_obj.h"
#include "scene/scene_builder.h"
#include "scene/text/statements.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/toml/toml_sections.h"

namespace gw::scene {
namespace {

/// MTL has no lights, so a lamp that glows in a model does not mean that nothing else is lit.
void light_glowing(Scene& scene) {
    if (glows(scene)) scene.lights.push_back(default_light(fit_camera(bounds(scene), 4, 3)));
}

SceneFile read_bare_obj(const std::filesystem::path& path) {
    Warnings warnings;
    ObjFile file = read_obj(path, {}, warnings);
    const MaterialNames materials(file.materials, file.missing_library);
    SceneBuilder builder;
    builder.scene.name = path.stem().string();
    for (ObjPart& part : file.parts) {
        const Material& material = material_of_faces({&materials}, part.material,
                                                     {file.file, part.material_line}, warnings);
        builder.add({.name = part.name, .world_from_object = translation(part.origin)},
                    std::move(part.mesh), material, {file.file, 0});
    }
    warn_invisible(builder.scene, path.string(), warnings);
    const dvec3 origin = far_origin(builder.scene);
    if (origin != dvec3(0)) count_from(builder.scene, origin);
    light_glowing(builder.scene);
    return {std::move(builder.scene), warnings.lines(), {}, warnings.files(), origin};
}

SceneFile read_bare_gltf(const std::filesystem::path& path) {
    Warnings warnings;
    GltfFile file = read_gltf(path, warnings);
    return {std::move(file.scene), warnings.lines(), {},
            warnings.files(),      file.origin,      std::move(file.films)};
}

struct Format {
    const char* extension;
    SceneFile (*read)(const std::filesystem::path& path);
};
constexpr Format formats[] = {
    {".toml", read_toml},
    {".obj", read_bare_obj},
    {".gltf", read_bare_gltf},
    {".glb", read_bare_gltf},
};

}  // namespace

SceneFile read_scene(const std::filesystem::path& path) {
    const std::string extension = lower(path.extension().string());
    std::string expected;
    for (const Format& format : formats) {
        if (extension == format.extension) return format.read(path);
        const bool is_last = &format == std::end(formats) - 1;
        expected += (expected.empty() ? ""
                     : is_last        ? " or "
                                      : ", ") +
                    std::string(format.extension);
    }
    read_text(path);
    throw Error(path.string(), 0,
                "has the extension '" + printable(extension) + "'; expected " + expected);
}

}  // namespace gw::scene
