#include "multipass/frame/frame_drawer.h"

#include "gw/error.h"
#include "multipass/effects/one_winner.h"
#include "multipass/effects/translucency.h"
#include "multipass/frame/superpose.h"
#include "multipass/shadow/shadow_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace gw::multipass {
namespace {

/// The view that is drawn: its far plane lies behind all shadow volumes, and a clip plane cuts at
/// its own far distance.
PlacedModel place_with_shadows(const PassModel& model, const scene::View& view,
                               const Shadows& shadows) {
    PlacedModel placed = place_model(model, enclosing(view, model, shadows));
    const double far_plane = view.camera.far_plane;
    if (far_plane == placed.view.camera.far_plane) return placed;
    const double farthest =
        scene::depth_interval(scene::bounds(*model.scene), view.eye_from_world).farthest;
    if (farthest > far_plane) placed.state.clip_planes[0] = {true, dvec4(0, 0, 1, far_plane)};
    return placed;
}

/// The lists of a model of more parts, or of more pieces from far to near, are cut.
constexpr std::size_t many_parts = 1 << 16;

bool traces(const std::vector<Step>& steps) {
    return std::any_of(steps.begin(), steps.end(),
                       [](const Step& s) { return s.pass.action == PassAction::Trace; });
}

/// Whether a step before `end` leaves something of its own in the stencil, which counting would
/// clear.
bool uses_stencil(const std::vector<Step>& steps, std::size_t end) {
    return std::any_of(steps.begin(), steps.begin() + std::ptrdiff_t(end), [](const Step& s) {
        return s.pass.stencil.test && !keeps_stencil(s.pass.stencil.front());
    });
}

}  // namespace

FrameDrawer::FrameDrawer(Machine& machine, const scene::Scene& scene, PassList passes,
                         const Options& options, const vec3& background)
    : machine_(machine),
      still_(scene),
      moving_(moves(scene) ? std::optional(scene) : std::nullopt),
      now_(moving_ ? *moving_ : still_),
      options_(options),
      background_(background),
      model_(make_pass_model(now_)),
      steps_(schedule(passes, model_)),
      topologies_(topologies(model_)),
      shadows_(find_volumes(model_, topologies_)) {}

void FrameDrawer::move(const scene::View& view, const Sample& sample) {
    if (moving_) {
        move_to(*moving_, still_, sample);
        shadows_ = find_volumes(model_, topologies_);
    }
    placed_ = place_with_shadows(model_, view_at(view, sample), shadows_);
    placed_.state.jitter = jitter_of(sample, machine_.profile().subpixel_bits);
    for (std::size_t i = 0; i < placed_.glare.size(); ++i)
        if (const auto& glare = now_.objects[i].glare)
            placed_.glare[i] = glare_displacement(*glare, sample);
    if (options_.translucency == Translucency::Sorted) placed_.far_to_near = far_to_near(placed_);
    find_masks(shadows_, machine_, model_, placed_.view, placed_.state.jitter);
    if (options_.trace && traces(steps_))
        traced_ = options_.trace(machine_, now_, placed_.view, placed_.state.jitter);
}

void FrameDrawer::draw(const scene::View& view, const Sample& sample) {
    move(view, sample);
    shadows_.one_by_one = false;
    if (attempt()) return;
    shadows_.one_by_one = true;
    if (!attempt())
        throw Error(fmt::format(
            "an object's shadow volume is deeper than {} stencil bits count; use shadow = \"map\"",
            machine_.profile().stencil_bits));
}

bool FrameDrawer::wants_count() const {
    const bool opaque = std::any_of(model_.parts.begin(), model_.parts.end(),
                                    [](const Part& p) { return !p.translucent; });
    return options_.one_winner == OneWinner::Auto && opaque &&
           std::any_of(steps_.begin(), steps_.end(),
                       [](const Step& s) { return is_additive(s.pass); }) &&
           !uses_stencil(steps_, end_of_depth(steps_));
}

FrameRules FrameDrawer::rules() {
    FrameRules rules{.background = background_,
                     .one_winner = options_.one_winner == OneWinner::Always,
                     .stencil_bits = machine_.profile().stencil_bits};
    rules.most_images = most_pictures(machine_.profile());
    if (std::max(model_.parts.size(), placed_.far_to_near.size()) > many_parts)
        rules.cut = [this](CommandList& list) {
            machine_.execute(list);
            list.commands.clear();
        };
    return rules;
}

/// Passes that look at the whole window find nothing in rows that are not drawn.
void FrameDrawer::clear_undrawn_rows() {
    CommandList list;
    begin_pass(list, "clear undrawn rows");
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Depth) | mask_of(Plane::Stencil))});
    machine_.execute(list);
}

/// False: a shadow count may have overflowed.
bool FrameDrawer::attempt() {
    if (placed_.view.only_rows) clear_undrawn_rows();
    const std::size_t before = machine_.passes().size();
    Frame frame{placed_, shadows_, steps_, rules(), traced_};
    TiedPixels tied;
    std::size_t next = 0;
    if (wants_count()) {
        next = end_of_depth(steps_);
        count_winners_of(frame, next, tied);
    }
    const LayerSteps layers = layer_steps(steps_);
    run(frame, next, layers.first);
    run_layers(frame, layers);
    run(frame, layers.last, steps_.size());
    return !any_overflow(std::span(machine_.passes()).subspan(before));
}

/// Draws the steps before `end` and enters the count's result in the frame's rules.
void FrameDrawer::count_winners_of(Frame& frame, std::size_t end, TiedPixels& tied) {
    CommandList list;
    add_steps(list, frame, 0, end);
    add_winner_count(list, placed_, frame.rules);
    machine_.execute(list);
    frame.rules.one_winner = surplus_winners(std::span(machine_.passes()).last(2)) > 0;
    if (!frame.rules.one_winner || !can_mark_ties(placed_, frame.rules.stencil_bits)) return;
    tied = tied_pixels(placed_, machine_.readbacks().at(winners_key).values);
    frame.rules.tied = &tied;
}

void FrameDrawer::run(const Frame& frame, std::size_t first, std::size_t last) {
    if (first == last) return;
    CommandList list;
    add_steps(list, frame, first, last);
    machine_.execute(list);
}

void FrameDrawer::run_layers(const Frame& frame, const LayerSteps& steps) {
    if (steps.first == steps.last) return;
    const Layers layers = find_layers(machine_, placed_);
    CommandList list;
    for (std::size_t r = 0; r < layers.depth.size(); ++r) {
        begin_layer(list, placed_, layers, r);
        add_steps(list, frame, steps.first, steps.last);
    }
    end_layers(list, placed_, layers);
    machine_.execute(list);
}

}  // namespace gw::multipass
