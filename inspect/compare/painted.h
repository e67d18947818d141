// What painted each pixel's colour last, so that a difference of another renderer has a cause.
// An observer of the reference machine.
#pragma once

#include "inspect/replay/following_observer.h"

#include <vector>

namespace gw::inspect {

enum class Paint : std::uint8_t {
    Plain,     ///< clears, copies, primitives and pixels without texture
    Textured,  ///< a texture
    Smooth,    ///< an antialiased primitive
};

class Painted : public FollowingObserver {
public:
    explicit Painted(const Recording& recording);

    /// Bottom row first. `plane`: Color or Back.
    const std::vector<Paint>& of(Plane plane) const {
        return plane == Plane::Back ? back_ : front_;
    }
    /// The colour plane that the pass shows: Color after an exchange, else the one drawn to.
    Plane main_plane() const { return has_exchanged_ ? Plane::Color : drawn_; }

    void begin_command(std::size_t command) override;
    void fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                  const PixelValues& after) override;
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override;

private:
    void paint(int x, int y, Paint paint, const PixelValues& before, const PixelValues& after);

    int width_;
    std::vector<Paint> front_, back_;
    Paint paint_ = Paint::Plain;  ///< of the command
    Plane drawn_ = Plane::Color;
    bool has_exchanged_ = false;  ///< in this pass
};

}  // namespace gw::inspect
