// Smooth lines of colour map mode: the lowest four bits of a pixel's index are its coverage.
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include <algorithm>
#include <cmath>

namespace gw::irisgl {

namespace {

struct LineEnd {
    double x, y, z, index;  ///< pixels, -1 .. 1
};

std::optional<LineEnd> line_end(const Vertex& v) {
    const dvec4 clip = clip_from_object(v.p);
    const auto at = window_from_object(v.p);
    if (!at || !std::isfinite(at->x) || !std::isfinite(at->y)) return std::nullopt;
    return LineEnd{at->x, at->y, clip.z / clip.w, v.index};
}

/// 15 in the middle of a line of one pixel, 0 a pixel away from it.
void add_pixel(std::vector<Vertex>& out, int x, int y, double z, double index, double distance) {
    const double half = std::max(state().now.line_width, 1.0) / 2;
    const double coverage = std::clamp(half + 0.5 - distance, 0.0, 1.0);
    const auto bits = unsigned(std::floor(coverage * 15 + 0.5));
    if (bits == 0) return;
    const Window& w = current_window();
    Vertex v = vertex_here((2.0 * x + 1) / w.width() - 1, (2.0 * y + 1) / w.height() - 1, z);
    v.index = double((unsigned(std::clamp(index + 0.5, 0.0, double(index_mask))) & ~15u) | bits);
    out.push_back(v);
}

/// Each column of a flat line, or row of a steep one, has the pixels beside its middle.
void add_segment(std::vector<Vertex>& out, LineEnd a, LineEnd b) {
    const Window& w = current_window();
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep) {
        std::swap(a.x, a.y);
        std::swap(b.x, b.y);
    }
    if (a.x > b.x) std::swap(a, b);
    const double length = b.x - a.x, slope = length > 0 ? (b.y - a.y) / length : 0;
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    const int reach = int(std::min(state().now.line_width, 64.0)) / 2 + 2,
              most = steep ? w.height() : w.width(), across = steep ? w.width() : w.height();
    const int first = int(std::clamp(std::floor(a.x), 0.0, double(most))),
              last = int(std::clamp(std::floor(b.x), -1.0, most - 1.0));
    for (int i = first; i <= last; ++i) {
        const double t = length > 0 ? std::clamp((i + 0.5 - a.x) / length, 0.0, 1.0) : 0;
        const double middle = a.y + slope * (i + 0.5 - a.x);
        if (!(middle > -64 && middle < across + 64)) continue;
        for (int k = int(std::floor(middle)) - reach; k <= int(std::floor(middle)) + reach; ++k) {
            if (k < 0 || k >= across) continue;
            add_pixel(out, steep ? k : i, steep ? i : k, a.z + t * (b.z - a.z),
                      a.index + t * (b.index - a.index), std::abs(k + 0.5 - middle) * cosine);
        }
    }
}

}  // namespace

std::vector<Vertex> smooth_pixels(std::span<const Vertex> line, bool is_closed) {
    std::vector<Vertex> out;
    const std::size_t count = line.size() - (is_closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = line_end(line[i]), b = line_end(line[(i + 1) % line.size()]);
        if (a && b) add_segment(out, *a, *b);
    }
    return out;
}

}  // namespace gw::irisgl
