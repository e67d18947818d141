// The window's content as one picture: the scene's picture on the left, a panel of text on the right.
// Does not decide what to show.
#pragma once

#include "apps/hidden/lettering.h"
#include "image/picture.h"

#include <string>
#include <vector>

namespace gw::apps {

inline constexpr int panel_letters = 40, panel_width = 12 * panel_letters + 16;

struct PanelLine {
    std::string text;
    Color color{210, 210, 210};
};

struct ScreenContent {
    image::Picture picture;          ///< of any bits; empty: black
    std::vector<PanelLine> panel;    ///< longer lines are cut
    std::vector<std::string> below;  ///< small lines over the picture's lower part
    /// Lines in the picture, from and to: x, y in pixels from its lower left corner.
    std::vector<std::array<int, 4>> strokes{};
};

/// 3 channels of 8 bits: width + panel_width wide, as high as the picture, at least 480.
image::Picture screen_of(const ScreenContent& content, int width, int height);

/// Planes side by side, each half as wide and high, with their names: four of them.
image::Picture quarters(const std::vector<std::pair<std::string, image::Picture>>& planes);

}  // namespace gw::apps
