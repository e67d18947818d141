#include "scene/toml/toml_view.h"

#include "gw/error.h"
#include "scene/geometry/far.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/text/warnings.h"
#include "scene/toml/toml_binder.h"
#include "scene/toml/toml_sections.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace gw::scene {
namespace {

/// More are a circle.
constexpr int most_bases = 16;

std::filesystem::path base_of(const std::filesystem::path& path, const TomlValue& base) {
    if (to_string(base).empty()) base.fail("base names no file; expected a scene's file name");
    const std::filesystem::path found = find_file(path.parent_path(), base.text);
    if (const std::string fault = file_fault(found); !fault.empty())
        base.fail("base '" + printable(base.text) + "' " + fault + "; expected a scene");
    return found;
}

void check_is_first(const TomlValue& file, const TomlValue& base) {
    for (const TomlValue& value : file.elements)
        if (value.line < base.line)
            base.fail("base stands behind '" + printable(value.key) +
                      "'; expected it as the first statement");
}

void check_depth(const std::filesystem::path& path, const TomlValue& base) {
    std::filesystem::path at = path;
    for (int depth = 0; is_view(at); ++depth) {
        if (depth == most_bases)
            base.fail("base leads to more than " + std::to_string(most_bases) +
                      " views; expected a scene that is no view");
        const TomlValue file = read_toml_file(at);
        at = base_of(at, *file.find("base"));
    }
}

std::set<std::size_t> to_places(const TomlValue& value, std::size_t count) {
    if (value.kind != TomlKind::Array) value.fail_expected("an array of lights' numbers");
    std::set<std::size_t> places;
    for (const TomlValue& element : value.elements) {
        if (count == 0) value.fail("lights_off: the base has no lights; expected none here");
        places.insert(std::size_t(to_int(element, {1, double(count)})) - 1);
    }
    return places;
}

std::string text_of(const dvec3& v) {
    return "[" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + "]";
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + "\"";
}

std::string camera_text(const Camera& camera) {
    std::string text = "\n[camera]\neye = " + text_of(camera.eye) + "\nat = " + text_of(camera.at) +
                       "\nup = " + text_of(camera.up) + "\nfov = " + number_text(camera.fov) + "\n";
    const auto add = [&](const char* key, double value) {
        if (value != 0) text += std::string(key) + " = " + number_text(value) + "\n";
    };
    add("near", camera.near_plane);
    add("far", camera.far_plane);
    add("ortho", camera.ortho_height);
    add("aperture", camera.aperture);
    add("focus", camera.focus);
    return text;
}

std::string light_text(const Light& light) {
    return "\n[[light]]\nname = " + quoted(light.name) +
           "\ndirection = " + text_of(dvec3(light.direction)) +
           "\nIa = " + text_of(dvec3(light.Ia)) + "\nId = " + text_of(dvec3(light.Id)) +
           "\nIs = " + text_of(dvec3(light.Is.value_or(light.Id))) + "\n";
}

/// The base's film moves the base's camera and lights: the view's own stay, and lights that are off
/// are off at all times.
void keep_view(Film& film, const std::vector<Light>& base_lights, const std::set<std::size_t>& off,
               bool own_camera) {
    film.pose = [base_lights, off, own_camera, pose = film.pose](Scene& scene, double time) {
        const std::optional<Camera> camera = scene.camera;
        std::vector<Light> shown = std::exchange(scene.lights, base_lights);
        std::vector<std::size_t> places;  // in the base, of the first of those shown
        for (std::size_t i = 0; i < base_lights.size(); ++i)
            if (!off.contains(i)) places.push_back(i);
        for (std::size_t k = 0; k < places.size(); ++k) scene.lights[places[k]] = shown[k];
        pose(scene, time);
        for (std::size_t k = 0; k < places.size(); ++k) shown[k] = scene.lights[places[k]];
        scene.lights = std::move(shown);
        if (own_camera) scene.camera = camera;
    };
}

}  // namespace

bool is_view(const std::filesystem::path& path) {
    if (path.extension() != ".toml" || !file_fault(path).empty()) return false;
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        const auto first = line.find_first_not_of(" \t\r\xEF\xBB\xBF");
        if (first == line.npos || line[first] == '#') continue;
        const auto end = line.find_first_of(" \t=", first);
        return line.substr(first, end - first) == "base" && line.find('=', first) != line.npos;
    }
    return false;
}

SceneFile read_view(const std::filesystem::path& path, const TomlValue& file) {
    const TomlValue& base = *file.find("base");
    check_is_first(file, base);
    check_depth(path, base);
    SceneFile result = read_scene(base_of(path, base));
    Scene& scene = result.scene;
    scene.name = path.stem().string();
    std::set<std::size_t> off;
    std::vector<Light> added;
    Warnings warnings;
    bool fog = true;
    const std::vector<Light> base_lights = scene.lights;
    read_table(
        file, {
                  {"base", [](const TomlValue&) {}},
                  key("name", scene.name),
                  {"camera",
                   [&](const TomlValue& value) {
                       scene.camera = to_camera(value);
                       count_from(*scene.camera, result.origin);
                   }},
                  {"fog",
                   [&](const TomlValue& value) {
                       if (value.kind == TomlKind::Boolean)
                           fog = value.boolean;
                       else
                           scene.fog = to_fog(value, warnings);
                   }},
                  {"lights_off",
                   [&](const TomlValue& value) { off = to_places(value, scene.lights.size()); }},
                  {"light",
                   [&](const TomlValue& value) {
                       if (value.kind != TomlKind::Array) value.fail_expected("[[light]]");
                       for (const TomlValue& light : value.elements)
                           added.push_back(to_light(light, {scene.white, warnings, result.origin}));
                   }},
                  {"picture",
                   [&](const TomlValue& value) {
                       if (value.kind != TomlKind::Table) value.fail_expected("[picture]");
                   }},
              });
    if (!fog) scene.fog.reset();
    switch_off(scene, off);
    scene.lights.insert(scene.lights.end(), added.begin(), added.end());
    for (Film& film : result.films)
        keep_view(film, base_lights, off, file.find("camera") != nullptr);
    result.files.insert(result.files.begin(), path);
    for (const std::string& line : warnings.lines()) result.warnings.push_back(line);
    for (const std::filesystem::path& read : warnings.files()) result.files.push_back(read);
    return result;
}

std::vector<SavedOption> saved_options(const std::filesystem::path& path) {
    std::vector<SavedOption> options;
    std::filesystem::path at = path;
    for (int depth = 0; depth < most_bases && is_view(at); ++depth) {
        const TomlValue file = read_toml_file(at);
        if (const TomlValue* picture = file.find("picture"))
            for (const TomlValue& value : picture->elements) {
                if (value.kind != TomlKind::String && !value.is_number())
                    value.fail_expected("a word or a number");
                options.push_back({value.key, value.text, {at.string(), value.line}});
            }
        const TomlValue* base = file.find("base");
        if (!base) break;
        at = base_of(at, *base);
    }
    return options;
}

void switch_off(Scene& scene, const std::set<std::size_t>& lights) {
    std::vector<Light> left;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (!lights.contains(i)) left.push_back(scene.lights[i]);
    if (left.empty() && !scene.lights.empty())
        left.push_back({.name = "none", .Id = vec3(0), .Is = vec3(0)});
    scene.lights = std::move(left);
}

std::string to_toml(const SavedView& view) {
    std::string text = "base = " + quoted(view.base.generic_string()) + "\n";
    if (!view.fog) text += "fog = false\n";
    if (!view.lights_off.empty()) {
        std::string numbers;
        for (const std::size_t place : view.lights_off)
            numbers += (numbers.empty() ? "" : ", ") + std::to_string(place + 1);
        text += "lights_off = [" + numbers + "]\n";
    }
    text += camera_text(view.camera);
    if (view.light) text += light_text(*view.light);
    if (!view.options.empty()) text += "\n[picture]\n";
    for (const auto& [name, word] : view.options) text += name + " = " + quoted(word) + "\n";
    return text;
}

}  // namespace gw::scene
