#include "gl/drawable/window_samples.h"

#include <variant>

namespace gw::gl {

namespace {

template <class... Commands>
bool is_one_of(const Command& command) {
    return (std::holds_alternative<Commands>(command) || ...);
}

/// The buffer that loads colours for a draw buffer.
gw::ReadBuffer source_of(DrawBuffer buffer) {
    return buffer == DrawBuffer::Front ? gw::ReadBuffer::Front : gw::ReadBuffer::Back;
}

}  // namespace

int offered_window_samples(const Profile& profile) {
    return profile.extensions.surfaces && profile.extensions.multisample ? 4 : 0;
}

int fitting_samples(int width, int height, int wanted) {
    while (wanted > 1 && std::int64_t{width} * height * wanted > max_surface_samples) wanted /= 2;
    return wanted > 1 ? wanted : 0;
}

gw::Blit WindowSamples::whole(std::uint32_t from, PlaneMask planes) const {
    const Rect all{0, 0, width_, height_};
    return {.from_surface = from, .planes = planes, .source = all, .target = all};
}

MakeSurface WindowSamples::own_surface() const {
    return {surface,
            {.width = width_, .height = height_, .planes = surface_planes, .samples = count_}};
}

void WindowSamples::use(std::uint32_t number, CommandList& out) {
    if (in_use_ == number) return;
    out.add(UseSurface{number});
    in_use_ = number;
}

void WindowSamples::make(CommandList& out) {
    if (is_made_) return;
    use(0, out);  // after an error, the surface may be there and in use
    out.add(own_surface());
    is_made_ = true;
}

void WindowSamples::resolve(PlaneMask planes, const gw::State& now, CommandList& out) {
    use(0, out);
    planes &= unresolved_;
    if (planes == 0) return;
    gw::State plain;
    plain.draw_buffer = buffer_.value_or(DrawBuffer::Front);
    out.add(SetState{plain});
    out.add(whole(surface, planes));
    out.add(SetState{now});
    unresolved_ &= PlaneMask(~planes);
}

void WindowSamples::resolve_read(Plane plane, const gw::State& now, CommandList& out) {
    const bool is_of_other = plane == Plane::Color && buffer_ &&
                             *buffer_ != DrawBuffer::FrontAndBack &&
                             source_of(*buffer_) != now.read_buffer;
    resolve(is_of_other ? PlaneMask{0} : mask_of(plane), now, out);
}

void WindowSamples::load_colors(const gw::State& now, CommandList& out) {
    resolve(mask_of(Plane::Color), now, out);
    use(surface, out);
    gw::State plain;
    plain.read_buffer = source_of(now.draw_buffer);
    out.add(SetState{plain});
    out.add(whole(0, mask_of(Plane::Color)));
    out.add(SetState{now});
    buffer_ = now.draw_buffer;
}

void WindowSamples::draw(const gw::State& now, CommandList& out) {
    make(out);
    if (now.draw_buffer != DrawBuffer::None && buffer_ != now.draw_buffer) load_colors(now, out);
    use(surface, out);
    unresolved_ = surface_planes;
    if (!buffer_) unresolved_ &= PlaneMask(~mask_of(Plane::Color));
}

void WindowSamples::prepare(const Command& command, const gw::State& now, CommandList& out) {
    if (const auto* other = std::get_if<UseSurface>(&command)) {
        in_use_ = other->number;
        return;
    }
    if (in_use_.value_or(0) > surface) return;  // planes on their way to the window
    if (const auto* clear = std::get_if<gw::Clear>(&command);
        clear && (clear->planes & mask_of(Plane::Accum)) != 0) {
        use(0, out);
        gw::Clear accum = *clear;
        accum.planes = mask_of(Plane::Accum);
        out.add(accum);
    }
    if (is_one_of<SwapBuffers, Accumulate>(command)) resolve(mask_of(Plane::Color), now, out);
    if (const auto* accumulate = std::get_if<Accumulate>(&command);
        accumulate && accumulate->op == AccumOp::Return)
        buffer_ = std::nullopt;
    if (const auto* blit = std::get_if<gw::Blit>(&command); blit && blit->from_surface == 0)
        resolve(blit->planes, now, out);
    if (is_one_of<gw::Clear, Draw, gw::DrawPixels, WriteSpans, WritePixels, gw::Blit>(command))
        draw(now, out);
}

bool WindowSamples::follow_swap() {
    const bool is_back = buffer_ == DrawBuffer::Back || buffer_ == DrawBuffer::FrontAndBack;
    buffer_ = is_back ? std::optional(DrawBuffer::Back) : std::nullopt;
    if (is_back) unresolved_ |= mask_of(Plane::Color);
    return is_back;
}

void WindowSamples::forget() {
    is_made_ = false;
    in_use_ = std::nullopt;
    buffer_ = std::nullopt;
    unresolved_ = 0;
}

CommandList WindowSamples::remade(const gw::State& now) const {
    CommandList out;
    if (!is_made_) return out;
    gw::State plain;
    plain.read_buffer = source_of(buffer_.value_or(DrawBuffer::Front));
    out.add(own_surface());
    out.add(UseSurface{surface});
    out.add(SetState{plain});
    out.add(whole(0, surface_planes));
    out.add(UseSurface{in_use_.value_or(0)});
    out.add(SetState{now});
    return out;
}

}  // namespace gw::gl
