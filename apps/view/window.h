// A window on the screen. Knows no scene.
#pragma once

#include "apps/view/input.h"
#include "image/picture.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace gw::apps {

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
