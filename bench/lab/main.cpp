// The frames that the lab's benchmark draws by WebGL, as JSON: meshes, textures, and the commands of
// one frame with the part of the state that these frames use. Does not draw.
// Usage: bench_lab_frames SCENE RENDERER WIDTH HEIGHT > FRAME.json
#include "image/textures.h"
#include "multipass/frame/driver.h"
#include "scene/draw/fit.h"
#include "scene/toml/read_scene.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace gw::bench {
namespace {

using Json = nlohmann::ordered_json;

/// The floats of vectors, one after another.
template <class Vector>
Json numbers_of(const std::vector<Vector>& vectors) {
    Json numbers = Json::array();
    for (const Vector& v : vectors)
        for (int i = 0; i < Vector::length(); ++i) numbers.push_back(v[i]);
    return numbers;
}

Json json_of(const vec3& v) { return {v.x, v.y, v.z}; }
Json json_of(const vec4& v) { return {v.x, v.y, v.z, v.w}; }
/// By columns, as WebGL has them.
Json json_of(const dmat4& m) {
    Json values = Json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) values.push_back(m[column][row]);
    return values;
}

Json json_of(const Mesh& mesh) {
    const MeshData& data = mesh.data();
    if (mesh.kind() != MeshKind::Triangles || !data.colors.empty() || !data.materials.empty())
        throw std::runtime_error("a mesh has more than triangles, normals and texture coordinates");
    std::vector<std::uint32_t> indices;
    for (const Triangle& t : mesh.triangles())
        indices.insert(indices.end(), t.vertex.begin(), t.vertex.end());
    std::vector<vec4> positions;
    for (std::size_t i = 0; i < data.positions.size(); ++i)
        positions.emplace_back(data.positions[i], data.w.empty() ? 1.0f : data.w[i]);
    return {{"positions", numbers_of(positions)},
            {"normals", numbers_of(data.normals)},
            {"texcoords", numbers_of(data.texcoords)},
            {"indices", indices}};
}

Json json_of(const Texture& texture) {
    std::vector<std::uint8_t> rgba;
    for (const std::uint16_t v : texture.levels.front().rgba) rgba.push_back(std::uint8_t(v >> 8));
    return {{"width", texture.width()}, {"height", texture.height()}, {"rgba", rgba}};
}

Json json_of(const StencilFace& f) {
    return {{"func", f.func},
            {"ref", f.ref},
            {"mask", f.mask},
            {"fail", f.fail},
            {"zfail", f.zfail},
            {"zpass", f.zpass},
            {"write_mask", f.write_mask}};
}

/// Enumerations are numbers in the order of gw/state.h.
Json json_of(const State& s) {
    if (s.alpha.test || s.logic_op.enable || s.scissor.test || s.fog.enable ||
        s.polygon_offset.enable)
        throw std::runtime_error("the frame uses a state that the WebGL page does not draw");
    return {{"projection", json_of(s.projection)},
            {"cull", {{"enable", s.cull.enable}, {"face", s.cull.face}, {"front", s.cull.front}}},
            {"color_source", s.color_source},
            {"local_viewer", s.lighting.local_viewer},
            {"two_side", s.lighting.two_side},
            {"model_ambient", json_of(s.lighting.model_ambient)},
            {"depth", {{"test", s.depth.test}, {"func", s.depth.func}, {"mask", s.depth.mask}}},
            {"blend",
             {{"enable", s.blend.enable},
              {"src", s.blend.src},
              {"dst", s.blend.dst},
              {"equation", s.blend.equation}}},
            {"stencil",
             {{"test", s.stencil.test},
              {"front", json_of(s.stencil.front())},
              {"back", json_of(s.stencil.two_side ? s.stencil.back : s.stencil.front())}}},
            {"color_mask", {s.color_mask.r, s.color_mask.g, s.color_mask.b, s.color_mask.a}},
            {"texture",
             {{"min_filter", s.texture.min_filter},
              {"mag_filter", s.texture.mag_filter},
              {"wrap_s", s.texture.wrap_s},
              {"wrap_t", s.texture.wrap_t},
              {"env", s.texture.env},
              {"gen", s.texture.gen},
              {"matrix", json_of(s.texture.matrix)}}}};
}

Json json_of(const Light& light) {
    return {{"position", json_of(light.position)},
            {"Ia", json_of(light.Ia)},
            {"Id", json_of(light.Id)},
            {"Is", json_of(light.Is)},
            {"attenuation",
             {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation}}};
}

/// Each mesh and texture once, by its number in the order of first use.
struct Writer {
    Json meshes = Json::array(), textures = Json::array(), commands = Json::array();
    std::map<const void*, std::size_t> numbers;

    template <class Ref>
    std::size_t number(Json& list, const Ref& ref) {
        const auto [at, added] = numbers.emplace(ref.get(), list.size());
        if (added) list.push_back(json_of(*ref));
        return at->second;
    }
    void operator()(const BeginPass&) {}
    void operator()(const Clear& c) {
        commands.push_back({{"clear",
                             {{"planes", c.planes},
                              {"color", json_of(c.color)},
                              {"depth", c.depth},
                              {"stencil", c.stencil}}}});
    }
    void operator()(const SetState& set) { commands.push_back({{"state", json_of(set.state)}}); }
    void operator()(const Draw& d) {
        Json lights = Json::array();
        if (d.lights)
            for (const Light& light : *d.lights) lights.push_back(json_of(light));
        const Material& m = d.material;
        Json draw{{"mesh", number(meshes, d.mesh)},
                  {"eye_from_object", json_of(d.eye_from_object)},
                  {"material",
                   {{"Ka", json_of(m.Ka)},
                    {"Kd", json_of(m.Kd)},
                    {"Ks", json_of(m.Ks)},
                    {"Ke", json_of(m.Ke)},
                    {"Ns", m.Ns},
                    {"alpha", m.alpha}}},
                  {"lights", lights}};
        if (d.current) draw["color"] = json_of(d.current->color);
        if (d.map.texture) draw["texture"] = number(textures, d.map.texture);
        commands.push_back({{"draw", draw}});
    }
    void operator()(const auto&) {
        throw std::runtime_error("the frame has a command that the WebGL page does not draw");
    }
};

void write(const std::string& path, const std::string& renderer, int width, int height) {
    scene::Scene scene = scene::read_scene(path).scene;
    image::load_textures(scene);
    scene::add_defaults(scene, width, height);
    const scene::View view = scene::make_view(scene, width, height);
    const auto passes =
        multipass::passes_for(scene, renderer == "hardware" ? multipass::Renderer::Hardware
                                                            : multipass::Renderer::Multipass);
    Writer writer;
    for (const Command& c : multipass::frame_list(scene, view, passes, scene.background).commands)
        std::visit(writer, c);
    std::cout << Json{{"width", width},
                      {"height", height},
                      {"eye_from_world", json_of(view.eye_from_world)},
                      {"at", {scene.camera->at.x, scene.camera->at.y, scene.camera->at.z}},
                      {"meshes", writer.meshes},
                      {"textures", writer.textures},
                      {"commands", writer.commands}}
              << '\n';
}

}  // namespace
}  // namespace gw::bench

int main(int count, char** arguments) {
    CLI::App app{"Writes the frame of a scene for WebGL, as JSON, to standard output"};
    std::string path, renderer;
    int width = 0, height = 0;
    app.add_option("scene", path, "scene file")->required()->check(CLI::ExistingFile);
    app.add_option("renderer", renderer, "hardware or multipass")
        ->required()
        ->check(CLI::IsMember({"hardware", "multipass"}));
    app.add_option("width", width, "pixels")->required()->check(CLI::Range(1, 4096));
    app.add_option("height", height, "pixels")->required()->check(CLI::Range(1, 4096));
    CLI11_PARSE(app, count, arguments);
    try {
        gw::bench::write(path, renderer, width, height);
    } catch (const std::exception& error) {
        std::cerr << "bench_lab_frames: " << error.what() << '\n';
        return 1;
    }
}
