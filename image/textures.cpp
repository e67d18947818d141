#include "image/textures.h"

#include "gw/base/cancel.h"
#include "gw/error.h"
#include "image/decoder_process.h"
#include "image/memory_file.h"
#include "image/png.h"
#include "scene/text/number.h"
#include "scene/text/text_file.h"

#include <map>

namespace gw::image {
namespace {

void check_file(const std::filesystem::path& file) {
    const auto refuse = [](const char* why) {
        throw Error(std::string(why) + "; expected a picture file");
    };
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!scene::file_exists(file)) refuse("no such file");
    if (std::filesystem::is_directory(status)) refuse("it is a folder");
    if (!std::filesystem::is_regular_file(status)) refuse("it is not a regular file");
}

TextureRef texture_of(std::string name, int width, int height,
                      const std::vector<std::uint8_t>& rgba) {
    return make_texture8(std::move(name), width, height, rgba);
}
TextureRef texture_of(std::string name, int width, int height,
                      const std::vector<std::uint16_t>& rgba) {
    return make_texture(std::move(name), width, height, rgba);
}

struct Loaded {
    TextureRef texture;
    float largest = 1;
};
using Cache = std::map<std::filesystem::path, Loaded>;

std::filesystem::path key_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto real = std::filesystem::canonical(file, error);
    return error ? file : real;
}

/// `name` is the texture's.
Loaded read_texture(const std::filesystem::path& file, const std::string& name,
                    DecoderProcess& decoder) {
    check_file(file);
    const Texels texels = holds_png(file) ? read_png(file) : decoder.read(file);
    const auto make = [&](const auto& rgba) {
        return texture_of(name, texels.width, texels.height, rgba);
    };
    return {std::visit(make, texels.rgba), texels.largest};
}

Loaded read_texture(const scene::Map& map, DecoderProcess& decoder) {
    const std::string name = map.file.filename().string();
    if (!map.bytes) return read_texture(map.file, name, decoder);
    const MemoryFile inner(*map.bytes);
    return read_texture(inner.path(), name, decoder);
}

class Loader {
public:
    void load(scene::Map& map, std::string_view statement) {
        if (map.texture || map.from_scene > 0) return;
        const auto [found, is_new] = cache_.try_emplace(key_of(map.file));
        const std::string what = named_in_file(map, statement) + ": ";
        try {
            if (is_new) found->second = read_texture(map, decoder_);
        } catch (const Error& error) {
            throw Error(map.origin.file, map.origin.line, what + error.what());
        }
        map.texture = found->second.texture;
        if (is_new && found->second.largest > 1)
            warnings.push_back(at_line(map.origin.file, map.origin.line,
                                       what + largest_text(found->second.largest)));
    }
    std::vector<std::string> warnings;

private:
    static std::string named_in_file(const scene::Map& map, std::string_view statement) {
        const std::string place = map.place.empty() ? std::string(statement) : map.place;
        return map.bytes ? place : place + " " + map.file.string();
    }
    static std::string largest_text(float largest) {
        return "has values to " + scene::number_text(double(largest)) +
               "; expected 0 to 1, to which they are clamped";
    }
    Cache cache_;
    DecoderProcess decoder_;
};

}  // namespace

TextureRef read_texture(const std::filesystem::path& file) {
    DecoderProcess decoder;
    return read_texture(file, file.filename().string(), decoder).texture;
}

std::vector<std::string> load_textures(scene::Scene& scene) {
    Loader loader;
    for (scene::Material& material : scene.materials) {
        const std::pair<std::string_view, std::vector<scene::Map>*> lists[] = {
            {"map_Ka", &material.map_Ka}, {"map_Kd", &material.map_Kd},
            {"map_Ks", &material.map_Ks}, {"map_Ke", &material.map_Ke},
            {"refl", &material.refl},     {"refraction", &material.refraction},
            {"map_d", &material.map_d},   {"metallicRoughnessTexture", &material.map_metal},
        };
        for (const auto& [statement, maps] : lists)
            for (scene::Map& map : *maps) {
                end_if_canceled();
                loader.load(map, statement);
            }
    }
    return std::move(loader.warnings);
}

}  // namespace gw::image
