#include "multipass/ties/one_winner.h"

#include "multipass/frame/commands.h"
#include "multipass/passes/catalogue.h"

#include <algorithm>

namespace gw::multipass {
namespace {

/// Counts winners: under Equal, stencil + 1.
const Pass winners_pass{
    .name = "count winners",
    .depth = seen,
    .stencil = {.test = true, .func = StencilFunc::Always, .zpass = StencilOp::Incr},
    .color = false,
    .objects = PassObjects::Opaque,
};

/// Only where the pixel is not taken yet; takes it.
StencilState taking(StencilState stencil, std::uint32_t taken) {
    if (!stencil.test) stencil = {.test = true, .func = StencilFunc::Equal, .ref = 0, .mask = 0};
    stencil.mask |= taken;
    stencil.zpass = StencilOp::Invert;
    stencil.write_mask = taken;
    return stencil;
}

std::uint32_t tie_of(int stencil_bits) { return 1u << (stencil_bits - 1); }
std::uint32_t taken_of(int stencil_bits) { return 1u << (stencil_bits - 2); }

/// Fragments on tied pixels only, for the stencil.
void write_ties(CommandList& list, const PlacedModel& placed, const TiedPixels& tied,
                const StencilState& stencil) {
    State state = placed.state;
    state.depth = {};
    state.color_mask = {false, false, false, false};
    state.stencil = stencil;
    list.add(SetState{state});
    list.add(WriteSpans{.spans = tied.spans, .colors = {Rgba{}}});
}

}  // namespace

CommandList count_winners(const PlacedModel& placed) {
    CommandList list;
    add_step(list, placed, {.pass = winners_pass}, {});
    State state = placed.state;
    state.depth = {};
    state.color_mask = {false, false, false, false};
    state.stencil = {.test = true, .func = StencilFunc::NotEqual, .ref = 0};
    list.add(BeginPass{.name = "count pixels"});
    add_whole_window(list, state);
    list.add(Read{.key = winners_key,
                  .plane = Plane::Stencil,
                  .rect = {0, 0, placed.view.width, placed.view.height}});
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    return list;
}

std::uint64_t surplus_winners(std::span<const PassReport> reports) {
    return reports[0].counters.written - reports[1].counters.written;
}

/// Every opaque part, or what of it is in the portions, black where the step does not concern it.
void draw_first_come(CommandList& list, const PlacedModel& placed, const Step& step, State state,
                     const std::vector<Portion>& portions) {
    bool set = false;
    for (const Portion& portion : portions) {
        const Part& part = placed.model->parts[portion.part];
        if (part.translucent && !concerns(step, part, *placed.model)) continue;
        const TextureState lookup = lookup_of(placed, step, portion.part);
        if (!set || !(lookup == state.texture)) {
            state.texture = lookup;
            list.add(SetState{state});
            set = true;
        }
        list.add(draw_of(placed, step, portion));
    }
}

void add_one_winner_step(CommandList& list, const PlacedModel& placed, const Step& step,
                         int stencil_bits) {
    State state = state_of(placed, step);
    state.stencil = taking(state.stencil, 1u << (stencil_bits - 1));
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    std::vector<Portion> all;
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i) all.push_back({.part = i});
    draw_first_come(list, placed, step, state, all);
}

bool can_mark_ties(const PlacedModel& placed, int stencil_bits) {
    return stencil_bits >= 3 && placed.state.shade_model == ShadeModel::Smooth &&
           placed.state.polygon_mode == PolygonMode::Fill;
}

bool can_leave_ties_out(const PlacedModel& placed, const Step& step, int stencil_bits) {
    const StencilState& s = step.pass.stencil;
    const bool fits =
        !s.test || (s.func == StencilFunc::Equal && std::uint32_t(s.ref) < taken_of(stencil_bits));
    return fits && std::none_of(placed.model->parts.begin(), placed.model->parts.end(),
                                [&](const Part& part) {
                                    return part.translucent && concerns(step, part, *placed.model);
                                });
}

void mark_ties(CommandList& list, const PlacedModel& placed, const TiedPixels& tied,
               int stencil_bits) {
    const std::uint32_t bit = tie_of(stencil_bits);
    write_ties(list, placed, tied,
               {.test = true, .ref = int(bit), .zpass = StencilOp::Replace, .write_mask = bit});
}

StencilState beside_ties(StencilState stencil, int stencil_bits) {
    if (!stencil.test) stencil = {.test = true, .func = StencilFunc::Equal, .ref = 0, .mask = 0};
    stencil.mask |= tie_of(stencil_bits);
    return stencil;
}

void draw_ties(CommandList& list, const PlacedModel& placed, const Step& step,
               const TiedPixels& tied, int stencil_bits) {
    State state = state_of(placed, step);
    state.stencil = taking(beside_ties(state.stencil, stencil_bits), taken_of(stencil_bits));
    state.stencil.ref |= int(tie_of(stencil_bits));
    draw_first_come(list, placed, step, state, tied.portions);
    write_ties(list, placed, tied,
               {.test = true,
                .zpass = StencilOp::Zero,
                .write_mask = tie_of(stencil_bits) | taken_of(stencil_bits)});
}

}  // namespace gw::multipass
