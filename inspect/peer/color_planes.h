// Two colour planes on a window with one: the other waits on the host. Knows no commands.
#pragma once

#include "gw/planes.h"

#include <cstdint>
#include <vector>

namespace gw::peer {

class ColorPlanes {
public:
    ColorPlanes(int width, int height) : width_(width), height_(height) {}

    /// The window has this plane now: Color or Back.
    void show(Plane plane);
    Plane shown() const { return shown_; }
    /// SwapBuffers.
    void exchange() { shown_ = other(); }

    /// Adds the colour planes to what the window has; `back`: there are two.
    void complete(Planes& planes, bool back) const;

private:
    Plane other() const { return shown_ == Plane::Color ? Plane::Back : Plane::Color; }

    int width_, height_;
    Plane shown_ = Plane::Color;
    std::vector<std::uint8_t> waiting_;  ///< R, G, B, A; empty: 0, as a machine begins
};

}  // namespace gw::peer
