// Several rectangles of float32 values with a text of facts, as one OpenEXR file of several parts;
// and back, bit for bit. Does not interpret the values.
#pragma once

#include "image/output/output_file.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gw::image {

struct Layer {
    std::string name;
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> values;  ///< interleaved, bottom row first
    bool operator==(const Layer&) const = default;
};

/// `facts` are attributes of the first part, readable with any tool that shows EXR headers.
struct Layers {
    std::map<std::string, std::string> facts;
    std::vector<Layer> layers;
    bool operator==(const Layers&) const = default;
};

/// Lossless. Throws Error if the file cannot be written.
void put_layers(OutputFile& file, const Layers& layers);

/// The header without values; then everything. Throws Error "file: what; expected what" if the file
/// is missing, no EXR file of such parts, or cut short.
Layers read_layer_facts(const std::filesystem::path& file);
Layers read_layers(const std::filesystem::path& file);

}  // namespace gw::image
