// A part of a picture as a file: its rows of the frame buffer, and the facts by which parts of one
// picture know each other. docs/many_machines.md has the format. Does not draw.
#pragma once

#include "gw/base/types.h"
#include "render/words/option_values.h"
#include "scene/draw/view.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gw::apps {

/// "2/7": part 2 of 7. Part 1 is the top of the picture.
struct Share {
    int part = 1, of = 1;
    bool operator==(const Share&) const = default;
};
/// Throws UsageError unless 1 <= part <= of.
Share share_from(const std::string& option, const std::string& word);
std::string to_string(const Share& share);
/// At least one row if the picture has `of` rows.
scene::Rows rows_of(const Share& share, int height);

struct Part {
    std::filesystem::path file;  ///< for errors; not in the file
    std::string version;         ///< of gw
    std::string scene;           ///< digest of all files that were read
    Share share;
    render::Size size;  ///< of the whole picture
    int bits = 8;       ///< of a channel, as the frame buffer has it
    /// Names and words of the options that change pixels, in the order of help.
    std::vector<std::pair<std::string, std::string>> options;
    std::vector<Rgba> color;  ///< its rows, bottom row first
};

std::string encode(const Part& part);
/// Throws Error with the file's name if the bytes are no whole part.
Part decode_part(const std::filesystem::path& file, std::string_view bytes);

/// The colours of the whole picture. Throws Error if a part is missing, given twice, or of another
/// picture. `parts` has at least one.
std::vector<Rgba> joined(const std::vector<Part>& parts);

}  // namespace gw::apps
