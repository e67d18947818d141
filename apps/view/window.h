// A window on the screen, and what a user does at it. Knows no scene.
#pragma once

#include "image/picture.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace gw::apps {

/// What a user does. Positions are pixels of the screen (screen.h) from its upper left corner.
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

class Window {
public:
    virtual ~Window() = default;
    /// A picture of the window's first size; 8 bits a channel.
    virtual void show(const image::Picture& screen) = 0;
    /// The next of what the user does. Waits so long for the first.
    virtual std::optional<Input> next_input(std::chrono::milliseconds wait) = 0;
};

using OpenWindow = std::unique_ptr<Window> (*)(const std::string& title, int width, int height);

/// By SDL2, in the module libgw_window.so (docs/decisions/009). Throws Error if the module or a
/// display is missing.
std::unique_ptr<Window> open_window(const std::string& title, int width, int height);

}  // namespace gw::apps
