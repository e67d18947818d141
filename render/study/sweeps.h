// Sweeps of one scene for the study of passes against rays [K4f]: the table of what varies, and one
// row of it measured. To add a sweep, add a row in sweeps.cpp. Does not write files.
#pragma once

#include "render/study/methods.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::render {

/// A picture drawn by all methods.
struct StudyRow {
    std::string sweep;
    int value = 0;  ///< of the sweep's
    double x = 0;   ///< measured: percent of pixels that are glossy, triangles, pixels, ...
    Size size;
    int samples = 1;  ///< superposed pictures asked for
    int lights = 0, depth = 0;
    std::size_t triangles = 0;
    std::vector<Cost> costs;  ///< in the order of methods()

    const Cost& cost(const std::string& method) const;
    /// The part of all samples' pixels whose reflections are traced: the paper's g, 0 .. 1.
    double share() const;
};

struct Sweep {
    std::string name, label;
    std::string about;        ///< of its values, for help
    int log = 0;              ///< base of a plot's axis; 0: linear
    std::vector<int> values;  ///< by default
    int low = 0, high = 0;    ///< that it takes
    /// Why the drawing has no such sweep; empty: it has.
    std::function<std::string(const Drawing&)> refusal;
    std::function<Drawing(Drawing, int value)> at;
    std::function<double(const StudyRow&)> x;
};
/// lights, samples, share, polygons, resolution, depth.
const std::vector<Sweep>& sweeps();

/// The drawing alone: a sweep "scene" of one row.
const Sweep& no_sweep();

/// One of sweeps(), or no_sweep(). Throws OptionError for another name.
const Sweep& sweep_named(const std::string& name);

/// Draws the row at this value. Throws OptionError if the profile cannot superpose the samples, Error
/// if a scene gets too large.
StudyRow measured(const Sweep& sweep, int value, const Drawing& drawing, int runs,
                  const std::function<void(const std::string&)>& say);

/// N lights: copies of the scene's in turn, the copies displaced by up to a tenth of the scene's size
/// (directions by a tenth), together as bright as before. Fewer: the first ones.
scene::Scene with_lights(scene::Scene scene, int count);
/// About this share of the pixels, 0 .. 1, is glossy: the objects that show the most pixels and still
/// fit reflect (illum 3), the others do not. Translucent ones stay.
scene::Scene with_share(const Drawing& drawing, double share);

}  // namespace gw::render
