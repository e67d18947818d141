#include "gw/stages/pixels/blit.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/raster/samples.h"
#include "gw/stages/texels.h"

#include <vector>

namespace gw {
namespace {

/// Where the centres of a target's columns, or rows, lie in the source, in 1/256 pixel.
std::vector<std::int64_t> places(int source, int source_size, int target_size, bool flip) {
    std::vector<std::int64_t> out;
    for (std::int64_t i = 0; i < target_size; ++i) {
        const std::int64_t k = flip ? target_size - 1 - i : i;
        out.push_back(256 * std::int64_t{source} + 128 * (2 * k + 1) * source_size / target_size);
    }
    return out;
}

/// A colour plane as the linear filter of textures sees it.
struct ColorsBetween {
    const std::vector<Rgba>& colors;
    int width, height, bits;

    const Rgba& at(std::int64_t i, std::int64_t j) const {
        return colors[pixel_index(wrap_index(Wrap::Clamp, int(i), width),
                                  wrap_index(Wrap::Clamp, int(j), height), width)];
    }
    Rgba linear(std::int64_t u, std::int64_t v) const {
        const std::int64_t i = (u - 128) >> 8, j = (v - 128) >> 8;
        const Rgba &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
        Rgba out;
        for (std::size_t k = 0; k < 4; ++k)
            out[k] = bilinear(a[k], b[k], c[k], d[k], std::uint32_t((u - 128) & 255),
                              std::uint32_t((v - 128) & 255), bits);
        return out;
    }
};

}  // namespace

PlaneMask blitted_planes(const Blit& blit, const Surface& from, const Surface& to) {
    return PlaneMask(blit.planes & from.planes & to.planes & surface_planes);
}

BlitParts blit_parts(const Blit& blit, const Rect& pixel_box, const Surface& from) {
    const Rect& s = blit.source;  // and a pixel around it, for the linear filter
    BlitParts parts{
        intersect({s.x - 1, s.y - 1, s.width + 2, s.height + 2}, {0, 0, from.width, from.height}),
        intersect(pixel_box, blit.target), blit};
    parts.blit.source.x -= parts.source.x;
    parts.blit.source.y -= parts.source.y;
    parts.blit.target.x -= parts.target.x;
    parts.blit.target.y -= parts.target.y;
    return parts;
}

std::vector<Planes> blit_samples(std::span<const Planes> from, const Surface& to) {
    if (from.size() > 1 && to.samples == 0) return {one_of_each(from)};
    return {from.begin(), from.end()};
}

std::uint64_t blit_bytes(Plane plane, const Surface& from, const Surface& to, const State& state,
                         const Profile& profile) {
    const bool all = to.samples != 0 || plane == Plane::Color;
    const int read = all ? from.sample_count() : 1, written = to.sample_count();
    return std::uint64_t(read) * plane_bytes(plane, profile) +
           std::uint64_t(written) * written_bytes(plane, state, profile);
}

std::uint64_t blit_plane(const Blit& blit, Plane plane, const BlitSource& from, std::size_t k,
                         const Resolved& r, int bits, Planes& to) {
    const Planes& source = from.samples.size() == 1 ? from.samples[0] : from.samples[k];
    const std::vector<Rgba>& colors =
        from.buffer == ReadBuffer::Back && from.surface.is_window() ? source.back : source.color;
    const ColorsBetween between{colors, source.width, source.height, bits};
    const DrawBuffer buffer = r.state.draw_buffer;
    const auto copy = [&](std::size_t pixel, std::int64_t u, std::int64_t v) {
        const std::size_t i = source.index(int(u >> 8), int(v >> 8));
        if (plane == Plane::Depth) to.depth[pixel] = source.depth[i];
        if (plane == Plane::Stencil) to.stencil[pixel] = source.stencil[i];
        if (plane != Plane::Color) return;
        const Rgba color = blit.filter == MagFilter::Linear ? between.linear(u, v) : colors[i];
        if (buffer == DrawBuffer::Front || buffer == DrawBuffer::FrontAndBack)
            to.color[pixel] = color;
        if (buffer == DrawBuffer::Back || buffer == DrawBuffer::FrontAndBack)
            to.back[pixel] = color;
    };
    const Rect& t = blit.target;
    const Rect box = intersect(r.pixel_box, t);
    const auto us = places(blit.source.x, blit.source.width, t.width, blit.flip_x),
               vs = places(blit.source.y, blit.source.height, t.height, blit.flip_y);
    std::uint64_t pixels = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::int64_t u = us[std::size_t(x - t.x)], v = vs[std::size_t(y - t.y)];
            if (u < 0 || v < 0 || u >> 8 >= source.width || v >> 8 >= source.height) continue;
            copy(to.index(x, y), u, v);
            pixels += 1;
        }
    return pixels;
}

}  // namespace gw
