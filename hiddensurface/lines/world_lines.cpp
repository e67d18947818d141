#include "hiddensurface/lines/world_lines.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

dmat4 clip_from_world(const scene::View& view) {
    return product(view.clip_from_eye, view.eye_from_world);
}

/// Shortens a part to the points at which a linear value is above 0. It is `at_a` at 0 and `at_b` at
/// 1.
void cut_at(double at_a, double at_b, Part& part) {
    if (at_a < 0 && at_b < 0) part = {1, 0};
    if (at_a < 0 && at_b >= 0) part.first = std::max(part.first, at_a / (at_a - at_b));
    if (at_a >= 0 && at_b < 0) part.second = std::min(part.second, at_a / (at_a - at_b));
}

}  // namespace

dvec4 near_plane_of(const scene::View& view) {
    const dmat4 m = clip_from_world(view);
    return {m[0].z + m[0].w, m[1].z + m[1].w, m[2].z + m[2].w, m[3].z + m[3].w};
}

WorldLines::WorldLines(const Input& input) : clip_from_world_(clip_from_world(input.view)) {
    const double unit = double(1 << input.subpixel_bits());
    scale_ = {input.view.width / 2.0 * unit, input.view.height / 2.0 * unit,
              max_of_bits(input.profile.depth_bits) / 2.0};
}

dvec3 WorldLines::on_grid(const dvec4& c) const {
    return {(c.x / c.w + 1) * scale_.x, (c.y / c.w + 1) * scale_.y, (c.z / c.w + 1) * scale_.z};
}

dvec3 WorldLines::on_grid(const dvec3& p) const {
    return on_grid(transform(clip_from_world_, dvec4(p, 1)));
}

std::optional<Line> WorldLines::to_window(std::uint32_t id, const dvec3& p, const dvec3& q,
                                          const std::vector<Part>& visible) const {
    const dvec4 a = transform(clip_from_world_, dvec4(p, 1)),
                b = transform(clip_from_world_, dvec4(q, 1));
    Part inside{0, 1};
    cut_at(a.z + a.w, b.z + b.w, inside);
    cut_at(a.w - a.z, b.w - b.z, inside);
    if (inside.first >= inside.second) return std::nullopt;
    const dvec4 from = a + inside.first * (b - a), to = a + inside.second * (b - a);
    Line line{id, on_grid(from), on_grid(to), {}};
    const dvec3 along = line.b - line.a;
    if (std::max(std::abs(along.x), std::abs(along.y)) < 1e-6) return std::nullopt;
    // From s in the world between the two ends to t in the window.
    const auto in_window = [&](double t) {
        const double s = std::clamp((t - inside.first) / (inside.second - inside.first), 0.0, 1.0);
        return s * to.w / ((1 - s) * from.w + s * to.w);
    };
    for (const auto& [first, last] : visible) {
        const Part part{in_window(first), in_window(last)};
        if (part.first < part.second) line.visible.push_back(part);
    }
    return line;
}

}  // namespace gw::hiddensurface
