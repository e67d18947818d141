#include "multipass/effects/one_winner.h"

#include "gw/stages/vertex.h"
#include "multipass/passes/catalogue.h"
#include "multipass/steps/commands.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::multipass {
namespace {

/// Pixels a side.
constexpr int cell = 8;
/// Jitter and snapping move a vertex less than this.
constexpr double slack = 2;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Squares of the window that have tied pixels.
class Cells {
public:
    Cells(const scene::View& view)
        : columns_((view.width + cell - 1) / cell),
          rows_((view.height + cell - 1) / cell),
          below_(std::size_t(columns_ + 1) * std::size_t(rows_ + 1)) {}

    /// First each tied pixel, then once finish(), then any().
    void mark(int x, int y) { below_[at(x / cell + 1, y / cell + 1)] = 1; }
    void finish() {
        for (int y = 1; y <= rows_; ++y)
            for (int x = 1; x <= columns_; ++x)
                below_[at(x, y)] +=
                    below_[at(x - 1, y)] + below_[at(x, y - 1)] - below_[at(x - 1, y - 1)];
    }

    /// Any in a box of window coordinates.
    bool any(const dvec2& low, const dvec2& high) const {
        const int x0 = column(low.x), x1 = column(high.x) + 1, y0 = row(low.y),
                  y1 = row(high.y) + 1;
        return below_[at(x1, y1)] - below_[at(x0, y1)] - below_[at(x1, y0)] + below_[at(x0, y0)] !=
               0;
    }

private:
    std::size_t at(int x, int y) const {
        return std::size_t(y) * std::size_t(columns_ + 1) + std::size_t(x);
    }
    static int index(double v, int count) { return int(std::clamp(v / cell, 0.0, count - 1.0)); }
    int column(double x) const { return index(x, columns_); }
    int row(double y) const { return index(y, rows_); }

    int columns_, rows_;
    std::vector<int> below_;  ///< at (x, y): the number of cells left of x and below y
};

/// The position of a vertex in the window; none: before the near plane.
struct CellPlace {
    dvec2 p{0};
    bool behind = false;
};

/// Finds the places of a part's points.
class PartPlaces {
public:
    PartPlaces(const PlacedModel& placed, std::size_t part)
        : port_(placed.state.viewport),
          clip_from_object_(product(placed.state.projection, placed.eye_from_object[part])) {}

    CellPlace at(const dvec3& p) const {
        const dvec4 c = transform(clip_from_object_, dvec4(p, 1));
        if (!(c.z > -c.w) || !(c.w > 0)) return {.behind = true};
        return {{port_.x + (c.x / c.w + 1) / 2 * port_.width,
                 port_.y + (c.y / c.w + 1) / 2 * port_.height}};
    }

private:
    const ViewportState& port_;
    const dmat4 clip_from_object_;
};

bool may_touch(const Cells& cells, const PartPlaces& places, const scene::Bounds& box) {
    dvec2 low(infinity), high(-infinity);
    for (int i = 0; i < 8; ++i) {
        const CellPlace at = places.at(corner(box, i));
        if (at.behind) return true;
        low = glm::min(low, at.p);
        high = glm::max(high, at.p);
    }
    return cells.any(low - slack, high + slack);
}

bool may_touch(const Cells& cells, const std::vector<CellPlace>& at, const Triangle& triangle) {
    const auto& [a, b, c] = triangle.vertex;
    if (at[a].behind || at[b].behind || at[c].behind) return true;
    const dvec2 low = glm::min(glm::min(at[a].p, at[b].p), at[c].p),
                high = glm::max(glm::max(at[a].p, at[b].p), at[c].p);
    return cells.any(low - slack, high + slack);
}

std::vector<std::uint32_t> triangles_near(const Cells& cells, const PlacedModel& placed,
                                          std::size_t part) {
    std::vector<std::uint32_t> near_ties;
    const PartPlaces places(placed, part);
    if (!may_touch(cells, places, placed.model->parts[part].box)) return near_ties;
    const Mesh& mesh = *placed.model->parts[part].mesh;
    std::vector<CellPlace> at;
    at.reserve(mesh.vertex_count());
    for (const vec3& p : mesh.data().positions) at.push_back(places.at(dvec3(p)));
    const auto triangles = mesh.triangles();
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (may_touch(cells, at, triangles[i])) near_ties.push_back(i);
    return near_ties;
}

/// Counts winners: under Equal, stencil + 1.
const Pass winners_pass{
    .name = "count winners",
    .depth = seen,
    .stencil = {.test = true, .func = StencilFunc::Always, .zpass = StencilOp::Incr},
    .color = false,
    .objects = PassObjects::Opaque,
};

/// Passes only on pixels that are not taken yet, and takes them.
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

/// Draws the portions of opaque parts, black if the step does not concern them.
void draw_first_come(CommandList& list, const PlacedModel& placed, const Step& step, State state,
                     const std::vector<Portion>& portions, const FrameRules& rules) {
    bool set = false;
    for (const Portion& portion : portions) {
        const Part& part = placed.model->parts[portion.part];
        if (part.translucent && !concerns(step, part, *placed.model)) continue;
        const TextureState lookup = lookup_of(placed, step, portion.part);
        const CullState& cull = placed.cull[portion.part];
        if (!set || !(lookup == state.texture) || cull != state.cull) {
            state.texture = lookup;
            state.cull = cull;
            list.add(SetState{state});
            set = true;
        }
        list.add(draw_of(placed, step, portion));
        cut_if_long(list, rules);
    }
}

/// The draws of an additive step with one winner per pixel, by the stencil's highest bit.
void draw_with_one_winner(CommandList& list, const PlacedModel& placed, const Step& step,
                          const FrameRules& rules) {
    State state = state_of(placed, step);
    state.stencil = taking(state.stencil, 1u << (rules.stencil_bits - 1));
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
    std::vector<Portion> all;
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i) all.push_back({.part = i});
    draw_first_come(list, placed, step, state, all, rules);
}

/// Whether the step's stencil test can be narrowed to tied pixels, and to all others: it has none,
/// or Equal on other bits. And whether the step draws only parts that were counted.
bool can_leave_ties_out(const PlacedModel& placed, const Step& step, int stencil_bits) {
    const StencilState& s = step.pass.stencil;
    const bool fits =
        !s.test || (s.func == StencilFunc::Equal && std::uint32_t(s.ref) < taken_of(stencil_bits));
    return fits && std::none_of(placed.model->parts.begin(), placed.model->parts.end(),
                                [&](const Part& part) {
                                    return part.translucent && concerns(step, part, *placed.model);
                                });
}

/// Sets the stencil's top bit on ties.
void mark_ties(CommandList& list, const PlacedModel& placed, const TiedPixels& tied,
               int stencil_bits) {
    const std::uint32_t bit = tie_of(stencil_bits);
    write_ties(list, placed, tied,
               {.test = true, .ref = int(bit), .zpass = StencilOp::Replace, .write_mask = bit});
}

/// The step's test on all other pixels.
StencilState beside_ties(StencilState stencil, int stencil_bits) {
    if (!stencil.test) stencil = {.test = true, .func = StencilFunc::Equal, .ref = 0, .mask = 0};
    stencil.mask |= tie_of(stencil_bits);
    return stencil;
}

/// Draws the ties, first come first served, and clears the two top bits.
void draw_ties(CommandList& list, const PlacedModel& placed, const Step& step,
               const FrameRules& rules) {
    const int stencil_bits = rules.stencil_bits;
    State state = state_of(placed, step);
    state.stencil = taking(beside_ties(state.stencil, stencil_bits), taken_of(stencil_bits));
    state.stencil.ref |= int(tie_of(stencil_bits));
    draw_first_come(list, placed, step, state, rules.tied->portions, rules);
    write_ties(list, placed, *rules.tied,
               {.test = true,
                .zpass = StencilOp::Zero,
                .write_mask = tie_of(stencil_bits) | taken_of(stencil_bits)});
}

}  // namespace

TiedPixels tied_pixels(const PlacedModel& placed, std::span<const std::uint32_t> winners) {
    TiedPixels tied;
    Cells cells(placed.view);
    const auto width = std::size_t(placed.view.width);
    for (std::size_t i = 0; i < winners.size(); ++i) {
        if (winners[i] < 2) continue;
        const int x = int(i % width), y = int(i / width);
        cells.mark(x, y);
        tied.spans.push_back({.x = x, .y = y, .length = 1});
    }
    cells.finish();
    PortionMaker maker(placed);
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i) {
        const Part& part = placed.model->parts[i];
        if (part.translucent) continue;
        if (part.mesh->kind() != MeshKind::Triangles) {
            tied.portions.push_back({.part = i});
            continue;
        }
        const std::vector<std::uint32_t> near_ties = triangles_near(cells, placed, i);
        if (!near_ties.empty()) tied.portions.push_back(maker.portion_of(i, near_ties));
    }
    return tied;
}

void add_winner_count(CommandList& list, const PlacedModel& placed, const FrameRules& rules) {
    add_step(list, placed, {.pass = winners_pass}, {.cut = rules.cut});
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
}

std::uint64_t surplus_winners(std::span<const PassReport> reports) {
    return reports[0].counters.written - reports[1].counters.written;
}

void add_step_with_one_winner(CommandList& list, const PlacedModel& placed, const Step& step,
                              const FrameRules& rules) {
    const bool one_winner =
        rules.one_winner && is_additive(step.pass) && step.pass.objects != PassObjects::Translucent;
    if (!one_winner) return add_step(list, placed, step, rules);
    if (!is_needed(step, *placed.model)) return;
    StateWriter states(list);
    begin_step(list, states, placed, step, rules);
    if (!rules.tied || !can_leave_ties_out(placed, step, rules.stencil_bits))
        return draw_with_one_winner(list, placed, step, rules);
    State state = state_of(placed, step);
    mark_ties(list, placed, *rules.tied, rules.stencil_bits);
    state.stencil = beside_ties(state.stencil, rules.stencil_bits);
    states.forget();
    draw_step(list, states, placed, step, state, rules);
    draw_ties(list, placed, step, rules);
}

bool can_mark_ties(const PlacedModel& placed, int stencil_bits) {
    return stencil_bits >= 3 && placed.state.shade_model == ShadeModel::Smooth &&
           placed.state.polygon_mode == PolygonMode::Fill;
}

}  // namespace gw::multipass
