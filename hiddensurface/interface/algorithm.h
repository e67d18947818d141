// The interface of all algorithms. A scene and a view go in; commands for the machine, counts and a
// step log come out. Each algorithm has a file in hiddensurface/algorithms/. Does not execute
// anything.
#pragma once

#include "gw/command_list.h"
#include "hiddensurface/interface/steps.h"
#include "hiddensurface/model/piece.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace gw::hiddensurface {

/// The counts of all algorithms, with one meaning each: docs/lecture.md explains them. The machine
/// counts fragments.
struct Counts {
    std::uint64_t polygons = 0;  ///< in the window
    // Comparisons by kind, one for each question asked.
    std::uint64_t facings = 0;    ///< signs of D_f, of a polygon or of a plane seen from the eye
    std::uint64_t keys = 0;       ///< two distances of representative points, in a sort
    std::uint64_t extents = 0;    ///< two intervals in x, y or z
    std::uint64_t planes = 0;     ///< a polygon against a plane
    std::uint64_t overlaps = 0;   ///< two projections, or one and a window
    std::uint64_t crossings = 0;  ///< two ends of segments in x, in a sort
    std::uint64_t depths = 0;     ///< two depths at a pixel
    std::uint64_t rays = 0;       ///< a ray against a polygon
    // Work.
    std::uint64_t sorts = 0;
    std::uint64_t swaps = 0;      ///< neighbours exchanged, or polygons moved in the list
    std::uint64_t splits = 0;     ///< polygons cut in two
    std::uint64_t undecided = 0;  ///< pairs for which no test and no cut gave an order
    std::uint64_t rejected = 0;   ///< cubes, polygons or fragments found hidden as a whole
    std::uint64_t nodes = 0;  ///< nodes of trees, windows, fragments of pixels, visible polygons
    std::uint64_t spans = 0;  ///< runs of pixels computed
    std::uint64_t peak_bytes = 0;  ///< peak memory beside the scene and the frame buffer
    // Of the machine.
    std::uint64_t fragments = 0;  ///< made
    std::uint64_t passed = 0;     ///< fragments that passed every test
    std::uint64_t pixels = 0;     ///< pixels that show a polygon at the end
    std::uint64_t overdraw = 0;   ///< passed - pixels
    // Pixels that differ from the Z-buffer's.
    std::uint64_t ties = 0;  ///< the depth plane cannot tell the nearer one
    /// the centre is within one sub-pixel unit of an edge made by splitting
    std::uint64_t edges = 0;
    /// right in the scene; the snap to the sub-pixel grid exchanged the two
    std::uint64_t snapped = 0;
    std::uint64_t wrong = 0;  ///< the others
    bool operator==(const Counts&) const = default;
};

struct CountName {
    const char* name;
    std::uint64_t Counts::*count;
};
/// All counts in this order, for tables, CSV and JSON.
std::span<const CountName> count_names();

/// All of them, to be watched by a log.
std::vector<WatchedCount> watched(const Counts& counts);

struct Input {
    const scene::Scene& scene;
    const scene::View& view;
    Profile profile;
    std::vector<Polygon> polygons;  ///< of the scene in view, in the machine's order

    int subpixel_bits() const { return profile.subpixel_bits; }
    Rect window() const { return {0, 0, view.width, view.height}; }
};
/// Projects the scene. Refers to scene and view, which must outlive it.
Input make_input(const scene::Scene& scene, const scene::View& view, const Profile& profile);

/// The part of a pixel that a polygon has, 0 .. 1.
struct Share {
    int x = 0, y = 0;
    std::uint32_t id = 0;
    double part = 0;
};

struct Output {
    CommandList list;  ///< the picture, identifiers as colours (scene::id_of), on 0
    Counts counts;
    std::vector<Piece> pieces;  ///< in the order drawn, if the algorithm draws piece by piece
    std::vector<Share> shares;  ///< if the algorithm finds parts of pixels
};

enum class Claim {
    Always,    ///< agrees with the Z-buffer but for ties and edges
    Sometimes  ///< fails in cases that the lecture shows
};

enum class GrowthLaw {
    Linear,      ///< or nearly: no run takes too long
    Rays,        ///< every polygon at every pixel
    Superlinear  ///< by a power that depends on the scene
};
enum class Sampling {
    Scattered,  ///< every k-th polygon asks the scene's questions
    Joined      ///< the work depends on faces with common sides: neighbours ask them
};
/// The growth of the work with the polygons; estimate.h predicts a run's time from it.
struct Growth {
    GrowthLaw law = GrowthLaw::Linear;
    double nanoseconds = 0;  ///< time of a question, about; 0: Linear
    Sampling sampling = Sampling::Scattered;
};

struct Algorithm {
    std::string name;   ///< for the command line
    std::string title;  ///< for people, with the lecture's row
    Claim claim = Claim::Sometimes;
    bool uses_depth_plane = false;
    bool in_world =
        false;  ///< decides before the snap to the grid, which may exchange two polygons
    Growth growth{};
    std::function<Output(const Input&, StepLog&)> run;
};

/// All algorithms, in the lecture's order.
const std::vector<Algorithm>& algorithms();
std::vector<std::string> algorithm_names();
/// Throws an Error that names the known ones.
const Algorithm& algorithm_named(const std::string& name);

/// The beginning of every list without a depth buffer: a pass of this name, depth test off, colour
/// cleared to 0. Depth is neither cleared nor read nor written.
CommandList begin_picture(const Input& input, const std::string& name);
/// Pixels in the colours of identifiers, through the machine's spans.
void add_painted(CommandList& list, const std::vector<Painted>& painted);

/// Appends a run, or joins it to the last one that it continues.
void add_run(std::vector<Painted>& painted, const Run& run, std::uint32_t id);

/// For a step's window: the whole scan line; the run's pixels.
inline Rect line_of(const Input& input, int y) { return {0, y, input.view.width, 1}; }
inline Rect pixels_of(const Run& run) { return {run.x0, run.y, run.x1 - run.x0, 1}; }
/// For a step's values: y on the grid counted downwards.
inline double from_top(const Input& input, double y) {
    return double(input.view.height) * (1 << input.subpixel_bits()) - y;
}
/// The number of pixels.
std::int64_t size_of(const std::vector<Painted>& painted);

/// Draws a scan line: spans in the list, a step in the log.
void draw_line(const Input& input, int y, std::vector<Painted> painted, Output& output,
               StepLog& log);

/// Draws a piece: spans in the list, a step in the log, counted.
void draw_piece(const Input& input, const Piece& piece, Output& output, StepLog& log);

}  // namespace gw::hiddensurface
