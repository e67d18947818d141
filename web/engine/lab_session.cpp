#include "web/engine/lab_session.h"

#include "gw/error.h"
#include "inspect/manifest/json_of.h"
#include "inspect/manifest/manifest.h"
#include "inspect/replay/forwarding_machine.h"
#include "multipass/frame/scene_maps.h"
#include "multipass/passes/pass_toml.h"
#include "scene/draw/fit.h"
#include "web/engine/method.h"
#include "web/engine/rgba.h"

#include <algorithm>
#include <filesystem>

namespace gw::lab {
namespace {

dvec3 point(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }
Json json_of(const dvec3& p) { return Json::array({p.x, p.y, p.z}); }

int side(const Json& options, const char* name) {
    const int pixels = options.at(name);
    if (pixels < 1 || pixels > max_window_size)
        throw Error(std::string(name) + " " + std::to_string(pixels) + "; expected 1.." +
                    std::to_string(max_window_size) + " pixels");
    return pixels;
}

apps::DrawOptions draw_options(const Json& options) {
    apps::DrawOptions draw;
    draw.passes.samples = options.value("samples", 1);
    draw.traced = options.value("reflections", "rays") == "rays";
    draw.rays.depth = options.value("depth", draw.rays.depth);
    draw.rays.threads = 1;
    const std::string translucency = options.value("translucency", "sorted");
    draw.passes.translucency = translucency == "layers"     ? multipass::Translucency::Layers
                               : translucency == "unsorted" ? multipass::Translucency::Unsorted
                                                            : multipass::Translucency::Sorted;
    return draw;
}

template <class Visit>
void for_each_map(scene::Scene& scene, const Visit& visit) {
    for (scene::Material& m : scene.materials)
        for (auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
            for (scene::Map& map : *maps)
                if (map.from_scene == 0) visit(map);
}

std::string key_of(const std::filesystem::path& file) {
    return std::filesystem::absolute(file).lexically_normal().string();
}

/// Where a mistake is said to be: "list:3".
multipass::PassList pass_list_from(const std::string& text) {
    const scene::TomlValue toml = scene::read_toml_text(text, "list");
    const scene::TomlValue* tables = toml.find("pass");
    if (!tables || tables->kind != scene::TomlKind::Array)
        throw Error("the list has no pass; expected [[pass]]");
    return multipass::read_passes(tables->elements);
}

}  // namespace

void LabSession::add_picture(const std::string& path, int width, int height, int bits,
                             const std::string& texels) {
    const std::size_t row = std::size_t(width) * 4 * std::size_t(bits / 8);
    if (texels.size() != row * std::size_t(height))
        throw Error(path + ": " + std::to_string(texels.size()) + " bytes; expected " +
                    std::to_string(row * std::size_t(height)));
    std::string turned;  // the machine's textures have the bottom row first
    for (std::size_t y = std::size_t(height); y-- > 0;) turned.append(texels, y * row, row);
    const std::string name = std::filesystem::path(path).filename().string();
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(turned.data());
    if (bits == 8) {
        pictures_[key_of(path)] = make_texture8(name, width, height, {bytes, turned.size()});
        return;
    }
    std::vector<std::uint16_t> rgba(turned.size() / 2);
    std::copy_n(bytes, turned.size(), reinterpret_cast<std::uint8_t*>(rgba.data()));
    pictures_[key_of(path)] = make_texture(name, width, height, rgba);
}

Json LabSession::open(const Json& options) {
    drivers_.clear();
    lightings_ = {};
    rays_.reset();
    caster_.reset();
    shapes_.clear();
    file_ = scene::read_scene(options.at("path").get<std::string>());
    Json objects = Json::array(), lights = Json::array(), pictures = Json::array();
    for (const scene::Object& object : file_.scene.objects)
        objects.push_back(
            {{"name", object.name},
             {"material", file_.scene.materials.at(object.material).name},
             {"triangles", object.mesh ? object.mesh->data().indices.size() / 3 : 0}});
    for (const scene::Light& light : file_.scene.lights) lights.push_back(light.name);
    for_each_map(file_.scene, [&](const scene::Map& map) { pictures.push_back(key_of(map.file)); });
    const scene::Scene seen = scene_for({{"width", 320}, {"height", 240}});
    return {{"name", file_.scene.name},
            {"warnings", file_.warnings},
            {"objects", objects},
            {"lights", lights},
            {"pictures", pictures},
            {"eye", json_of(seen.camera->eye)},
            {"at", json_of(seen.camera->at)},
            {"up", json_of(seen.camera->up)},
            {"fov", seen.camera->fov}};
}

scene::Scene LabSession::scene_for(const Json& options) const {
    scene::Scene scene = file_.scene;
    scene::add_defaults(scene, side(options, "width"), side(options, "height"));
    scene::CameraOverrides camera;
    if (options.contains("eye")) camera.eye = point(options["eye"]);
    if (options.contains("at")) camera.at = point(options["at"]);
    if (options.contains("fov")) camera.fov = options["fov"];
    scene.camera = scene::override_camera(*scene.camera, camera);
    if (options.contains("up")) scene.camera->up = point(options["up"]);
    if (const std::string shadow = options.value("shadow", ""); !shadow.empty())
        for (scene::Light& light : scene.lights)
            if (light.shadow != scene::Shadow::None)
                light.shadow = shadow == "map"      ? scene::Shadow::Map
                               : shadow == "volume" ? scene::Shadow::Volume
                                                    : scene::Shadow::None;
    return scene;
}

scene::View LabSession::view_of(const scene::Scene& scene, const Json& options) const {
    return scene::make_view(scene, side(options, "width"), side(options, "height"));
}

std::unique_ptr<Machine> LabSession::new_machine(const Json& options) {
    return make_fast(profile_named(options.value("profile", "vgx")), side(options, "width"),
                     side(options, "height"), {.threads = 1});
}

Machine& LabSession::machine_for(const Json& options) {
    const std::string key =
        Json{options.value("profile", "vgx"), options.at("width"), options.at("height")}.dump();
    if (key != machine_key_) {
        machine_key_.clear();
        drivers_.clear();
        rays_.reset();
        machine_.reset();
        machine_ = new_machine(options);
        machine_key_ = key;
    }
    machine_->reset_passes();
    return *machine_;
}

void LabSession::load_textures(scene::Scene& scene) const {
    for_each_map(scene, [&](scene::Map& map) {
        const auto found = pictures_.find(key_of(map.file));
        if (found == pictures_.end())
            throw Error(map.origin.file, map.origin.line,
                        map.file.string() + " is not here; expected it beside the scene");
        map.texture = found->second;
    });
}

LabSession::Subject LabSession::subject_of(Machine& machine, const Json& options) const {
    const std::string name = options.value("renderer", "multipass");
    const std::vector<std::string> known = apps::renderer_names();
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw Error("renderer '" + name +
                    "'; expected hardware, multipass, scanline, raytrace or adaptive");
    Subject subject{apps::renderer_named(name), scene_for(options), {}, draw_options(options)};
    load_textures(subject.scene);
    subject.view = view_of(subject.scene, options);
    multipass::Options& passes = subject.draw.passes;
    const bool lists = subject.renderer.passes == multipass::Renderer::Multipass;
    if (const std::string list = options.value("list", ""); lists && !list.empty())
        passes.passes = pass_list_from(list);
    else if (lists && !file_.passes.empty())
        passes.passes = multipass::read_passes(file_.passes);
    multipass::Options maps = passes;
    if (subject.renderer.passes)
        maps.passes = apps::pass_list(subject.renderer, subject.scene, subject.draw);
    if (multipass::has_scene_maps(subject.scene, maps))
        subject.scene = multipass::with_scene_maps(machine, subject.scene, subject.view, maps);
    return subject;
}

void LabSession::draw_scene(Machine& machine, const Json& options) const {
    const Subject subject = subject_of(machine, options);
    subject.renderer.draw(machine, subject.scene, subject.view, subject.draw);
}

void LabSession::keep_picture(Machine& machine) {
    const Planes& planes = machine.planes();
    picture_ = rgba_of(
        image::picture_of(planes.color, planes.width, planes.height, machine.profile().color_bits));
}

void LabSession::draw_again(Machine& machine, const Subject& subject, const Json& options) {
    Json key = options;
    for (const char* of_eye : {"eye", "at", "up", "fov"}) key.erase(of_eye);
    Kept& kept = drivers_[subject.renderer.name];
    if (!kept.driver || key.dump() != kept.key) {
        kept.driver.reset();
        multipass::Options passes = subject.draw.passes;
        passes.renderer = *subject.renderer.passes;
        const bool traced =
            subject.draw.traced && passes.renderer == multipass::Renderer::Multipass;
        kept.driver =
            traced ? itembuffer::make_driver(machine, subject.scene, passes, subject.draw.rays)
                   : std::make_unique<multipass::Driver>(machine, subject.scene, passes);
        kept.key = key.dump();
    }
    kept.driver->draw(subject.view);
}

bool LabSession::has_generated_maps() const {
    return std::any_of(
        file_.scene.materials.begin(), file_.scene.materials.end(), [](const scene::Material& m) {
            return std::any_of(m.refl.begin(), m.refl.end(),
                               [](const scene::Map& map) { return map.from_scene > 0; });
        });
}

Json LabSession::draw(const Json& options) {
    Machine& machine = machine_for(options);
    const Subject subject = subject_of(machine, options);
    if (subject.renderer.passes && !has_generated_maps())
        draw_again(machine, subject, options);
    else
        subject.renderer.draw(machine, subject.scene, subject.view, subject.draw);
    keep_picture(machine);
    Json passes = Json::array();
    for (const PassReport& pass : machine.passes())
        passes.push_back({{"name", pass.name}, {"counters", inspect::json_of(pass.counters)}});
    return {{"passes", passes}};
}

std::string LabSession::manifest(const Json& options) {
    machine_key_.clear();
    Machine& machine = machine_for(options);
    inspect::DigestingMachine digesting(machine);
    std::vector<CommandList> lists;
    inspect::Recorder recorder(digesting, lists);
    draw_scene(recorder, options);
    keep_picture(machine);
    inspect::Recording recording;
    recording.profile = machine.profile();
    recording.width = side(options, "width");
    recording.height = side(options, "height");
    recording.lists = std::move(lists);
    return to_json(inspect::manifest_of(recording, machine.passes()));
}

const Method methods[] = {
    {"open", &LabSession::open},
    {"draw", &LabSession::draw, {{"picture", &LabSession::picture}}},
    {"manifest", &LabSession::manifest},
};

}  // namespace gw::lab
