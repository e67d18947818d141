// What a user does at a window, without the window's library.
#pragma once

#include <string>

namespace gw::apps {

/// Positions are pixels of the screen (screen.h) from its upper left corner.
struct Input {
    enum class Kind { Key, Press, Release, Move, Wheel, Close };
    Kind kind = Kind::Key;
    /// Kind::Key: a character, "R", "?", or a name: "Left", "Right", "Up", "Down", "Tab", "Home",
    /// "PageUp", "PageDown", "Escape", "Space"
    std::string key{};
    int x = 0, y = 0;
    int button = 1;  ///< 1 left, 2 middle, 3 right
    bool shift = false, ctrl = false;
    double wheel = 0;  ///< notches away from the user
};

}  // namespace gw::apps
