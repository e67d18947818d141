#include "image/layers.h"

#include "gw/error.h"
#include "image/formats/encode.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace gw::image::oiio {
namespace {

constexpr const char* prefix = "gw:";
constexpr const char* order_of_channels = "gwChannels";  ///< OpenEXR sorts them
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
    leave_out_time(spec);
    spec.attribute("oiio:subimagename", layer.name);
    std::string order;
    for (const std::string& channel : layer.channels) order += channel + ' ';
    spec.attribute(order_of_channels, order);
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
        const char* top_row =
            reinterpret_cast<const char*>(layer.values.data()) + row * (layer.height - 1);
        if (i > 0 && !output.open(name, specs[i], OIIO::ImageOutput::AppendSubimage)) return false;
        if (!output.write_image(OIIO::TypeDesc::FLOAT, top_row, OIIO::AutoStride, -row))
            return false;
    }
    return output.close();
}

/// From the order of the file to the one it was saved in.
void restore_order(Layer& layer, const std::string& order) {
    std::istringstream words(order);
    const std::vector<std::string> saved{std::istream_iterator<std::string>(words), {}};
    std::vector<std::size_t> from;
    for (const std::string& channel : saved) {
        const auto found = std::find(layer.channels.begin(), layer.channels.end(), channel);
        if (found == layer.channels.end()) return;  // another program's file: as it is
        from.push_back(std::size_t(found - layer.channels.begin()));
    }
    if (from.size() != layer.channels.size()) return;
    std::vector<float> values;
    values.reserve(layer.values.size());
    for (std::size_t pixel = 0; pixel < layer.values.size(); pixel += from.size())
        for (std::size_t channel : from) values.push_back(layer.values[pixel + channel]);
    layer.values = std::move(values);
    layer.channels = saved;
}

Layer read_part(OIIO::ImageInput& input, const std::filesystem::path& file, int index,
                bool with_values) {
    const OIIO::ImageSpec spec = input.spec();
    if (spec.width < 1 || spec.width > largest_side || spec.height < 1 ||
        spec.height > largest_side || spec.nchannels > 64 || spec.format != OIIO::TypeDesc::FLOAT ||
        spec.deep)
        refuse(file, "part " + std::to_string(index) + " is not a rectangle of float32 values");
    Layer layer{spec.get_string_attribute("oiio:subimagename").c_str(),
                spec.width,
                spec.height,
                spec.channelnames,
                {}};
    if (!with_values) return layer;
    layer.values.resize(std::size_t(spec.width) * std::size_t(spec.height) * layer.channels.size());
    const auto row = row_bytes(layer);
    char* top_row = reinterpret_cast<char*>(layer.values.data()) + row * (layer.height - 1);
    if (!input.read_image(index, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, top_row,
                          OIIO::AutoStride, -row))
        refuse(file, "it cannot be read to its end: " + one_line(input.geterror()));
    restore_order(layer, spec.get_string_attribute(order_of_channels));
    return layer;
}

}  // namespace

Layers read_layers(const std::filesystem::path& file, bool with_values) {
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        throw Error(file.string(), 0, "does not exist; expected a saved file");
    const SilenceStderr silence;
    // By format, not by name: OpenImageIO reads "?" in a name as the begin of options.
    const auto input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec first;
    if (!input || !input->open(file.string(), first)) {
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

// OpenImageIO writes files of several parts by name only, and may not notice a full disk.
void put_layers(const Destination& file, const Layers& layers) {
    const auto refuse_target = [&](const std::string& why) {
        throw Error(file.target.string(), 0, "cannot be written: " + why);
    };
    if (file.temporary.empty())
        refuse_target("it is not a regular file; expected one for this format");
    {
        const SilenceStderr silence;
        const auto output = OIIO::ImageOutput::create("openexr");
        if (!output || !write_parts(*output, file.temporary.string(), layers))
            refuse_target(one_line(output ? output->geterror() : OIIO::geterror()));
    }
    try {
        if (read_layers(file.temporary, true) == layers) return;
    } catch (const Error&) {
    }
    refuse_target("the disk may be full; the written file cannot be read back");
}

}  // namespace gw::image::oiio
