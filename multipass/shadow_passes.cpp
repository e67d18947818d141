// Increments, overflow, decrements.
#include "multipass/shadow_passes.h"

#include "multipass/commands.h"
#include "multipass/whole_window.h"

#include <algorithm>

namespace gw::multipass {
namespace {

/// Counts faces behind what is seen: nothing but the stencil changes.
State counting_state(const Stage& stage, Face culled, StencilOp op) {
    State state = stage.state;
    state.clip_planes = {};  // those of the picture are not the volumes'
    state.color_source = ColorSource::Vertex;
    state.color_mask = {false, false, false, false};
    state.depth = {.test = true, .func = DepthFunc::Less, .mask = false};
    state.cull = {.enable = true, .face = culled, .front = Winding::CCW};
    state.stencil = {.test = true, .func = StencilFunc::Always, .zfail = op};
    return state;
}

/// Fragments on the whole window that pass where `ref` func stored.
State window_state(const Stage& stage, StencilFunc func, int ref, StencilOp op) {
    State state = stage.state;
    state.color_source = ColorSource::Vertex;
    state.color_mask = {false, false, false, false};
    state.depth = {};
    state.stencil = {.test = true, .func = func, .ref = ref, .zpass = op};
    return state;
}

struct VolumeWriter {
    CommandList& list;
    const Stage& stage;
    const std::vector<MeshRef>& volumes;
    int stencil_max;

    void draw(Face culled, StencilOp op, std::size_t first, std::size_t last) {
        list.add(SetState{counting_state(stage, culled, op)});
        for (std::size_t i = first; i < last; ++i)
            if (volumes[i]) list.add(Draw{.mesh = volumes[i], .eye_from_object = stage.eye_from_object[i]});
    }

    void check_overflow(const std::string& name, std::size_t first, std::size_t last) {
        std::size_t triangles = 0;
        for (std::size_t i = first; i < last; ++i)
            triangles += volumes[i] ? volumes[i]->triangles().size() : 0;
        if (triangles < static_cast<std::size_t>(stencil_max)) return;
        begin_pass(list, name + std::string(overflow_suffix),
                   window_state(stage, StencilFunc::Equal, stencil_max, StencilOp::Keep));
        list.add(whole_window(stage.view));
        list.add(BeginPass{.name = name});
    }

    /// Faces that lead out, then those that lead in.
    void count(const std::string& name, std::size_t first, std::size_t last) {
        draw(Face::Front, StencilOp::Incr, first, last);
        check_overflow(name, first, last);
        draw(Face::Back, StencilOp::Decr, first, last);
    }

    /// 1 where the stencil is not 0.
    void reduce() {
        list.add(SetState{window_state(stage, StencilFunc::LEqual, 1, StencilOp::Replace)});
        list.add(whole_window(stage.view));
    }
};

}  // namespace

void add_shadow_volumes(CommandList& list, const Stage& stage, const std::string& name,
                        const std::vector<MeshRef>& volumes, const CountRules& rules) {
    VolumeWriter writer{list, stage, volumes, (1 << rules.stencil_bits) - 1};
    begin_pass(list, name, stage.state);
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    const std::size_t group = rules.one_by_one ? 1 : volumes.size();
    for (std::size_t i = 0; i < volumes.size(); i += group) {
        writer.count(name, i, i + group);
        if (rules.one_by_one || rules.zero_or_one) writer.reduce();
    }
}

bool any_overflow(std::span<const PassReport> passes) {
    return std::any_of(passes.begin(), passes.end(), [](const PassReport& p) {
        return p.name.ends_with(overflow_suffix) && p.counters.written > 0;
    });
}

void add_shadow_mask(CommandList& list, const Stage& stage, const std::string& name,
                     const std::vector<std::uint32_t>& mask) {
    begin_pass(list, name, stage.state);
    list.add(WritePixels{
        .rect = {0, 0, stage.view.width, stage.view.height}, .plane = Plane::Stencil, .values = mask});
}

}  // namespace gw::multipass
