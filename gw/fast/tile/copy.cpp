// Copies between segments, on the host's planes: the only commands that move pixels across tiles.
#include "gw/fast/tile/tile_run.h"

#include "gw/stages/pixels/plane_texels.h"

namespace gw::fast {
namespace {

/// Calls move(to, from) for each pixel of a copy's destination box.
std::uint64_t for_each_copied(const Copy& c, const Rect& pixel_box, const Planes& planes,
                              const auto& move) {
    const int dx = c.x - c.source.x, dy = c.y - c.source.y;
    const Rect inside = intersect(c.source, {0, 0, planes.width, planes.height});
    const Rect box =
        intersect(pixel_box, {inside.x + dx, inside.y + dy, inside.width, inside.height});
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            move(planes.index(x, y), planes.index(x - dx, y - dy));
    return std::uint64_t(box.width) * std::uint64_t(box.height);
}

const std::vector<Rgba>& colors_read(const Planes& planes, ReadBuffer buffer) {
    return buffer == ReadBuffer::Front ? planes.color : planes.back;
}

}  // namespace

std::uint64_t copy_pixels(const Copy& command, const Resolved& r, Planes& planes) {
    if (command.plane == Plane::Color) {
        const std::vector<Rgba> before = colors_read(planes, r.state.read_buffer);
        const DrawBuffer to_buffer = r.state.draw_buffer;
        const bool front = to_buffer != DrawBuffer::Back,
                   back = to_buffer == DrawBuffer::Back || to_buffer == DrawBuffer::FrontAndBack;
        return for_each_copied(command, r.pixel_box, planes, [&](std::size_t to, std::size_t from) {
            for (std::size_t c = 0; c < 4; ++c) {
                const auto write = [&](std::uint16_t& stored) {
                    stored = with_written_bits(stored, before[from][c], r.written_bits[c]);
                };
                if (front) write(planes.color[to][c]);
                if (back) write(planes.back[to][c]);
            }
        });
    }
    if (command.plane == Plane::Depth) {
        const auto before = planes.depth;
        return for_each_copied(command, r.pixel_box, planes, [&](std::size_t to, std::size_t from) {
            if (r.depth_mask) planes.depth[to] = before[from];
        });
    }
    const auto before = planes.stencil;
    const std::uint32_t write = r.state.stencil.write_mask & r.stencil_max;
    return for_each_copied(command, r.pixel_box, planes, [&](std::size_t to, std::size_t from) {
        planes.stencil[to] = std::uint8_t((planes.stencil[to] & ~write) | (before[from] & write));
    });
}

Texels copied_texels(const CopyTexture& command, ReadBuffer from, const Planes& planes,
                     const Profile& profile) {
    return plane_texels(command.plane, command.rect, colors_read(planes, from), planes, profile);
}

}  // namespace gw::fast
