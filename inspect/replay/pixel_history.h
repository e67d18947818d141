// The events of a pixel, in order; and the fragments of every pixel, counted by their fate. From
// the reference machine, exact, in one run. Pixels are those of the window, or of one
// surface. Does not draw pictures.
#pragma once

#include "gw/reference/observer.h"
#include "inspect/recording/recording.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

/// A fragment that reached the pixel, or a command that wrote to it without one: clear, copy,
/// swap, accumulate, rectangles of Z and stencil. Then there is no `fragment`.
struct PixelEvent {
    std::size_t pass = 0;  ///< its place among the passes
    std::string pass_name;
    std::size_t command = 0;          ///< through all lists, from 0
    const char* command_name = "";    ///< "Draw"
    std::string call;                 ///< the program's (inspect/text/call_text.h); "" if unknown
    std::optional<std::size_t> draw;  ///< its place among the draws of the pass
    /// of a draw: identifier of the fragment's polygon in its mesh
    std::optional<std::uint32_t> polygon;
    std::optional<Fragment> fragment;
    std::vector<DepthComparison> comparisons;  ///< that shaded the fragment
    /// the surface whose depths each of them read; 0: a texture of its own
    std::vector<std::uint32_t> compared_surfaces;
    Fate fate = Fate::Written;
    PixelValues before, after;
    /// Of the recording, which must outlive it: the colours are indices. Null: they are not.
    const ColorMap* map = nullptr;
};

/// The surfaces that the recording makes, each with the largest width, height and samples that it
/// has; number 0 is the window.
std::map<std::uint32_t, Surface> surfaces_of(const Recording& recording);

/// Window coordinates, or those of a surface. A command that touches the pixel plane by plane is one
/// event; a fragment on a surface with samples is one event for each sample.
std::vector<PixelEvent> pixel_history(const Recording& recording, int x, int y,
                                      std::uint32_t surface = 0);

/// "written", "alpha test", "stencil test", "depth test"
const char* name_of(Fate fate);

/// Of every pixel, at y * width + x.
struct FragmentMaps {
    std::vector<std::uint32_t> made;     ///< fragments: depth complexity
    std::vector<std::uint32_t> written;  ///< that passed all tests: overdraw
    std::vector<std::uint32_t> alpha_killed, stencil_killed, depth_killed;
};

/// Of one pass, or of all; of the window, or of a surface with its size in surfaces_of(). On a
/// surface with samples, each covered sample counts.
FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass,
                           std::uint32_t surface = 0);

// As a table and as JSON, in picture coordinates, top left first.

/// Rows of words, the first of them the header: pass, command, event, values before and after. A
/// plane whose values stay the same shows one value; the back plane and accumulation are left out if
/// they stay 0, coverage if no fragment is antialiased.
std::vector<std::vector<std::string>> history_rows(const std::vector<PixelEvent>& events);

/// {"x", "y", "profile", "width", "height", "events": [...]}, of a surface also "surface"
nlohmann::ordered_json history_json(const Recording& recording, int x, int y,
                                    const std::vector<PixelEvent>& events,
                                    std::uint32_t surface = 0);

}  // namespace gw::inspect
