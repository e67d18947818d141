// Counting winners, and taking pixels.
#include "multipass/one_winner.h"

#include "multipass/catalogue.h"
#include "multipass/commands.h"
#include "multipass/whole_window.h"

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

}  // namespace

CommandList count_winners(const Stage& stage) {
    CommandList list;
    add_step(list, stage, {.pass = winners_pass}, {});
    State state = stage.state;
    state.depth = {};
    state.color_mask = {false, false, false, false};
    state.stencil = {.test = true, .func = StencilFunc::NotEqual, .ref = 0};
    begin_pass(list, "count pixels", state);
    list.add(whole_window(stage.view));
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    return list;
}

std::uint64_t surplus_winners(std::span<const PassReport> reports) {
    return reports[0].counters.written - reports[1].counters.written;
}

bool keeps_stencil(const StencilState& s) {
    return s.fail == StencilOp::Keep && s.zfail == StencilOp::Keep && s.zpass == StencilOp::Keep;
}

bool is_additive(const Pass& pass) {
    return pass.depth.test && pass.depth.func == DepthFunc::Equal && pass.blend.enable &&
           keeps_stencil(pass.stencil);
}

void add_one_winner_step(CommandList& list, const Stage& stage, const Step& step, int stencil_bits) {
    State state = state_of(stage, step);
    state.stencil = taking(state.stencil, 1u << (stencil_bits - 1));
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    const auto& parts = stage.model->parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool concerned = concerns(step, parts[i], *stage.model);
        if (!concerned && parts[i].translucent) continue;
        state.texture = lookup_of(stage, step, i);
        list.add(SetState{state});
        list.add(draw_of(stage, step, {.part = i}));
    }
}

}  // namespace gw::multipass
