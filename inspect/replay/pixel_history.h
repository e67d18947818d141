// The events of a pixel, in order; and the fragments of every pixel, counted by their fate. From
// the reference machine, exact, in one run. Pixels are the window's: what is drawn to surfaces beside
// it has no events. Does not draw pictures.
#pragma once

#include "gw/reference/observer.h"
#include "inspect/recording/recording.h"

#include <nlohmann/json_fwd.hpp>

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

/// Whether commands draw to surfaces beside the window, which are in no history and no map.
bool has_surfaces(const Recording& recording);

/// Of one pass, or of all.
FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass);

// As a table and as JSON, in picture coordinates, top left first.

/// Rows of words, the first of them the header: pass, command, event, values before and after. A
/// plane whose values stay the same shows one value; the back plane and accumulation are left out if
/// they stay 0, coverage if no fragment is antialiased.
std::vector<std::vector<std::string>> history_rows(const std::vector<PixelEvent>& events);

/// {"x", "y", "profile", "width", "height", "events": [...]}
nlohmann::ordered_json history_json(const Recording& recording, int x, int y,
                                    const std::vector<PixelEvent>& events);

}  // namespace gw::inspect
