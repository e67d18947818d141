// Random lists with one wrong value: both machines refuse a list with the same message and draw
// nothing, or they accept it and agree. Does not know which values are wrong.
#include "tests/fuzz/run.h"
#include "tests/gw/workbench.h"

#include <limits>
#include <type_traits>

namespace gw::fuzz {
namespace {

double any_number(Random& r) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return r.pick({std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -1.0, 0.0, 1e-40,
                   1e300, 129.0});
}

int any_integer(Random& r) {
    constexpr int largest = std::numeric_limits<int>::max();
    return r.pick({-1, 0, 1, 32, 129, 4096, 4097, -4097, largest, -largest - 1});
}

/// Any bit pattern of the field's type; a bool stays a bool.
template <class T>
void spoil(Random& r, T& field) {
    if constexpr (std::is_same_v<T, bool>)
        field = !field;
    else if constexpr (std::is_enum_v<T>)
        field = static_cast<T>(r.bits(8));
    else if constexpr (std::is_floating_point_v<T>)
        field = static_cast<T>(any_number(r));
    else if constexpr (sizeof(T) == 1)
        field = static_cast<T>(r.bits(8));
    else
        field = static_cast<T>(any_integer(r));
}
void spoil(Random& r, Rect& rect) {
    spoil(r, *r.pick({&rect.x, &rect.y, &rect.width, &rect.height}));
}
void spoil(Random& r, vec4& v) { spoil(r, v[r.below(4)]); }
void spoil(Random& r, dmat4& m) { spoil(r, m[r.below(4)][r.below(4)]); }

void spoil(Random& r, StencilState& s);
void spoil(Random& r, TextureState& t);
void spoil(Random& r, FogState& f);

/// Spoils one of the fields.
template <class... Fields>
void spoil_one(Random& r, Fields&... fields) {
    int chosen = r.below(int(sizeof...(fields)));
    const auto spoil_chosen = [&](auto& field) {
        if (chosen-- == 0) spoil(r, field);
    };
    (spoil_chosen(fields), ...);
}

void spoil(Random& r, StencilState& s) {
    spoil_one(r, s.test, s.func, s.fail, s.zfail, s.zpass, s.mask, s.write_mask, s.ref, s.two_side,
              s.back.func, s.back.fail, s.back.zfail, s.back.zpass, s.back.write_mask);
}
void spoil(Random& r, TextureState& t) {
    spoil_one(r, t.min_filter, t.mag_filter, t.wrap_s, t.wrap_t, t.env, t.gen, t.env_color, t.eta,
              t.eye_linear, t.shadow_compare);
}
void spoil(Random& r, FogState& f) {
    spoil_one(r, f.enable, f.mode, f.coordinate, f.density, f.start, f.end, f.color);
}

void spoil_command(Random& r, BeginPass& c) { spoil(r, c.digests); }
void spoil_command(Random& r, Clear& c) {
    spoil_one(r, c.planes, c.color, c.depth, c.stencil, c.accum);
}
void spoil_command(Random& r, SetState& c) {
    State& s = c.state.edit();
    spoil_one(r, s.projection, s.viewport.x, s.viewport.width, s.depth_range.far_value,
              s.clip_planes[1].plane[2], s.cull.face, s.cull.front, s.polygon_mode,
              s.polygon_offset.factor, s.jitter.x, s.point_size, s.line_width, s.shade_model,
              s.color_source, s.lighting.model_ambient, s.fog, s.fog, s.texture, s.texture,
              s.scissor.box, s.alpha.func, s.alpha.ref, s.stencil, s.stencil, s.depth.func,
              s.blend.src, s.blend.dst, s.draw_buffer, s.read_buffer);
}
void spoil_command(Random& r, Draw& c) {
    if (r.chance(10)) c.mesh = nullptr;
    if (r.chance(10)) c.map.slot = r.bits(9);
    spoil_one(r, c.eye_from_object, c.material.Kd.y, c.material.Ns, c.material.alpha, c.id_shift,
              c.id_base);
}
void spoil_command(Random& r, WriteSpans& c) {
    if (c.spans.empty()) return spoil(r, c.depth);
    Span& s = c.spans[std::size_t(r.below(int(c.spans.size())))];
    spoil_one(r, s.x, s.y, s.length, s.first, c.depth);
}
void spoil_command(Random& r, WritePixels& c) {
    if (r.chance(10)) c.values.push_back(~0u);
    spoil_one(r, c.rect, c.plane, c.depth);
}
void spoil_command(Random& r, Accumulate& c) { spoil_one(r, c.op, c.value); }
void spoil_command(Random& r, Copy& c) { spoil_one(r, c.plane, c.source, c.x, c.y); }
void spoil_command(Random& r, CopyTexture& c) { spoil_one(r, c.slot, c.plane, c.rect); }
void spoil_command(Random& r, DrawPixels& c) {
    if (r.chance(10)) c.stencils.push_back(~0u);
    if (r.chance(10)) c.source = {Plane(r.bits(3)), 0, int(r.bits(20))};
    spoil_one(r, c.width, c.raster.x, c.raster.depth, c.raster.texcoord, c.raster.distance,
              c.zoom_y);
}
void spoil_command(Random&, SwapBuffers&) {}
void spoil_command(Random& r, Read& c) { spoil_one(r, c.plane, c.rect, c.packed); }

/// Changes one field of one command: a mask, an enumeration, a number or a size. Most results are
/// invalid lists; the others are valid with an unusual value.
void corrupt(Random& r, CommandList& list) {
    if (list.commands.empty()) return;
    Command& command = list.commands[std::size_t(r.below(int(list.commands.size())))];
    std::visit([&](auto& c) { spoil_command(r, c); }, command);
}

std::string refusal(Machine& machine, const CommandList& list) {
    return test::error_of([&] { machine.execute(list); });
}

/// Empty if the machines agree about the list; `refused` says whether they refuse it.
std::string disagreement_about(const Case& c, bool& refused) {
    const auto reference = make_reference(c.profile, c.width, c.height),
               fast = make_fast(c.profile, c.width, c.height, {.threads = 1});
    const std::string message = refusal(*reference, c.list);
    refused = !message.empty();
    if (const std::string other = refusal(*fast, c.list); other != message)
        return "'" + message + "' and '" + other + "'";
    if (!refused)
        return run_case(c, machine_named("reference"), machine_named("fast")) ? "other bits" : "";
    const Planes untouched(c.width, c.height, c.profile.color_planes);
    const bool drawn = reference->planes() != untouched || fast->planes() != untouched ||
                       !reference->passes().empty() || !fast->passes().empty();
    return drawn ? "something was drawn before: " + message : "";
}

TEST(CorruptedLists, AreRefusedOrDrawnAlikeByBothMachines) {
    int refused = 0, accepted = 0;
    for (const Suite& suite : suites())
        for (std::uint64_t index = 0; index < 60; ++index) {
            Case c = make_case(suite, index);
            Random random(seed_of("corrupted", index));
            corrupt(random, c.list);
            bool is_refused = false;
            EXPECT_EQ(disagreement_about(c, is_refused), "") << suite.name << ' ' << index;
            (is_refused ? refused : accepted) += 1;
        }
    EXPECT_GT(refused, 400);
    EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace gw::fuzz
