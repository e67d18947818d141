// What a picture depends on, as words: its options and a digest of the files that were read. Pictures with
// the same words have the same bits. Does not draw.
#pragma once

#include "render/request.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

/// A digest of all contents, in the order in which the files were read.
std::string digest_of_files(const std::vector<std::filesystem::path>& files);

/// Names and words of the options that change pixels, but for the size, in the order of help.
std::vector<std::pair<std::string, std::string>> words_of(const render::Request& request);

}  // namespace gw::apps
