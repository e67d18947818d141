// The words of MTL's map statements: options, then a file name that may hold blanks. Does not know
// which statements there are, and does not open the texture.
#pragma once

#include "scene/scene.h"
#include "scene/text/statements.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <string>

namespace gw::scene {

struct MapStatement {
    Map map;           ///< -clamp, -o, -s and, of map_d, -imfchan are in it
    std::string type;  ///< -type; empty if absent
};

/// Reads "map_Kd -s 2 2 -clamp on my wood.png"; searches `folder` for the file (find_file). Warns
/// about options that would change the picture but are not honoured. Without a file name, the map's
/// file is empty. Throws Error for an unknown option or a wrong argument.
MapStatement read_map(const Statements& in, const std::filesystem::path& folder,
                      Warnings& warnings);

}  // namespace gw::scene
