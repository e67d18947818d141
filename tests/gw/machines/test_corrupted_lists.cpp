// Random lists with one wrong value: both machines refuse a list with the same message and draw
// nothing, or they accept it and agree. Does not know which values are wrong.
#include "gw/describe/state_fields.h"
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

void spoil(Random& r, dvec4& v) { spoil(r, v[r.below(4)]); }
void spoil(Random& r, PolygonStippleState& s) {
    const std::array<std::uint32_t, 32> rows{r.bits(32), r.bits(32)};
    s.pattern =
        r.chance(50) ? nullptr : std::make_shared<const std::array<std::uint32_t, 32>>(rows);
}

void spoil(Random& r, MoreTextures& more) {
    std::array<TextureState, max_texture_units - 1> units;
    TextureState& unit = units[std::size_t(r.below(3))];
    spoil(r, r.pick({&unit.wrap_s, &unit.wrap_r})[0]);
    more.units = r.chance(50) ? nullptr : std::make_shared<const decltype(units)>(units);
}

/// Spoils one of the fields.
template <class... Fields>
void spoil_one(Random& r, Fields&... fields) {
    int chosen = r.below(int(sizeof...(fields)));
    const auto spoil_chosen = [&](auto& field) {
        if (chosen-- == 0) spoil(r, field);
    };
    (spoil_chosen(fields), ...);
}

void spoil_command(Random& r, BeginPass& c) { spoil(r, c.digests); }
void spoil_command(Random& r, Clear& c) {
    spoil_one(r, c.planes, c.color, c.depth, c.stencil, c.accum);
}
void spoil_command(Random& r, SetState& c) {
    // One of all values of the state, as the description counts them.
    State& state = c.state.edit();
    int count = 0;
    for_each_value(state, [&](const Path&, const Plain auto&, const auto&) { ++count; });
    int chosen = r.below(count);
    for_each_value(state, [&](const Path&, const Plain auto& value, const auto&) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if (chosen-- == 0) spoil(r, const_cast<Value&>(value));
    });
}
void spoil_command(Random& r, Draw& c) {
    if (r.chance(10)) c.mesh = nullptr;
    if (r.chance(10)) c.map.slot = r.bits(9);
    if (c.map.surface && r.chance(30)) spoil_one(r, c.map.surface->surface, c.map.surface->plane);
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
void spoil_command(Random& r, Query& c) { spoil_one(r, c.key, c.begin); }
void spoil_command(Random& r, MakeSurface& c) {
    Surface& s = c.surface;
    spoil_one(r, c.number, s.width, s.height, s.planes, s.depth_bits);
}
void spoil_command(Random& r, UseSurface& c) { spoil(r, c.number); }
void spoil_command(Random& r, Blit& c) {
    spoil_one(r, c.from_surface, c.planes, c.source, c.target, c.flip_x, c.flip_y, c.filter);
}
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
