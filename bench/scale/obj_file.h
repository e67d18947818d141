// A sheet of waves as an OBJ file, as large as one wants: what reading and drawing are measured on.
#pragma once

#include <cstddef>
#include <filesystem>

namespace gw::bench {

/// About so many triangles. full: with vt and vn, corners as v/vt/vn; else v and v only, which
/// leaves the normals to the reader. Returns the triangles written. Throws Error where the file
/// cannot be written.
std::size_t write_sheet(const std::filesystem::path& path, double triangles, bool full);

/// Seconds of processor time for reading it into a mesh ready to draw, by our reader, and by
/// tinyobjloader (into its arrays only); 0 where that is absent.
double read_ours(const std::filesystem::path& path);
double read_tinyobj(const std::filesystem::path& path);

}  // namespace gw::bench
