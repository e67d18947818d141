// Writes the files of a report, counts their bytes and refuses to grow beyond a limit. Does not
// know their contents.
#pragma once

#include "image/picture.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace gw::report {

class ReportFolder {
public:
    /// Into a folder that exists.
    ReportFolder(std::filesystem::path folder, std::uint64_t most_bytes);

    void make_folder(const std::string& name);
    /// Throws Error if the folder would hold more than the limit, or the file cannot be written.
    void write(const std::string& name, std::string_view text);
    void append(const std::string& name, std::string_view text);
    /// A picture, as PNG.
    void write(const std::string& name, const image::Picture& picture);

    std::uint64_t bytes() const { return bytes_; }
    /// Bytes that it may still grow by.
    std::uint64_t bytes_left() const { return most_bytes_ - bytes_; }
    /// Throws Error if less is left.
    void expect_space(std::uint64_t bytes) const;

private:
    std::filesystem::path folder_;
    std::uint64_t most_bytes_, bytes_ = 0;
};

}  // namespace gw::report
