#include "gw/reference/pixels.h"

#include "gw/stages/accumulation.h"
#include "gw/stages/pixels/blit.h"
#include "gw/stages/pixels/draw_pixels.h"
#include "gw/stages/pixels/plane_texels.h"

namespace gw::reference {
namespace {

/// Runs `change(planes, index, x, y)` on each sample of each pixel of a box, counted and observed.
template <typename Change>
void for_pixels(const Rect& box, const FragmentTarget& target, std::uint64_t bytes,
                const Change& change) {
    const Planes& first = target.planes();
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::size_t i = first.index(x, y);
            const PixelValues before = target.observer ? values_at(first, i) : PixelValues{};
            for (Planes& planes : target.samples) change(planes, i, x, y);
            target.counters->pixels += 1;
            target.counters->bytes += bytes * target.samples.size();
            if (target.observer) target.observer->pixel(x, y, before, values_at(first, i));
        }
}

void write_stencil(const Resolved& state, std::uint32_t value, std::uint8_t& stored) {
    const std::uint32_t mask = state.state.stencil.write_mask & state.stencil_max;
    stored = static_cast<std::uint8_t>((stored & ~mask) | (value & mask));
}

/// One plane's value at a pixel, through the masks.
void write_plane(Plane plane, const Resolved& r, Planes& planes, std::size_t i,
                 const PixelValues& value) {
    switch (plane) {
        case Plane::Color:
            for_draw_buffer(r.state, planes, [&](std::vector<Rgba>& color) {
                write_color(r.written_bits, value.color, color[i]);
            });
            break;
        case Plane::Back: break;  // named by no command
        case Plane::Depth:
            if (r.depth_mask) planes.depth[i] = value.depth;
            break;
        case Plane::Stencil: write_stencil(r, value.stencil, planes.stencil[i]); break;
        case Plane::Accum: planes.accum[i] = value.accum; break;
    }
}

/// A pixel's values as commands read them: the colour is the read buffer's.
PixelValues read_values(const Resolved& r, const Planes& planes, std::size_t i) {
    PixelValues v = values_at(planes, i);
    if (r.state.read_buffer == ReadBuffer::Back) v.color = v.back;
    return v;
}

}  // namespace

void run(const Clear& command, const Resolved& r, const FragmentTarget& target,
         const Profile& profile) {
    PixelValues value;
    value.color = quantize_color(command.color, r.bits);
    value.depth = quantize(command.depth, profile.depth_bits);
    value.stencil =
        static_cast<std::uint8_t>(static_cast<std::uint32_t>(command.stencil) & r.stencil_max);
    for (int c = 0; c < 4; ++c)
        value.accum[std::size_t(c)] = cleared_accum(command.accum[c], profile);
    for (const Plane plane : every_plane)
        if (command.planes & mask_of(plane))
            for_pixels(r.pixel_box, target, written_bytes(plane, r.state, profile),
                       [&](Planes& planes, std::size_t i, int, int) {
                           write_plane(plane, r, planes, i, value);
                       });
}

void run(const WriteSpans& command, const Resolved& r, const FragmentTarget& target) {
    std::uint32_t ordinal = 0;
    for (const Span& span : command.spans) {
        const Rect box = intersect(r.pixel_box, {span.x, span.y, span.length, 1});
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::uint32_t i = span.first + (span.flat ? 0 : std::uint32_t(x - span.x));
            process_fragment(r, target,
                             {x, span.y, command.colors[i], command.depth, true, ordinal});
        }
        ++ordinal;
    }
}

void run(const WritePixels& command, const Resolved& r, const FragmentTarget& target,
         const Profile& profile) {
    const Rect box = intersect(r.pixel_box, command.rect);
    if (command.plane == Plane::Color) {
        for (int y = box.y; y < box.y + box.height; ++y)
            for (int x = box.x; x < box.x + box.width; ++x)
                process_fragment(r, target,
                                 {x, y, command.colors[command.rect.index(x, y)], command.depth,
                                  true, std::uint32_t(command.rect.index(x, y))});
        return;
    }
    for_pixels(box, target, plane_bytes(command.plane, profile),
               [&](Planes& planes, std::size_t i, int x, int y) {
                   PixelValues value;
                   value.depth = command.values[command.rect.index(x, y)];
                   value.stencil = static_cast<std::uint8_t>(value.depth);
                   write_plane(command.plane, r, planes, i, value);
               });
}

void run(const Accumulate& command, const Resolved& r, const FragmentTarget& target,
         const Profile& profile) {
    const std::uint64_t bytes = accumulate_bytes(command.op, r.state, profile);
    for_pixels(r.pixel_box, target, bytes, [&](Planes& planes, std::size_t i, int, int) {
        PixelValues value = read_values(r, planes, i);
        Rgba& color = value.color;
        for (std::size_t c = 0; c < 4; ++c) {
            std::int32_t& stored = planes.accum[i][c];
            if (command.op == AccumOp::Return) {
                color[c] = returned(stored, command.value, profile);
                continue;
            }
            bool overflow = false;
            stored = wrap_accum(accumulated(command.op, stored, color[c], command.value, profile),
                                profile.accum_bits, overflow);
            target.counters->accum_overflows += overflow ? 1 : 0;
        }
        if (command.op == AccumOp::Return) write_plane(Plane::Color, r, planes, i, value);
    });
}

void run(const Copy& command, const Resolved& r, const FragmentTarget& target,
         const Profile& profile) {
    const Planes before = target.planes();
    const int dx = command.x - command.source.x, dy = command.y - command.source.y;
    const Rect inside = intersect(command.source, {0, 0, before.width, before.height});
    const Rect box =
        intersect(r.pixel_box, {inside.x + dx, inside.y + dy, inside.width, inside.height});
    const std::uint64_t bytes =
        plane_bytes(command.plane, profile) + written_bytes(command.plane, r.state, profile);
    for_pixels(box, target, bytes, [&](Planes& planes, std::size_t i, int x, int y) {
        write_plane(command.plane, r, planes, i,
                    read_values(r, before, before.index(x - dx, y - dy)));
    });
}

void count_source(const DrawPixels& command, const FragmentTarget& target, const Profile& profile) {
    const std::uint64_t pixels =
        source_box(command, target.planes().width, target.planes().height).area();
    target.counters->pixels += pixels;
    target.counters->bytes += pixels * plane_bytes(command.source->plane, profile);
}

void run(const DrawPixels& command, const Resolved& r, const FragmentTarget& target,
         const Profile& profile, const BoundTexels& texels) {
    const PlacedPixels placed(command, r, texels);
    const Rect& box = placed.box();
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::optional<std::size_t> pixel = placed.source_of(x, y);
            if (!pixel) continue;
            if (placed.is_stencil()) {
                for_pixels({x, y, 1, 1}, target, plane_bytes(Plane::Stencil, profile),
                           [&](Planes& planes, std::size_t i, int, int) {
                               write_stencil(r, placed.stencil(*pixel), planes.stencil[i]);
                           });
                continue;
            }
            process_fragment(
                r, target,
                {x, y, placed.color(*pixel), placed.depth(*pixel), true, std::uint32_t(*pixel)});
        }
}

void run(const SwapBuffers&, const FragmentTarget& target) {
    Planes& planes = target.planes();
    std::swap(planes.color, planes.back);
    if (!target.observer) return;
    for (int y = 0; y < planes.height; ++y)
        for (int x = 0; x < planes.width; ++x) {
            const PixelValues after = values_at(planes, planes.index(x, y));
            PixelValues before = after;
            std::swap(before.color, before.back);
            target.observer->pixel(x, y, before, after);
        }
}

Readback run(const Read& command, const Resolved& r, const FragmentTarget& target,
             const Profile& profile) {
    Readback out{command.plane, command.rect, {}, {}, {}};
    for_pixels(command.rect, target, plane_bytes(command.plane, profile),
               [&](const Planes& planes, std::size_t i, int, int) {
                   const PixelValues v = read_values(r, planes, i);
                   switch (command.plane) {
                       case Plane::Back: break;
                       case Plane::Color:
                           if (command.packed)
                               out.values.push_back(packed(v.color));
                           else
                               out.color.push_back(v.color);
                           break;
                       case Plane::Depth: out.values.push_back(v.depth); break;
                       case Plane::Stencil: out.values.push_back(v.stencil); break;
                       case Plane::Accum: out.accum.push_back(v.accum); break;
                   }
               });
    return out;
}

void run(const Blit& command, const BlitSource& from, const Surface& to, const Resolved& r,
         const FragmentTarget& target, const Profile& profile) {
    const std::vector<Planes> before(target.observer ? 1 : 0, target.planes());
    const PlaneMask blitted = blitted_planes(command, from.surface, to);
    for (const Plane plane : every_plane) {
        if ((blitted & mask_of(plane)) == 0) continue;
        std::uint64_t pixels = 0;
        for (std::size_t k = 0; k < target.samples.size(); ++k)
            pixels = blit_plane(command, plane, from, k, r, profile.color_bits, target.samples[k]);
        target.counters->pixels += pixels;
        target.counters->bytes += pixels * blit_bytes(plane, from.surface, to, r.state, profile);
    }
    if (!target.observer) return;
    const Planes& after = target.planes();
    const Rect box = intersect(r.pixel_box, command.target);
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) {
            const std::size_t i = after.index(x, y);
            target.observer->pixel(x, y, values_at(before[0], i), values_at(after, i));
        }
}

Texels copied_texels(const CopyTexture& command, const Resolved& r, const FragmentTarget& target,
                     const Profile& profile) {
    const Planes& planes = target.planes();
    for_pixels(command.rect, target, plane_bytes(command.plane, profile),
               [](const Planes&, std::size_t, int, int) {});
    return plane_texels(command.plane, command.rect,
                        r.state.read_buffer == ReadBuffer::Back ? planes.back : planes.color,
                        planes, profile);
}

}  // namespace gw::reference
