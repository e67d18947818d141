#include "gl/drawable/off_screen.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <string>

namespace gw::gl {

namespace {

constexpr std::size_t surface_plane_count = 3;

std::string next_name() {
    static std::atomic<int> count = 0;
    return "framebuffers " + std::to_string(++count);
}

}  // namespace

SurfaceImage::SurfaceImage(std::shared_ptr<OffScreen> on, const Surface& kind, bool opaque)
    : machine(std::move(on)),
      width(kind.width),
      height(kind.height),
      depth_bits(kind.depth_bits),
      samples(kind.samples),
      is_opaque(opaque) {}

SurfaceImage::~SurfaceImage() {
    const auto lock = machine->exclusive();
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        machine->leave({this, plane});
}

OffScreen::OffScreen(const Profile& of) : Drawable(of, 1, 1, next_name()) {}

bool OffScreen::suits(std::uint32_t number, std::span<const ImagePlane> planes, int width,
                      int height) const {
    const Surface& surface = surfaces_[number - 1];
    return surface.width == width && surface.height == height &&
           std::ranges::all_of(planes, [&](const ImagePlane& p) {
               const SurfaceImage* const owner = owners_[number - 1][std::size_t(p.plane)];
               return surface.has(p.plane) && surface.samples == p.image->samples &&
                      (owner == nullptr || owner == p.image) &&
                      (p.plane != Plane::Depth || surface.depth_bits == p.image->depth_bits);
           });
}

std::uint32_t OffScreen::free_number() const {
    const auto free = std::ranges::find(surfaces_, 0, &Surface::width);
    const auto number = std::uint32_t(free - surfaces_.begin()) + 1;
    if (number > max_surfaces) throw std::bad_alloc();
    return number;
}

std::uint32_t OffScreen::make(std::span<const ImagePlane> planes, int width, int height) {
    end_unused();
    Surface made{.width = width, .height = height};
    for (const ImagePlane& p : planes) {
        made.planes |= mask_of(p.plane);
        made.samples = p.image->samples;
        if (p.plane == Plane::Depth) made.depth_bits = p.image->depth_bits;
    }
    const std::uint32_t number = free_number();
    add(MakeSurface{number, made});  // first: a recording that begins here does not know it yet
    if (number > surfaces_.size()) {
        surfaces_.push_back(made);
        owners_.emplace_back();
    } else {
        surfaces_[number - 1] = made;
    }
    ++made_;
    return number;
}

std::uint32_t OffScreen::gather(std::span<const ImagePlane> planes) {
    const auto lock = exclusive();
    int width = 0, height = 0;
    for (const ImagePlane& p : planes) {
        width = std::max(width, p.image->width);
        height = std::max(height, p.image->height);
    }
    std::uint32_t to = 0;
    for (const ImagePlane& p : planes) {
        const std::uint32_t home = p.image->surface(p.plane);
        if (to == 0 && home != 0 && suits(home, planes, width, height)) to = home;
    }
    if (to == 0) to = make(planes, width, height);
    for (const ImagePlane& p : planes) move(p, to);
    return to;
}

std::uint32_t OffScreen::surface_of(const ImagePlane& p, bool alone) {
    const auto lock = exclusive();
    const std::uint32_t home = p.image->surface(p.plane);
    const std::span<const ImagePlane> planes(&p, 1);
    if (home == 0) return gather(planes);
    const bool stays = !alone || (home != in_use_ && surfaces_[home - 1].width == p.image->width &&
                                  surfaces_[home - 1].height == p.image->height);
    if (stays) return home;
    const std::uint32_t used = in_use_;
    const std::uint32_t to = make(planes, p.image->width, p.image->height);
    move(p, to);
    use(used);
    return to;
}

void OffScreen::use(std::uint32_t surface) {
    const auto lock = exclusive();
    if (surface == in_use_) return;
    add(UseSurface{surface});
    in_use_ = surface;
}

void OffScreen::use_plainly(std::uint32_t surface) {
    use(surface);
    set_state(gw::State());
}

void OffScreen::move(const ImagePlane& p, std::uint32_t to) {
    const std::uint32_t from = p.image->surface(p.plane);
    if (from == to) return;
    use_plainly(to);
    const Rect all{0, 0, p.image->width, p.image->height};
    if (from != 0)
        add(Blit{.from_surface = from, .planes = mask_of(p.plane), .source = all, .target = all});
    else
        add(gw::Clear{.planes = mask_of(p.plane),
                      .color = {0, 0, 0, p.image->is_opaque ? 1 : 0},
                      .depth = 0});
    leave(p);
    owners_[to - 1][std::size_t(p.plane)] = p.image;
    p.image->surfaces[std::size_t(p.plane)] = to;
}

void OffScreen::leave(const ImagePlane& p) {
    const std::uint32_t from = std::exchange(p.image->surfaces[std::size_t(p.plane)], 0u);
    if (from == 0) return;
    auto& owners = owners_[from - 1];
    owners[std::size_t(p.plane)] = nullptr;
    const bool is_used =
        std::ranges::any_of(owners, [](const SurfaceImage* owner) { return owner != nullptr; });
    if (!is_used) unused_.push_back(from);
}

/// Not at once: a program that ends draws no more.
void OffScreen::end_unused() {
    for (const std::uint32_t number : std::exchange(unused_, {})) {
        const bool is_used = std::ranges::any_of(
            owners_[number - 1], [](const SurfaceImage* owner) { return owner != nullptr; });
        if (is_used || surfaces_[number - 1].width == 0) continue;
        if (number == in_use_) use(0);
        --made_;
        add(MakeSurface{number, {}});
        surfaces_[number - 1] = {};
    }
}

bool OffScreen::is_full() {
    const auto lock = exclusive();
    constexpr std::size_t most = max_surfaces - surface_plane_count;  // one for each plane
    if (made_ > most) end_unused();
    return made_ > most;
}

void OffScreen::write(const ImagePlane& p, std::vector<Rgba> colors,
                      std::vector<std::uint32_t> values) {
    const auto lock = exclusive();
    const PausedCounts paused(*this);
    use_plainly(surface_of(p, false));
    hold(colors.size() * sizeof(Rgba) + values.size() * sizeof(std::uint32_t));
    add(WritePixels{.rect = {0, 0, p.image->width, p.image->height},
                    .plane = p.plane,
                    .colors = std::move(colors),
                    .values = std::move(values)});
}

void OffScreen::write_from(const ImagePlane& p, std::uint32_t surface) {
    const auto lock = exclusive();
    use_plainly(surface_of(p, false));
    const Rect all{0, 0, p.image->width, p.image->height};
    add(Blit{.from_surface = surface, .planes = mask_of(p.plane), .source = all, .target = all});
}

Readback OffScreen::read_plane(const ImagePlane& p, Cause cause) {
    const auto lock = exclusive();
    use(surface_of(p, false));
    return read(p.plane, {0, 0, p.image->width, p.image->height}, cause);
}

std::vector<Readback> OffScreen::read_surface(std::uint32_t number) {
    const auto lock = exclusive();
    Surface surface = surfaces_[number - 1];
    CommandList list;
    const bool has_samples = std::exchange(surface.samples, 0) > 0;
    const std::uint32_t spare = has_samples ? free_number() : 0;
    if (has_samples) {
        const Rect all{0, 0, surface.width, surface.height};
        list.add(SetState{gw::State()});
        list.add(MakeSurface{spare, surface});
        list.add(UseSurface{spare});
        list.add(
            Blit{.from_surface = number, .planes = surface.planes, .source = all, .target = all});
    } else {
        list.add(UseSurface{number});
    }
    std::uint32_t key = 0;
    for (int y = 0; y < surface.height; y += max_window_size)
        for (int x = 0; x < surface.width; x += max_window_size) {
            const Rect part{x, y, std::min(surface.width - x, max_window_size),
                            std::min(surface.height - y, max_window_size)};
            for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
                if (surface.has(plane)) list.add(Read{key++, plane, part});
        }
    list.add(UseSurface{in_use_});
    if (has_samples) {
        list.add(MakeSurface{spare, {}});
        list.add(SetState{*state()});
    }
    const auto& reads = execute_reads(list);
    std::vector<Readback> out;
    for (std::uint32_t read = 0; read < key; ++read) out.push_back(reads.at(read));
    return out;
}

}  // namespace gw::gl
