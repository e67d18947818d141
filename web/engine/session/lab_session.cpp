#include "web/engine/session/lab_session.h"

#include "gw/error.h"
#include "inspect/manifest/json_of.h"
#include "inspect/manifest/manifest.h"
#include "inspect/replay/forwarding_machine.h"
#include "multipass/passes/pass_toml.h"
#include "scene/maps/finish.h"
#include "scene/maps/map_lists.h"
#include "web/engine/json_point.h"
#include "web/engine/method.h"
#include "web/engine/request.h"
#include "web/engine/rgba.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace gw::lab {
namespace {

/// Of a scene that is constant or not.
template <class Scene, class Visit>
void for_each_map(Scene& scene, const Visit& visit) {
    for (auto& m : scene.materials)
        scene::for_each_map_list(m, [&](std::string_view, auto& maps) {
            for (auto& map : maps)
                if (map.from_scene == 0) visit(map);
        });
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
    finished_.reset();
    if (bits == 8) {
        pictures_[key_of(path)] = make_texture8(name, width, height, {bytes, turned.size()});
        return;
    }
    std::vector<std::uint16_t> rgba(turned.size() / 2);
    std::copy_n(bytes, turned.size(), reinterpret_cast<std::uint8_t*>(rgba.data()));
    pictures_[key_of(path)] = make_texture(name, width, height, rgba);
}

Json LabSession::open(const Json& options) {
    drawn_.clear();
    lightings_ = {};
    rays_.reset();
    caster_.reset();
    shapes_.clear();
    finished_.reset();
    file_ = scene::read_scene(options.at("path").get<std::string>());
    Json objects = Json::array(), lights = Json::array();
    for (const scene::Object& object : file_.scene.objects)
        objects.push_back(
            {{"name", object.name},
             {"material", file_.scene.materials.at(object.material).name},
             {"triangles", object.mesh ? object.mesh->data().indices.size() / 3 : 0}});
    for (const scene::Light& light : file_.scene.lights) lights.push_back(light.name);
    std::set<std::string> pictures, embedded;
    for_each_map(file_.scene, [&](const scene::Map& map) {
        (map.bytes ? embedded : pictures).insert(key_of(map.file));
    });
    const render::Drawing shown =
        render::make_drawing({.size = {320, 240}}, vgx(), {.scene = file_.scene});
    const scene::Camera seen = *shown.scene.camera;
    std::vector<std::string> warnings = file_.warnings;
    for (const std::string& line : render::warnings(shown)) warnings.push_back(line);
    return {{"name", file_.scene.name}, {"warnings", warnings},   {"objects", objects},
            {"lights", lights},         {"pictures", pictures},   {"embedded", embedded},
            {"eye", json_of(seen.eye)}, {"at", json_of(seen.at)}, {"up", json_of(seen.up)},
            {"fov", seen.fov}};
}

Json LabSession::embedded(const Json& options) {
    const auto path = options.at("path").get<std::string>();
    std::shared_ptr<const std::string> bytes;
    for_each_map(file_.scene, [&](const scene::Map& map) {
        if (map.bytes && key_of(map.file) == path) bytes = map.bytes;
    });
    if (!bytes) throw Error(path + " lies in no file of the scene");
    picture_.assign(bytes->begin(), bytes->end());
    return Json::object();
}

scene::Scene LabSession::scene_for(const Json& options) const {
    return render::scene_for(request_of(options), {.scene = finished().scene});
}

scene::View LabSession::view_of(const scene::Scene& scene, const Json& options) const {
    const render::Size size = request_of(options).size;
    return scene::make_view(scene, size.width, size.height);
}

Machine& LabSession::machine_for(const Json& options) {
    const render::Request request = request_of(options);
    const std::string key =
        Json{request.machine, request.profile, request.size.width, request.size.height}.dump();
    if (key != machine_key_) {
        machine_key_.clear();
        drawn_.clear();
        rays_.reset();
        machine_.reset();
        machine_ = render::make_machine(request, render::load_profile(request));
        machine_key_ = key;
    }
    machine_->reset_passes();
    return *machine_;
}

const LabSession::Finished& LabSession::finished() const {
    if (finished_) return *finished_;
    Finished made{file_.scene, {}};
    for_each_map(made.scene, [&](scene::Map& map) {
        const auto found = pictures_.find(key_of(map.file));
        if (found != pictures_.end()) map.texture = found->second;
    });
    scene::Warnings warnings;
    scene::finish(made.scene, warnings);
    made.warnings = warnings.lines();
    finished_ = std::move(made);
    return *finished_;
}

Json LabSession::finish(const Json&) { return {{"warnings", finished().warnings}}; }

void LabSession::check_pictures() const {
    for_each_map(file_.scene, [&](const scene::Map& map) {
        if (!map.texture && !map.may_lack && !pictures_.contains(key_of(map.file)))
            throw Error(map.origin.file, map.origin.line,
                        map.file.string() + " is not here; expected it beside the scene");
    });
}

render::Drawing LabSession::drawing_of(const Json& options) const {
    const render::Request request = request_of(options);
    std::optional<multipass::PassList> passes;
    if (const std::string list = options.value("list", ""); !list.empty())
        passes = pass_list_from(list);
    else if (!file_.passes.empty())
        passes = multipass::read_passes(file_.passes);
    check_pictures();
    return render::make_drawing(request, render::load_profile(request),
                                {.scene = finished().scene, .passes = std::move(passes)});
}

void LabSession::keep_picture(Machine& machine) {
    const Planes& planes = machine.planes();
    picture_ = rgba_of(
        image::picture_of(planes.color, planes.width, planes.height, machine.profile().color_bits));
}

std::vector<std::string> LabSession::draw_again(Machine& machine, const Json& options) {
    Json key = options;
    for (const char* of_eye : {"eye", "at", "up", "fov"}) key.erase(of_eye);
    render::Drawing drawing = drawing_of(options);
    const scene::View view = drawing.view();
    Drawn& drawn = drawn_[drawing.request.renderer];
    if (!drawn.draw || key.dump() != drawn.key) {
        drawn.draw = nullptr;
        drawn.warnings = render::warnings(drawing);
        drawn.drawing = std::make_unique<render::Drawing>(std::move(drawing));
        drawn.draw = render::view_drawer(*drawn.drawing, machine);
        drawn.key = key.dump();
    }
    drawn.draw(view);
    std::vector<std::string> warnings = drawn.warnings;
    const std::string empty = render::empty_warning(*drawn.drawing, machine);
    if (!empty.empty()) warnings.push_back(empty);
    return warnings;
}

Json LabSession::draw(const Json& options) {
    Machine& machine = machine_for(options);
    const std::vector<std::string> warnings = draw_again(machine, options);
    keep_picture(machine);
    Json passes = Json::array();
    for (const PassReport& pass : machine.passes())
        passes.push_back({{"name", pass.name}, {"counters", inspect::json_of(pass.counters)}});
    return {{"passes", passes}, {"warnings", warnings}};
}

std::string LabSession::manifest(const Json& options) {
    machine_key_.clear();
    Machine& machine = machine_for(options);
    inspect::DigestingMachine digesting(machine);
    const render::Drawing drawing = drawing_of(options);
    inspect::Recording recording{.profile = drawing.profile,
                                 .width = drawing.request.size.width,
                                 .height = drawing.request.size.height};
    inspect::Recorder recorder(digesting, recording.lists);
    render::draw(drawing, drawing.view(), recorder);
    keep_picture(machine);
    return to_json(inspect::manifest_of(recording, machine.passes()));
}

const Method session_methods[] = {
    {"open", &LabSession::open},
    {"embedded", &LabSession::embedded, {{"picture", &LabSession::picture}}},
    {"finish", &LabSession::finish},
    {"draw", &LabSession::draw, {{"picture", &LabSession::picture}}},
    {"manifest", &LabSession::manifest},
};

}  // namespace gw::lab
