#include "conformance/generate/script.h"

#include "conformance/generate/pixels.h"

#include <fmt/format.h>

#include <optional>

namespace gw::conformance {
namespace {

/// A side, mostly small, seldom a few tiles of 64, so that a list stays cheap.
int any_window_side(Random& r) {
    const int kind = r.below(100);
    if (kind < 6) return 1;
    if (kind < 20) return r.between(1, 9);
    if (kind < 70) return r.between(8, 40);
    if (kind < 80) return r.pick({63, 64, 65});
    if (kind < 95) return r.between(40, 110);
    return r.between(100, 200);
}

const State* last_state(const CommandList& list) {
    for (auto command = list.commands.rbegin(); command != list.commands.rend(); ++command)
        if (const auto* set = std::get_if<SetState>(&*command)) return &*set->state;
    return nullptr;
}

}  // namespace

Profile user_profile(Random& r) {
    Profile p{.name = "user"};
    p.color_bits = r.chance(40) ? 8 : r.between(8, 16);
    p.depth_bits = r.between(16, 32);
    p.stencil_bits = r.between(1, 8);
    p.accum_bits = r.between(16, 32);
    p.subpixel_bits = r.between(1, 8);
    p.lit_bits = r.between(4, p.color_bits);
    p.max_lights = r.between(1, 12);
    p.fragment_fog = r.chance(50);
    p.perspective_color = r.chance(50);
    p.extensions.polygon_offset = r.chance(50);
    p.extensions.shadow_texture = r.chance(50);
    p.extensions.stencil_wrap = r.chance(50);
    p.extensions.two_sided_stencil = r.chance(50);
    return p;
}

Profile opengl_up_to(bool Extensions::*last) {
    Profile p = opengl();
    bool is_later = false;
    for (const auto& [name, member] : extension_names()) {
        if (is_later) p.extensions.*member = false;
        if (member == last) is_later = true;
    }
    return p;
}

namespace {

Profile any_like(Random& r, const Profile& profile) {
    if (r.chance(50)) return profile;
    Profile p = user_profile(r);
    const Extensions own = p.extensions;
    p.extensions = profile.extensions;
    p.extensions.polygon_offset = own.polygon_offset;
    p.extensions.stencil_wrap = own.stencil_wrap;
    p.extensions.two_sided_stencil = own.two_sided_stencil;
    return p;
}

}  // namespace

Profile any_opengl_profile(Random& r, bool Extensions::*last) {
    return any_like(r, opengl_up_to(last));
}

Profile any_profile(Random& r) { return r.chance(70) ? r.pick(paper_profiles()) : user_profile(r); }

Script script(Random& random, const Profile& profile) {
    Script s{random, {profile}};
    s.out.width = any_window_side(random);
    s.out.height = s.out.width > 110 ? random.between(1, 150) : any_window_side(random);
    s.frame = any_frame(random, s.out.width, s.out.height, profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    if (random.chance(90)) {
        Clear clear = any_clear(random);
        clear.planes = all_planes;
        if (random.chance(80)) clear.depth = 1;
        s.out.list.add(clear);
    }
    return s;
}

Script script(Random& random) { return script(random, any_profile(random)); }

Script pixel_script(Random& random, const Profile& profile, int width, int height) {
    Script s{random, {profile, width, height}};
    s.frame = {width, height, profile.subpixel_bits};
    s.state.projection[0][0] = 2.0 / width;
    s.state.projection[1][1] = 2.0 / height;
    s.state.projection[3] = {-1, -1, 0, 1};
    return s;
}

void set_state(Script& s) {
    const State* last = last_state(s.out.list);
    if (s.state != (last ? *last : State{})) s.out.list.add(SetState{s.state});
}

void add(Script& s, Command command) {
    set_state(s);
    s.out.list.add(std::move(command));
}

void between_draws(Script& s) {
    Random& r = s.random;
    if (r.chance(12))
        s.out.list.add(
            BeginPass{fmt::format("pass {}", s.out.list.commands.size()),
                      r.chance(50) ? static_cast<PlaneMask>(r.below(16)) : PlaneMask{0}});
    if (r.chance(5)) s.out.list.add(any_read(r, s.out));
}

}  // namespace gw::conformance
