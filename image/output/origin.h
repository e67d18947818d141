// The command that wrote a file, noted beside its bytes: as the extended attribute user.gw.command,
// so that the same picture stays the same file. Does not know commands. Where a file system has no
// such attributes, or a copy left them behind, nothing is known.
#pragma once

#include <filesystem>
#include <string>

namespace gw::image {

/// Of every file that this process writes from now on; "" for nothing.
void set_origin(std::string command);
/// Done by OutputFile, for regular files.
void note_origin(const std::filesystem::path& file);

/// What was noted when the file was written, "" for nothing.
std::string origin_of(const std::filesystem::path& file);

}  // namespace gw::image
