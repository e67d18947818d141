// A sheet of waves as an OBJ file of any size, to measure reading and drawing.
#pragma once

#include <cstddef>
#include <filesystem>

namespace gw::bench {

/// Writes about this number of triangles. full: with vt and vn, corners as v/vt/vn; else v only, so
/// that the reader computes normals. Returns the number of triangles written. Throws Error if the
/// file cannot be written.
std::size_t write_sheet(const std::filesystem::path& path, double triangles, bool full);

/// Seconds of processor time for reading it: by our reader into a mesh ready to draw, by
/// tinyobjloader into its arrays only; 0 if that is absent.
double read_ours(const std::filesystem::path& path);
double read_tinyobj(const std::filesystem::path& path);

}  // namespace gw::bench
