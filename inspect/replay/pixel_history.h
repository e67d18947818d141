// Everything that happened to a pixel, in order; and what happened to the fragments of every pixel,
// counted.
// From the reference machine, exact, in one run. Does not draw pictures.
#pragma once

#include "gw/reference/observer.h"
#include "inspect/recording/recording.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

/// A fragment that reached the pixel, or a command that wrote to it without one (clear, copy,
/// accumulate, rectangles of Z and stencil): then there is no `fragment`.
struct PixelEvent {
    std::size_t pass = 0;  ///< its place among the passes
    std::string pass_name;
    std::size_t command = 0;          ///< through all lists, from 0
    const char* command_name = "";    ///< "Draw"
    std::optional<std::size_t> draw;  ///< its place among the draws of the pass
    /// of a draw: identifier of the fragment's polygon in its mesh
    std::optional<std::uint32_t> polygon;
    std::optional<Fragment> fragment;
    Fate fate = Fate::Written;
    PixelValues before, after;
};

/// Window coordinates. A command that touches the pixel plane by plane is one event.
std::vector<PixelEvent> pixel_history(const Recording& recording, int x, int y);

/// "written", "alpha test", "stencil test", "depth test"
const char* name_of(Fate fate);

/// Of every pixel, at y * width + x.
struct FragmentMaps {
    std::vector<std::uint32_t> made;     ///< fragments: depth complexity
    std::vector<std::uint32_t> written;  ///< that passed all tests: overdraw
    std::vector<std::uint32_t> alpha_killed, stencil_killed, depth_killed;
};

/// Of one pass, or of all.
FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass);

}  // namespace gw::inspect
