// The context, and a list's commands one after the other.
#include "inspect/peer/player.h"

#include "gw/error.h"
#include "gw/names.h"
#include "inspect/peer/commands.h"
#include "inspect/peer/gl.h"
#include "inspect/peer/textures.h"

#include <GL/osmesa.h>
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

OSMesaContext new_context() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_ACCUM_BITS,
                              16,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              0};
    return gl().OSMesaCreateContextAttribs(attributes, nullptr);
}

/// State that differs from OpenGL's initial state for good.
void set_up() {
    gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().Disable(GL_DITHER);
}

void check_errors() {
    const GLenum error = gl().GetError();
    if (error != GL_NO_ERROR) throw Error(fmt::format("OpenGL's error {:#x}", error));
}

}  // namespace

struct Player::Context {
    Profile profile;
    int width, height;
    std::vector<GLubyte> buffer;  ///< OSMesa's colour plane
    OSMesaContext mesa = nullptr;
    Textures textures;
    ListContext before;

    Context(const Profile& p, int w, int h)
        : profile(p),
          width(w),
          height(h),
          buffer(std::size_t{4} * std::size_t(w) * std::size_t(h)),
          mesa(new_context()) {
        if (!mesa)
            throw Error("OSMesa cannot make a context of 8 colour, 24 depth and 8 stencil bits");
        make_current();
        set_up();
        apply(before.state, width, height);
    }
    ~Context() { gl().OSMesaDestroyContext(mesa); }

    void make_current() {
        if (!gl().OSMesaMakeCurrent(mesa, buffer.data(), GL_UNSIGNED_BYTE, width, height))
            throw Error(fmt::format("OSMesa refuses a window of {}x{}", width, height));
    }

    void run(const BeginPass&) {}
    void run(const Read&) {}
    void run(const SwapBuffers&) {
        throw Error("no back plane to swap: OpenGL's window here has one colour plane");
    }
    void run(const Clear& c) { clear(c); }
    void run(const SetState& c) {
        before.state = c.state;
        apply(c.state, width, height);
    }
    void run(const Draw& c) {
        const bool textured = textures.bind(c.map, before.state.texture);
        draw(c, before.state, profile, width, height, textured);
    }
    void run(const WriteSpans& c) { write(c); }
    void run(const WritePixels& c) { write(c, before.state.depth); }
    void run(const DrawPixels& c) {
        const bool textured = textures.bind(c.map, before.state.texture);
        draw(c, before.state, textured);
    }
    void run(const Accumulate& c) { accumulate(c); }
    void run(const Copy& c) { copy(c, before.state.depth); }
    void run(const CopyTexture& c) {
        textures.copy(c);
        before.slots[c.slot] = c.plane;
    }
};

Player::Player(const Profile& profile, int width, int height) {
    check_window(width, height);
    check_profile(profile);
    context_ = std::make_unique<Context>(profile, width, height);
}

Player::~Player() = default;

void Player::play(const CommandList& list, std::size_t count) {
    validate(list, context_->profile, context_->width, context_->height, context_->before);
    context_->make_current();
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
    context_->make_current();
    return read_planes(context_->width, context_->height);
}

std::string Player::renderer() const {
    context_->make_current();
    const auto text = [](GLenum name) {
        return reinterpret_cast<const char*>(gl().GetString(name));
    };
    return fmt::format("{}, {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace gw::peer
