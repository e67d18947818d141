#include "scene/gltf/write_gltf.h"

#include "gw/base/elementary.h"
#include "scene/draw/view.h"

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstdint>
#include <map>
#include <utility>

namespace gw::scene {
namespace {

using Json = nlohmann::ordered_json;

enum : int {
    Float = 5126,
    ArrayBuffer = 34962,
    Linear = 9729,
    LinearMipmapLinear = 9987,
    Repeat = 10497,
    ClampToEdge = 33071,
    MirroredRepeat = 33648
};

int wrap_of(Wrap wrap) {
    return wrap == Wrap::Repeat           ? Repeat
           : wrap == Wrap::MirroredRepeat ? MirroredRepeat
                                          : ClampToEdge;
}

Json extras_of(const WrittenPicture& picture) {
    Json extras{{"exact", picture.exact}, {"scale", picture.scale}};
    if (!picture.rgbm.empty()) {
        extras["rgbm"] = picture.rgbm;
        extras["range"] = picture.range;
    }
    return extras;
}

class Writer {
public:
    explicit Writer(const WrittenScene& scene) : scene_(scene) {}

    GltfText write(const std::string& buffer) {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "gw"}}},
                 {"extensionsUsed", Json::array({"KHR_materials_unlit"})},
                 {"scene", 0}};
        add_pictures();
        for (const WrittenMesh& mesh : scene_.meshes) add_mesh(mesh);
        if (scene_.camera) add_camera(*scene_.camera);
        Json roots = Json::array();
        for (std::size_t i = 0; i < json_["nodes"].size(); ++i) roots.push_back(i);
        json_["scenes"].push_back({{"nodes", roots}});
        json_["buffers"].push_back({{"uri", buffer}, {"byteLength", bytes_.size()}});
        return {json_.dump(1) + "\n", std::move(bytes_)};
    }

private:
    void add_pictures() {
        json_["samplers"].push_back({{"magFilter", int(Linear)},
                                     {"minFilter", int(Linear)},
                                     {"wrapS", int(ClampToEdge)},
                                     {"wrapT", int(ClampToEdge)}});
        for (const WrittenPicture& picture : scene_.pictures) add_picture(picture.file, 0);
        for (const WrittenTexture& texture : scene_.textures) {
            json_["samplers"].push_back({{"magFilter", int(Linear)},
                                         {"minFilter", int(LinearMipmapLinear)},
                                         {"wrapS", wrap_of(texture.wrap_s)},
                                         {"wrapT", wrap_of(texture.wrap_t)}});
            add_picture(texture.file, json_["samplers"].size() - 1);
        }
    }

    void add_picture(const std::string& file, std::size_t sampler) {
        json_["images"].push_back({{"uri", file}});
        json_["textures"].push_back({{"sampler", sampler}, {"source", json_["images"].size() - 1}});
    }

    /// One for each pair of picture and texture.
    std::size_t material_of(const WrittenMesh& mesh) {
        const auto [place, is_new] =
            materials_.try_emplace({mesh.picture, mesh.texture}, materials_.size());
        if (!is_new) return place->second;
        const WrittenPicture& picture = scene_.pictures[mesh.picture];
        Json extras = extras_of(picture);
        std::string name = picture.file;
        if (mesh.texture) {
            const WrittenTexture& own = scene_.textures[*mesh.texture];
            extras["own"] = {{"index", scene_.pictures.size() + *mesh.texture},
                             {"texCoord", 0},
                             {"mean", Json::array({own.mean.x, own.mean.y, own.mean.z})}};
            name += ", " + own.file;
        }
        json_["materials"].push_back(
            {{"name", name},
             {"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", mesh.picture}, {"texCoord", 1}}},
               {"metallicFactor", 0}}},
             {"extensions", {{"KHR_materials_unlit", Json::object()}}},
             {"extras", extras}});
        return place->second;
    }

    void add_mesh(const WrittenMesh& mesh) {
        const Json attributes = {{"POSITION", add_positions(mesh.positions)},
                                 {"TEXCOORD_0", add_texcoords(mesh.texcoord_0)},
                                 {"TEXCOORD_1", add_texcoords(mesh.texcoord_1)}};
        json_["nodes"].push_back({{"name", mesh.name}, {"mesh", json_["meshes"].size()}});
        const Json primitive = {{"attributes", attributes}, {"material", material_of(mesh)}};
        json_["meshes"].push_back({{"name", mesh.name}, {"primitives", Json::array({primitive})}});
    }

    std::size_t add_positions(const std::vector<vec3>& positions) {
        vec3 low = positions.front(), high = low;
        std::vector<float> numbers;
        for (const vec3& p : positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
            numbers.insert(numbers.end(), {p.x, p.y, p.z});
        }
        const std::size_t accessor = add_numbers(numbers, "VEC3", positions.size());
        json_["accessors"][accessor]["min"] = Json::array({low.x, low.y, low.z});
        json_["accessors"][accessor]["max"] = Json::array({high.x, high.y, high.z});
        return accessor;
    }

    /// t grows downwards in the file.
    std::size_t add_texcoords(const std::vector<vec2>& texcoords) {
        std::vector<float> numbers;
        for (const vec2& st : texcoords) numbers.insert(numbers.end(), {st.x, 1 - st.y});
        return add_numbers(numbers, "VEC2", texcoords.size());
    }

    std::size_t add_numbers(const std::vector<float>& numbers, const char* type,
                            std::size_t count) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", bytes_.size()},
                                        {"byteLength", numbers.size() * 4},
                                        {"target", int(ArrayBuffer)}});
        for (const float number : numbers) {
            const auto bits = std::bit_cast<std::uint32_t>(number);
            for (int shift = 0; shift < 32; shift += 8) bytes_ += char(bits >> shift & 255);
        }
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", int(Float)},
                                      {"count", count},
                                      {"type", type}});
        return json_["accessors"].size() - 1;
    }

    void add_camera(const Camera& camera) {
        Json lens = {{"znear", camera.near_plane}, {"zfar", camera.far_plane}};
        const bool parallel = camera.ortho_height > 0;
        if (parallel) {
            lens["ymag"] = camera.ortho_height / 2;
            lens["xmag"] = camera.ortho_height / 2 * scene_.aspect;
        } else {
            lens["yfov"] = camera.fov * pi / 180;
            lens["aspectRatio"] = scene_.aspect;
        }
        const char* type = parallel ? "orthographic" : "perspective";
        json_["cameras"].push_back({{"type", type}, {type, lens}});
        const dmat4 eye_from_world = look_at(camera.eye, camera.at, camera.up);
        Json matrix = Json::array();
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) matrix.push_back(eye_from_world[row][column]);
            matrix.push_back(0);
        }
        for (const double v : {camera.eye.x, camera.eye.y, camera.eye.z, 1.0}) matrix.push_back(v);
        json_["nodes"].push_back({{"name", "camera"}, {"camera", 0}, {"matrix", matrix}});
    }

    const WrittenScene& scene_;
    std::map<std::pair<std::size_t, std::optional<std::size_t>>, std::size_t> materials_;
    Json json_;
    std::string bytes_;
};

}  // namespace

GltfText write_gltf(const WrittenScene& scene, const std::string& buffer) {
    return Writer(scene).write(buffer);
}

}  // namespace gw::scene
