#include "image/textures.h"

#include "gw/base/cancel.h"
#include "gw/error.h"
#include "image/decoder_process.h"
#include "image/memory_file.h"
#include "image/png.h"
#include "scene/maps/map_lists.h"
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
        if (map.may_lack && !scene::file_exists(map.file)) return;
        const auto [found, is_new] = cache_.try_emplace(key_of(map.file));
        const std::string what = scene::map_words(map, statement) + ": ";
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
    for (scene::Material& material : scene.materials)
        for_each_map_list(material, [&](std::string_view statement, std::vector<scene::Map>& maps) {
            for (scene::Map& map : maps) {
                end_if_canceled();
                loader.load(map, statement);
            }
        });
    return std::move(loader.warnings);
}

}  // namespace gw::image
