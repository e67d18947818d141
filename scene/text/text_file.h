// Reads text files, and finds the files that they name. Does not interpret them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace gw::scene {

/// Bytes; a larger file is refused. Ten million triangles have about 800 MB.
inline constexpr std::size_t most_text = std::size_t{2} << 30;

/// The whole file as it is. Throws Error if the file is missing, a directory, a device or a pipe,
/// larger than `most_text`, or unreadable.
std::string read_bytes(const std::filesystem::path& path);

/// The whole file without its UTF-8 byte order mark. If lines end in carriage returns alone, these
/// become newlines. Throws Error as read_bytes does, and if the file is UTF-16.
std::string read_text(const std::filesystem::path& path);

/// False also for names that no file can have. Never throws.
bool file_exists(const std::filesystem::path& path);

/// Why this is no file to read: "does not exist", "is a directory", "is a device or a pipe",
/// "cannot be opened: Permission denied"; empty for a readable file. Never throws.
std::string file_fault(const std::filesystem::path& path);
inline constexpr std::string_view not_there = "does not exist";

/// The path that a file in `folder` means by a name: quotes taken off, '\' read as '/'.
std::filesystem::path named_path(const std::filesystem::path& folder, std::string_view name);

/// The same if it exists, or exists when case is disregarded or the name is in Shift-JIS.
std::optional<std::filesystem::path> existing_file(const std::filesystem::path& folder,
                                                   std::string_view name);

/// existing_file, else a file in `folder` with the last part of the name (names from another
/// machine, "C:\maps\wood.png"), else named_path, which does not exist.
std::filesystem::path find_file(const std::filesystem::path& folder, std::string_view name);

}  // namespace gw::scene
