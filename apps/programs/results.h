// Reads the files that the libraries of gl/ write: statistics and the shown picture.
#pragma once

#include "image/picture.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace gw::apps {

/// A folder among the system's temporary files, removed with its content.
class ScratchFolder {
public:
    /// Throws Error if there can be none.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// "" if there is no such file.
std::string bytes_of_file(const std::filesystem::path& file);

/// The number of frames at the beginning of the statistics; 0 if there is none.
std::uint64_t frames_in(const std::string& statistics);

/// The picture that gl/record/screenshot.h writes. Throws Error if it is another file.
image::Picture picture_of_ppm(const std::string& bytes);

}  // namespace gw::apps
