#include "gl/record/restored_planes.h"

#include "gw/stages/accumulation.h"

#include <algorithm>
#include <cmath>

namespace gw::gl {

namespace {

/// Writes a plane's values, unless they are the 0 of a new machine.
class Restorer {
public:
    Restorer(const Planes& planes, const Profile& profile, const std::string& pass)
        : planes_(planes), profile_(profile), window_{0, 0, planes.width, planes.height} {
        list.add(BeginPass{pass});
    }
    void restore_accum();
    void restore_colors();
    void restore_values(Plane plane, std::vector<std::uint32_t> values);

    CommandList list;

private:
    void set_buffer(DrawBuffer buffer) {
        gw::State state;
        state.draw_buffer = buffer;
        list.add(SetState{state});
    }
    void write_colors(std::vector<Rgba> colors) {
        list.add(WritePixels{.rect = window_, .colors = std::move(colors)});
    }
    /// Adds digit `digit` of the values of one sign, in bytes: what the front plane can hold.
    void add_accum_digit(int digit, bool negative);

    const Planes& planes_;
    const Profile& profile_;
    Rect window_;
};

void Restorer::add_accum_digit(int digit, bool negative) {
    std::vector<Rgba> colors;
    bool all_zero = true;
    for (const auto& sum : planes_.accum) {
        Rgba& color = colors.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            const std::int64_t value = sum[i];
            if ((value < 0) != negative) continue;
            color[i] = static_cast<std::uint16_t>(std::abs(value) >> 8 * digit & 0xFF);
            all_zero &= color[i] == 0;
        }
    }
    if (all_zero) return;
    write_colors(std::move(colors));
    const float weight = std::ldexp(1.0f, 8 * digit - accum_fraction_bits(profile_));
    list.add(Accumulate{AccumOp::Accum, negative ? -weight : weight});
}

/// The accumulation buffer is filled from the front plane, a byte at a time.
void Restorer::restore_accum() {
    set_buffer(DrawBuffer::Front);
    for (const bool negative : {false, true})
        for (int digit = 0; 8 * digit < profile_.accum_bits; ++digit)
            add_accum_digit(digit, negative);
}

void Restorer::restore_colors() {
    set_buffer(DrawBuffer::Front);
    write_colors(planes_.color);
    if (planes_.back.empty()) return;
    set_buffer(DrawBuffer::Back);
    write_colors(planes_.back);
}

void Restorer::restore_values(Plane plane, std::vector<std::uint32_t> values) {
    if (std::ranges::all_of(values, [](std::uint32_t v) { return v == 0; })) return;
    list.add(WritePixels{.rect = window_, .plane = plane, .values = std::move(values)});
}

}  // namespace

CommandList restoring_list(const Planes& planes, const Profile& profile, const std::string& pass,
                           const gw::State& state) {
    Restorer restorer(planes, profile, pass);
    restorer.restore_accum();
    restorer.restore_colors();
    restorer.restore_values(Plane::Depth, planes.depth);
    restorer.restore_values(Plane::Stencil, {planes.stencil.begin(), planes.stencil.end()});
    restorer.list.add(SetState{state});
    return std::move(restorer.list);
}

CommandList restoring_list(const std::map<std::uint32_t, SurfaceValues>& surfaces,
                           const std::string& pass, std::uint32_t in_use, const gw::State& state) {
    CommandList list;
    list.add(BeginPass{pass});
    list.add(SetState{gw::State()});
    for (const auto& [number, from] : surfaces) {
        list.add(MakeSurface{number, from.surface});
        list.add(UseSurface{number});
        for (const Readback& part : from.parts)
            list.add(WritePixels{.rect = part.rect,
                                 .plane = part.plane,
                                 .colors = part.color,
                                 .values = {part.values.begin(), part.values.end()}});
    }
    list.add(UseSurface{in_use});
    list.add(SetState{state});
    return list;
}

}  // namespace gw::gl
