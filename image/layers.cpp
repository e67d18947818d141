#include "image/layers.h"

#include "gw/error.h"
#include "image/encode.h"
#include "image/hush.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace gw::image {

namespace {

constexpr const char* prefix = "gw:";
constexpr int largest_side = 4096;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
    throw Error(file.string(), 0, what + "; expected a whole file that this program saved");
}

OIIO::ImageSpec spec_of(const Layers& all, std::size_t index) {
    const Layer& layer = all.layers[index];
    OIIO::ImageSpec spec(layer.width, layer.height, static_cast<int>(layer.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = layer.channels;
    for (const Layer& other : all.layers) {  // parts share one display window
        spec.full_width = std::max(spec.full_width, other.width);
        spec.full_height = std::max(spec.full_height, other.height);
    }
    spec.attribute("compression", "zip");
    spec.attribute("oiio:subimagename", layer.name);
    if (index == 0)
        for (const auto& [key, value] : all.facts) spec.attribute(prefix + key, value);
    return spec;
}

OIIO::stride_t row_bytes(const Layer& layer) {
    return static_cast<OIIO::stride_t>(sizeof(float) * layer.channels.size()) * layer.width;
}

bool write_parts(OIIO::ImageOutput& output, const std::string& name, const Layers& all) {
    std::vector<OIIO::ImageSpec> specs;
    for (std::size_t i = 0; i < all.layers.size(); ++i) specs.push_back(spec_of(all, i));
    if (!output.open(name, static_cast<int>(specs.size()), specs.data())) return false;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const Layer& layer = all.layers[i];
        const auto row = row_bytes(layer);
        const char* top_row = reinterpret_cast<const char*>(layer.values.data()) + row * (layer.height - 1);
        if (i > 0 && !output.open(name, specs[i], OIIO::ImageOutput::AppendSubimage)) return false;
        if (!output.write_image(OIIO::TypeDesc::FLOAT, top_row, OIIO::AutoStride, -row)) return false;
    }
    return output.close();
}

Layer read_part(OIIO::ImageInput& input, const std::filesystem::path& file, int index, bool with_values) {
    const OIIO::ImageSpec spec = input.spec();
    if (spec.width < 1 || spec.width > largest_side || spec.height < 1 || spec.height > largest_side ||
        spec.nchannels > 64 || spec.format != OIIO::TypeDesc::FLOAT || spec.deep)
        refuse(file, "part " + std::to_string(index) + " is not a rectangle of float32 values");
    Layer layer{spec.get_string_attribute("oiio:subimagename").c_str(),
                spec.width,
                spec.height,
                spec.channelnames,
                {}};
    if (!with_values) return layer;
    layer.values.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                        layer.channels.size());
    const auto row = row_bytes(layer);
    char* top_row = reinterpret_cast<char*>(layer.values.data()) + row * (layer.height - 1);
    if (!input.read_image(index, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, top_row, OIIO::AutoStride,
                          -row))
        refuse(file, "it cannot be read to its end: " + one_line(input.geterror()));
    return layer;
}

Layers read(const std::filesystem::path& file, bool with_values) {
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        throw Error(file.string(), 0, "does not exist; expected a saved file");
    const Hush hush;
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input || std::string(input->format_name()) != "openexr") {
        OIIO::geterror();
        refuse(file, "it is no OpenEXR file");
    }
    Layers all;
    for (const auto& attribute : input->spec().extra_attribs) {
        const std::string name = attribute.name().string();
        if (name.rfind(prefix, 0) == 0) all.facts[name.substr(3)] = attribute.get_string();
    }
    for (int i = 0; input->seek_subimage(i, 0); ++i)
        all.layers.push_back(read_part(*input, file, i, with_values));
    input->geterror();  // that there is no further part
    return all;
}

}  // namespace

void put_layers(OutputFile& file, const Layers& layers) {
    const Hush hush;
    const auto output = OIIO::ImageOutput::create("openexr");
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (output) output->set_ioproxy(&memory);
    if (!output || !write_parts(*output, "saved.exr", layers))
        throw Error(file.target().string(), 0,
                    "cannot be written: " + one_line(output ? output->geterror() : OIIO::geterror()));
    file.write(bytes);
}

Layers read_layer_facts(const std::filesystem::path& file) { return read(file, false); }
Layers read_layers(const std::filesystem::path& file) { return read(file, true); }

}  // namespace gw::image
