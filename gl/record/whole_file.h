// A file that is replaced whole or stays as it was. Does not make folders.
#pragma once

#include <string>
#include <string_view>

namespace gw::gl {

/// Writes under another name beside the file, then renames. A link is followed, a replaced file keeps
/// its mode, and what is no regular file is written to directly. Returns the reason of a failure;
/// empty: it is written.
std::string write_whole_file(const std::string& file, std::string_view bytes);

}  // namespace gw::gl
