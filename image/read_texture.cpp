// One texture file. Does not know who asks for it.
#include "gw/error.h"
#include "image/formats.h"
#include "image/png/png.h"
#include "image/textures.h"

namespace gw::image {
namespace {

void check_file(const std::filesystem::path& file) {
    const auto refuse = [](const char* why) {
        throw Error(std::string(why) + "; expected a picture file");
    };
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) refuse("no such file");
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

}  // namespace

TextureRef read_texture(const std::filesystem::path& file) {
    check_file(file);
    const Texels texels = holds_png(file) ? read_png(file) : formats().read_texels(file);
    const auto make = [&](const auto& rgba) {
        return texture_of(file.filename().string(), texels.width, texels.height, rgba);
    };
    return std::visit(make, texels.rgba);
}

}  // namespace gw::image
