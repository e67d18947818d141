#include "image/write.h"

#include "gw/error.h"
#include "image/formats.h"
#include "image/png.h"

#include <OpenImageIO/oiioversion.h>

namespace gw::image {

std::string extension_fault(const std::filesystem::path& file) {
    if (is_png_name(file) || !formats().format_of(file).empty()) return "";
    const std::string extension = file.extension().string();
    return (extension.empty() ? "has no extension"
                              : "no picture format has the extension " + extension) +
           "; expected .png, .exr, .tif, .jpg, .ppm, .tga or another that OpenImageIO writes";
}

namespace {

void check_extension(const std::filesystem::path& file) {
    const std::string fault = extension_fault(file);
    if (!fault.empty()) throw Error(file.string(), 0, fault);
}

}  // namespace

void put_picture(OutputFile& file, const Picture& picture) {
    check_extension(file.target());
    if (is_png_name(file.target())) return put_png(file, picture);
    formats().put_picture(destination(file), picture);
}

void write_picture(const std::filesystem::path& file, const Picture& picture) {
    check_extension(file);
    OutputFile output(file);
    put_picture(output, picture);
    output.commit();
}

std::string library_version() { return OIIO_VERSION_STRING; }

}  // namespace gw::image
