// What all algorithms have in common: a scene and a view go in; commands for the machine, counts
// and a step log come out. One file per algorithm in hiddensurface/algorithms/. Does not execute
// anything.
#pragma once

#include "gw/command_list.h"
#include "hiddensurface/model/piece.h"
#include "hiddensurface/run/counts.h"
#include "hiddensurface/run/steps.h"

#include <functional>
#include <string>

namespace gw::hiddensurface {

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
    std::vector<Piece> pieces;  ///< in the order drawn, where the algorithm draws piece by piece
    std::vector<Share> shares;  ///< where the algorithm finds parts of pixels
};

enum class Claim {
    Always,    ///< agrees with the Z-buffer but for ties and edges
    Sometimes  ///< fails in cases that the lecture shows
};

enum class GrowthLaw {
    Linear,      ///< or nearly: never too long
    Rays,        ///< every polygon at every pixel
    Superlinear  ///< by a power that depends on the scene
};
/// How the work grows with the polygons; estimate.h tells from it what a run would take.
struct Growth {
    GrowthLaw law = GrowthLaw::Linear;
    double nanoseconds = 0;  ///< of a question, about; 0: Linear
};

struct Algorithm {
    std::string name;   ///< for the command line
    std::string title;  ///< for people, with the lecture's row
    Claim claim = Claim::Sometimes;
    bool uses_depth_plane = false;
    /// decides before the snap to the grid: may differ where that turns two over
    bool in_world = false;
    Growth growth{};
    std::function<Output(const Input&, StepLog&)> run;
};

/// All of them, in the lecture's order.
const std::vector<Algorithm>& algorithms();
std::vector<std::string> algorithm_names();
/// Throws Error naming the known ones.
const Algorithm& algorithm_named(const std::string& name);

/// The beginning of every list without a depth buffer: a pass of this name, depth test off, colour
/// cleared to 0. Depth is neither cleared nor read nor written.
CommandList begin_picture(const Input& input, const std::string& name);
/// Pixels in the colours of identifiers, through the machine's spans.
void add_painted(CommandList& list, const std::vector<Painted>& painted);

/// Appends, or joins to the last one that it continues.
void add_run(std::vector<Painted>& painted, const Run& run, std::uint32_t id);

/// Draws a scan line: spans in the list, a step in the log.
void draw_line(int y, std::vector<Painted> painted, Output& output, StepLog& log);

/// Draws a piece: spans in the list, a step in the log, counted.
void draw_piece(const Input& input, const Piece& piece, Output& output, StepLog& log);

}  // namespace gw::hiddensurface
