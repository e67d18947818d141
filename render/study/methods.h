// The four ways to one picture that the study of passes against rays compares [K4f], and the counts
// and times of each. Does not choose scenes and does not write files.
#pragma once

#include "render/drawing.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::render {

/// A way to draw. All take the drawing's scene, view, samples and depth.
struct Method {
    std::string name;   ///< "item-buffer"
    std::string about;  ///< for legends
    void (*choose)(Request&);
};
/// maps: passes with reflection maps; item-buffer: eq. 5; item-buffer-maps: reflected hits read
/// shadow maps; ray-tracing: the ordinary ray tracer.
const std::vector<Method>& methods();

/// What one picture costs. The counts are those of a first picture, which makes all of its data.
/// They are the same on any computer, for any number of threads.
struct Cost {
    std::string method;
    std::vector<Counters> passes;  ///< one by one
    raytrace::RayCounts rays;
    Digest picture;
    std::vector<Rgba> color;  ///< of the picture, bottom row first
    /// Processor seconds, of all threads: of the first picture, and of each that follows from a
    /// view as good as the same. These keep what no view changes: hierarchies, shadow volumes.
    double first_seconds = 0;
    std::vector<double> seconds;

    Counters sum() const;
    double median() const;  ///< 0: nothing was timed
    double least() const;
    double most() const;
};

/// Draws the picture by all methods, in turn: `runs` times after the first; 0: counts alone. The
/// drawing's own passes are not used. `say` is told what is under way.
std::vector<Cost> costs(const Drawing& drawing, int runs,
                        const std::function<void(const std::string&)>& say);

}  // namespace gw::render
