// The context, and a list's commands one after the other.
#include "inspect/peer/player.h"

#include "gw/error.h"
#include "gw/names.h"
#include "inspect/peer/color_planes.h"
#include "inspect/peer/commands.h"
#include "inspect/peer/framebuffers.h"
#include "inspect/peer/gl.h"
#include "inspect/peer/occlusion.h"
#include "inspect/peer/surface.h"
#include "inspect/peer/textures.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::peer {
namespace {

void check_profile(const Profile& p) {
    if (p.color_bits == 8 && p.depth_bits == 24 && p.stencil_bits == 8) return;
    throw Error(fmt::format(
        "profile {} has planes of {} colour, {} depth and {} stencil bits; OpenGL's here have "
        "8, 24 and 8",
        p.name, p.color_bits, p.depth_bits, p.stencil_bits));
}

/// State that differs from OpenGL's initial state for good.
void set_up() {
    gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().Disable(GL_DITHER);
    gl().ReadBuffer(gl().color_buffer);
}

/// The papers' programs add up to 128 pictures on machines without OpenGL's range; programs of
/// OpenGL keep to the range.
float accum_divisor(const Profile& profile) { return profile.extensions.draw_pixels ? 1 : 128; }

void check_errors() {
    const GLenum error = gl().GetError();
    if (error != GL_NO_ERROR) throw Error(fmt::format("OpenGL's error {:#x}", error));
}

}  // namespace

struct Player::Context {
    Profile profile;
    int width, height;
    std::unique_ptr<Surface> surface;
    ColorPlanes colors;
    Textures textures;
    Framebuffers framebuffers;
    Occlusion occlusion;
    ListContext before;

    Context(const Profile& p, int w, int h, const std::string& implementation)
        : profile(p),
          width(w),
          height(h),
          surface(make_surface(implementation, w, h)),
          colors(w, h) {
        surface->make_current();
        set_up();
        apply_state();
        // A machine's planes begin with 0.
        clear({.planes = all_planes, .depth = 0}, 1);
    }

    /// The width or height of what is drawn to.
    int extent(int gw::Surface::*side, int of_window) const {
        const gw::Surface* const target = framebuffers.surface();
        return target ? target->*side : of_window;
    }
    int target_width() const { return extent(&gw::Surface::width, width); }
    int target_height() const { return extent(&gw::Surface::height, height); }
    void apply_state() {
        apply(before.state, target_width(), target_height(), framebuffers.color_buffer());
    }

    Plane drawn() const {
        if (before.state.draw_buffer == DrawBuffer::FrontAndBack)
            throw Error("draw_buffer = FrontAndBack: the window here has one of the two at a time");
        return before.state.draw_buffer == DrawBuffer::Back ? Plane::Back : Plane::Color;
    }
    Plane read() const {
        return before.state.read_buffer == ReadBuffer::Back ? Plane::Back : Plane::Color;
    }
    /// The window has the plane that colours are drawn to.
    void show_drawn() {
        if (has_two_planes()) show(drawn());
    }
    void show_copied(Plane plane) {
        show_drawn();
        if (plane == Plane::Color && has_two_planes() && read() != drawn())
            throw Error("a copy from one colour plane to the other: the window here has one");
    }
    bool has_two_planes() const { return profile.color_planes == 2 && framebuffers.in_use() == 0; }
    /// Of the window, which is bound.
    void show(Plane plane) {
        if (colors.shown() != plane && occlusion.is_active())
            throw Error("a query while colours go from one plane to the other: they would count");
        colors.show(plane);
    }

    void run(const BeginPass&) {}
    void run(const Read&) {}
    void run(const SwapBuffers&) { colors.exchange(); }
    void run(const Query& c) {
        occlusion.run(c);
        follow(c, before);
    }
    void run(const MakeSurface& c) {
        const std::uint32_t in_use = framebuffers.in_use();
        framebuffers.make(c);
        if (c.surface.width == 0)
            before.surfaces.erase(c.number);
        else
            before.surfaces[c.number] = c.surface;
        run(UseSurface{in_use});
    }
    void run(const UseSurface& c) {
        framebuffers.use(c.number);
        before.surface = c.number;
        apply_state();
    }
    void run(const Blit& c) {
        const bool is_written = before.state.draw_buffer != DrawBuffer::None;
        const bool copies_colors = (c.planes & mask_of(Plane::Color)) != 0 && is_written;
        if (copies_colors && c.from_surface == 0 && framebuffers.in_use() == 0)
            show_copied(Plane::Color);
        else if (copies_colors && c.from_surface == 0)
            show_for_surface();
        else if (copies_colors)
            show_drawn();
        framebuffers.blit(c, is_written);
    }
    /// The window has the plane that colours are read from, while a surface is in use.
    void show_for_surface() {
        if (profile.color_planes != 2) return;
        const std::uint32_t in_use = framebuffers.in_use();
        run(UseSurface{0});
        show(read());
        run(UseSurface{in_use});
    }
    void run(const Clear& c) {
        show_drawn();
        clear(c, accum_divisor(profile));
    }
    void run(const SetState& c) {
        before.state = c.state;
        apply_state();
    }
    TextureTargets bind(const auto& command) {
        TextureTargets out{};
        for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
            const TextureBinding& map = map_of(command, unit);
            out[unit] = textures.bind(unit, map, texture_of(before.state, unit),
                                      map.surface ? framebuffers.texture_of(*map.surface) : 0);
        }
        return out;
    }
    void run(const Draw& c) {
        show_drawn();
        draw(c, before.state, profile, target_width(), target_height(), bind(c));
    }
    void run(const WriteSpans& c) {
        show_drawn();
        write(c);
    }
    void run(const WritePixels& c) {
        show_drawn();
        write(c, before.state.depth);
    }
    void run(const DrawPixels& c) {
        show_copied(c.source ? c.source->plane : Plane::Depth);
        draw(c, before.state, bind(c));
    }
    void run(const Accumulate& c) {
        const bool reads = c.op == AccumOp::Accum || c.op == AccumOp::Load;
        if (has_two_planes()) show(reads ? read() : drawn());
        accumulate(c, accum_divisor(profile));
    }
    void run(const Copy& c) {
        show_copied(c.plane);
        copy(c, before.state.depth);
    }
    void run(const CopyTexture& c) {
        if (has_two_planes()) show(read());
        textures.copy(c);
        before.slots[c.slot] = c.plane;
    }
};

Player::Player(const Profile& profile, int width, int height, const std::string& implementation) {
    check_window(width, height);
    check_profile(profile);
    context_ = std::make_unique<Context>(profile, width, height, implementation);
}

Player::~Player() = default;

void Player::play(const CommandList& list, std::size_t count) {
    validate(list, context_->profile, context_->width, context_->height, context_->before);
    context_->surface->make_current();
    for (std::size_t i = 0; i < std::min(count, list.commands.size()); ++i) {
        const Command& command = list.commands[i];
        try {
            std::visit([&](const auto& c) { context_->run(c); }, command);
            check_errors();
        } catch (const Error& error) {
            throw Error(fmt::format("command {} ({}): {}", i, name_of(command), error.what()));
        }
    }
}

Planes Player::planes() const {
    context_->surface->make_current();
    const std::uint32_t in_use = context_->framebuffers.in_use();
    context_->framebuffers.use(0);
    Planes planes = read_planes(context_->width, context_->height);
    context_->framebuffers.use(in_use);
    context_->colors.complete(planes, context_->profile.color_planes == 2);
    return planes;
}

const std::vector<QueryResult>& Player::queries() const { return context_->occlusion.results(); }

std::string Player::renderer() const {
    context_->surface->make_current();
    const auto text = [](GLenum name) {
        return reinterpret_cast<const char*>(gl().GetString(name));
    };
    return fmt::format("{}, {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace gw::peer
