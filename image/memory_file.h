// Bytes under a name of the file system, for readers that open files: a picture within another file.
// Internal to image/. Nothing is written to a disk.
#pragma once

#include <filesystem>
#include <string_view>

namespace gw::image {

/// Lives as long as the object. This process and its children can open it.
class MemoryFile {
public:
    /// Throws Error if there is no memory for it.
    explicit MemoryFile(std::string_view bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const;

private:
    int file_ = -1;
};

}  // namespace gw::image
