// Wavefront OBJ, read strictly: every fault is an error with its line. docs/scenes.md lists the
// statements. Does not triangulate (make_mesh does) and does not read textures.
#pragma once

#include "scene/scene_builder.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gw::scene {

struct ObjOptions {
    /// Degrees. If given, faces without normals are smoothed by this angle, in spite of `s`
    /// statements. If absent, `s` statements are honoured, and faces before any of them are smoothed
    /// by 60 degrees.
    std::optional<double> crease;
};

/// Elements of one kind with one name and one material.
struct ObjPart {
    std::string name;      ///< `g`, else `o`, else the file's stem
    std::string material;  ///< `usemtl`; empty: none
    int material_line = 0;
    dvec3 origin{0};  ///< of the mesh's positions: 0 unless it lies far from 0 (origins.h)
    MeshData mesh;    ///< Polygons, Lines or Points, without polygon_ids
};

struct ObjFile {
    std::string file;
    std::vector<ObjPart> parts;   ///< in the order of their first elements; at least one
    MaterialLibrary materials;    ///< of every mtllib, in order
    std::string missing_library;  ///< of the first mtllib that does not exist, for people
};

/// Throws Error "file:line: what; expected what", for its MTL files as well. Does not check that a
/// part's material is among `materials`: a scene may bring its own.
ObjFile read_obj(const std::filesystem::path& path, const ObjOptions& options, Warnings& warnings);

}  // namespace gw::scene
