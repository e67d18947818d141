// The pixels that are drawn to.
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include <algorithm>
#include <cmath>

namespace gw::irisgl {

Bounds pixels_around(std::span<const Vertex> vertices) {
    const Window& w = current_window();
    const Bounds all{0, w.width() - 1, 0, w.height() - 1};
    Bounds out{all.right, 0, all.top, 0};
    const auto pixel = [](double v, int most) { return int(std::clamp(v, -1.0, most + 1.0)); };
    for (const Vertex& v : vertices) {
        const auto at = window_from_object(v.p);
        if (!at || !std::isfinite(at->x) || !std::isfinite(at->y)) return all;
        const int x = pixel(std::floor(at->x), all.right), y = pixel(std::floor(at->y), all.top);
        out = {std::min(out.left, x), std::max(out.right, x), std::min(out.bottom, y),
               std::max(out.top, y)};
    }
    return out;
}

void track(const Bounds& pixels) {
    ScreenBox& box = state().box;
    const Bounds& m = state().screen_mask;
    const Bounds in{std::max(pixels.left, m.left), std::min(pixels.right, m.right),
                    std::max(pixels.bottom, m.bottom), std::min(pixels.top, m.top)};
    if (!box.is_tracked || in.left > in.right || in.bottom > in.top) return;
    box.left = std::min<long>(box.left, in.left);
    box.right = std::max<long>(box.right, in.right);
    box.bottom = std::min<long>(box.bottom, in.bottom);
    box.top = std::max<long>(box.top, in.top);
}

}  // namespace gw::irisgl
