#include "inspect/peer/color_planes.h"

#include "inspect/peer/commands.h"

#include <utility>

namespace gw::peer {

void ColorPlanes::show(Plane plane) {
    if (plane == shown_) return;
    std::vector<std::uint8_t> now = read_colors(width_, height_);
    waiting_.resize(now.size());
    replace_colors(width_, height_, waiting_);
    waiting_ = std::move(now);
    shown_ = plane;
}

void ColorPlanes::complete(Planes& planes, bool back) const {
    if (!back) return;
    planes.back.assign(planes.color.size(), {});
    for (std::size_t i = 0; i < waiting_.size(); ++i) planes.back[i / 4][i % 4] = waiting_[i];
    if (shown_ == Plane::Back) std::swap(planes.color, planes.back);
}

}  // namespace gw::peer
