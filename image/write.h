// Writes pictures and planes to files, in any format that OpenImageIO writes; the
// extension chooses. Changes only the number of bits of a value. Files have their top row first, as
// formats demand.
#pragma once

#include "image/output/output_file.h"
#include "image/picture.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace gw::image {

/// The fault of a picture's extension, with the usual extensions; "" if OpenImageIO writes such
/// files. Throws Error if OpenImageIO cannot be loaded.
std::string extension_fault(const std::filesystem::path& file);

/// Writes a picture of n bits. 8 bits are unchanged if the format stores 8 or more; otherwise each
/// value becomes the nearest one of the bits stored (12 bits in 16: v 65535/4095). EXR and HDR hold
/// v / (2^n - 1): EXR as half for n <= 8, which keeps every value distinct, else as float. JPEG,
/// WebP, GIF and HEIC are lossy.
void put_picture(OutputFile& file, const Picture& picture);

/// Writes a whole file. Throws Error; then the target is as it was before.
void write_picture(const std::filesystem::path& file, const Picture& picture);

/// The values of a plane, unchanged: 32-bit integers or floats, interleaved, bottom row first; one
/// name per channel.
struct Values {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::variant<std::vector<std::uint32_t>, std::vector<float>> values;
};

/// To OpenEXR (UINT or FLOAT channels), lossless.
void put_values(OutputFile& file, const Values& values);

/// "2.4.7.1"
std::string library_version();

}  // namespace gw::image
