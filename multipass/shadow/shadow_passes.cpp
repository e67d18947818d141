#include "multipass/shadow/shadow_passes.h"

#include "multipass/steps/commands.h"

#include <algorithm>

namespace gw::multipass {
namespace {

/// Counts faces: nothing but the stencil changes.
State counting_state(const PlacedModel& placed, Face culled, const StencilState& stencil) {
    State state = placed.state;
    state.clip_planes = {};  // the picture's planes must not cut volumes
    state.color_source = ColorSource::Vertex;
    state.color_mask = {false, false, false, false};
    state.depth = {.test = true, .func = DepthFunc::Less, .mask = false};
    state.cull = {.enable = true, .face = culled, .front = Winding::CCW};
    state.stencil = stencil;
    return state;
}
StencilState behind(StencilOp op) {
    return {.test = true, .func = StencilFunc::Always, .zfail = op};
}
StencilState before(StencilOp op) {
    return {.test = true, .func = StencilFunc::Always, .zpass = op};
}

/// Fragments on the whole window that pass if `ref` func stored.
State window_state(const PlacedModel& placed, StencilFunc func, int ref, StencilOp op) {
    State state = placed.state;
    state.color_mask = {false, false, false, false};
    state.depth = {};
    state.stencil = {.test = true, .func = func, .ref = ref, .zpass = op};
    return state;
}

struct VolumeWriter {
    CommandList& list;
    const PlacedModel& placed;
    const std::vector<ShadowVolume>& volumes;
    const CountRules& rules;
    std::vector<bool> outside{};  ///< by volume: counted in front of the visible point

    VolumeWriter(CommandList& l, const PlacedModel& s, const std::vector<ShadowVolume>& v,
                 const CountRules& r)
        : list(l), placed(s), volumes(v), rules(r) {
        for (std::size_t i = 0; i < volumes.size(); ++i)
            outside.push_back(rules.in_front && !rules.one_by_one && volumes[i].caps &&
                              is_outside(volumes[i], placed.eye_from_object[i], placed.view));
    }

    std::vector<MeshRef> drawn(std::size_t i) const {
        if (outside[i]) return {volumes[i].sides};
        return {volumes[i].caps, volumes[i].sides};
    }

    void draw(const State& state, bool in_front, std::size_t first, std::size_t last) {
        bool set = false;
        for (std::size_t i = first; i < last; ++i) {
            if (outside[i] != in_front) continue;
            for (const MeshRef& mesh : drawn(i)) {
                if (!mesh) continue;
                if (!set) list.add(SetState{state});
                set = true;
                list.add(Draw{.mesh = mesh, .eye_from_object = placed.eye_from_object[i]});
            }
        }
    }
    void draw(StencilOp op, Face culled_behind, Face culled_before, std::size_t first,
              std::size_t last) {
        draw(counting_state(placed, culled_behind, behind(op)), false, first, last);
        draw(counting_state(placed, culled_before, before(op)), true, first, last);
    }

    /// All of a volume is in front of the background, but its caps are not drawn.
    void clear_background() {
        if (std::find(outside.begin(), outside.end(), true) == outside.end()) return;
        State state = window_state(placed, StencilFunc::Always, 0, StencilOp::Zero);
        state.depth = {.test = true, .func = DepthFunc::Equal, .mask = false};
        add_whole_window(list, state);
    }

    void check_overflow(const std::string& name, std::size_t first, std::size_t last) {
        const int stencil_max = (1 << rules.stencil_bits) - 1;
        std::size_t triangles = 0;
        for (std::size_t i = first; i < last; ++i)
            for (const MeshRef& mesh : drawn(i)) triangles += mesh ? mesh->triangles().size() : 0;
        if (triangles < std::size_t(stencil_max)) return;
        list.add(BeginPass{.name = name + std::string(overflow_suffix)});
        add_whole_window(list,
                         window_state(placed, StencilFunc::Equal, stencil_max, StencilOp::Keep));
        list.add(BeginPass{.name = name});
    }

    /// Increments, then decrements. Faces behind the visible point count up if they lead out of a
    /// volume; faces in front, if they lead in.
    void count(const std::string& name, std::size_t first, std::size_t last) {
        draw(StencilOp::Incr, Face::Front, Face::Back, first, last);
        clear_background();
        check_overflow(name, first, last);
        draw(StencilOp::Decr, Face::Back, Face::Front, first, last);
    }

    /// Makes every count that is not 0 a 1.
    void reduce() {
        add_whole_window(list, window_state(placed, StencilFunc::LEqual, 1, StencilOp::Replace));
    }
};

}  // namespace

void add_shadow_volumes(CommandList& list, const PlacedModel& placed, const std::string& name,
                        const std::vector<ShadowVolume>& volumes, const CountRules& rules) {
    VolumeWriter writer(list, placed, volumes, rules);
    begin_pass(list, name, placed.state);
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

void add_shadow_mask(CommandList& list, const PlacedModel& placed, const std::string& name,
                     const std::vector<std::uint32_t>& mask) {
    begin_pass(list, name, placed.state);
    list.add(WritePixels{.rect = {0, 0, placed.view.width, placed.view.height},
                         .plane = Plane::Stencil,
                         .values = mask});
}

}  // namespace gw::multipass
