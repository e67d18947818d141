// The files of a report, under way: counts their bytes and refuses to grow beyond a limit.
// Does not know what is in them.
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
    /// Throws Error where the folder would hold more than the limit, or the file cannot be written.
    void write(const std::string& name, std::string_view text);
    void append(const std::string& name, std::string_view text);
    /// A picture, as PNG.
    void write(const std::string& name, const image::Picture& picture);

    std::uint64_t bytes() const { return bytes_; }
    /// Bytes that it may still grow by.
    std::uint64_t room() const { return most_bytes_ - bytes_; }
    /// Throws Error where there is less room.
    void expect_room(std::uint64_t bytes) const;

private:
    std::filesystem::path folder_;
    std::uint64_t most_bytes_, bytes_ = 0;
};

}  // namespace gw::report
