// Sweeps of scene files: how the time of reading grows with what is in them. Does not time.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gw::growth {

/// A file with a growing amount of one thing.
struct SceneSweep {
    std::string name;
    std::vector<double> amounts;
    std::string file;  ///< its name; the extension chooses the reader
    std::function<std::string(int amount)> text;
};

/// Boxes, lights, materials, numbers of an array in TOML; groups, smoothing groups at one point,
/// vertices at one point in OBJ.
std::vector<SceneSweep> scene_sweeps();

/// Reads the file of a sweep.
void read_swept(const std::string& path);

}  // namespace gw::growth
