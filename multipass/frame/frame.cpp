#include "multipass/frame/frame.h"

#include "multipass/effects/one_winner.h"
#include "multipass/shadow/shadow_passes.h"

#include <algorithm>

namespace gw::multipass {
namespace {

/// Whether Z at step `end` is that of all bodies that cast shadows. The first step must have
/// cleared it and drawn them all, and no later one may have cleared it.
bool holds_casting_bodies(const Frame& frame, std::size_t end) {
    const Pass& first = frame.steps.front().pass;
    const bool draws_all = first.action == PassAction::Draw && first.depth.test &&
                           first.depth.mask && first.depth.func == DepthFunc::Less &&
                           !first.stencil.test && (first.clear & mask_of(Plane::Depth)) != 0 &&
                           !frame.placed.state.clip_planes[0].enable;
    const auto& parts = frame.placed.model->parts;
    const auto clears = [](const Step& s) { return (s.pass.clear & mask_of(Plane::Depth)) != 0; };
    return draws_all &&
           std::none_of(frame.steps.begin() + 1, frame.steps.begin() + std::ptrdiff_t(end),
                        clears) &&
           std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
               return part.translucent || concerns(frame.steps.front(), part, *frame.placed.model);
           });
}

void add_shadow(CommandList& list, const Frame& frame, std::size_t index) {
    const Step& step = frame.steps[index];
    const std::string name = name_of(step, *frame.placed.model);
    const std::size_t light = *step.light;
    if (frame.placed.model->scene->lights[light].shadow == scene::Shadow::Map)
        add_shadow_mask(list, frame.placed, name, frame.shadows.masks[light]);
    else
        add_shadow_volumes(list, frame.placed, name, frame.shadows.volumes[light],
                           {.stencil_bits = frame.rules.stencil_bits,
                            .in_front = holds_casting_bodies(frame, index),
                            .zero_or_one = frame.rules.one_winner,
                            .one_by_one = frame.shadows.one_by_one});
}

/// The frame buffer into the accumulation buffer, which holds `most` images. When it is full, the
/// sum so far goes through the frame buffer, which saturates it: more light than white stays white.
void add_image(CommandList& list, const std::string& name, int image, int most) {
    begin_pass(list, name);
    list.add(Accumulate{AccumOp::Accum, 1});
    if (image % (most - 1) == most - 2) {
        list.add(Accumulate{AccumOp::Return, 1});
        list.add(Accumulate{AccumOp::Load, 1});
    }
    list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(0, 0, 0, 1)});
}

/// Eq. 5 [K4]: depth and stencil tests off, blended as the pass says.
void add_traced(CommandList& list, const Frame& frame, const Step& step) {
    if (frame.traced.empty()) return;
    State state;
    state.blend = step.pass.blend;
    begin_pass(list, name_of(step, *frame.placed.model), state);
    const scene::View& view = frame.placed.view;
    list.add(WritePixels{
        .rect = {0, 0, view.width, view.height}, .plane = Plane::Color, .colors = frame.traced});
}

bool draws(const Step& step, const PassModel& model) {
    return step.pass.action == PassAction::Draw && step.pass.color && is_needed(step, model);
}

bool is_layer_step(const Step& step) { return is_layer_pass(step.pass); }

}  // namespace

void add_steps(CommandList& list, const Frame& frame, std::size_t first, std::size_t last) {
    const PassModel& model = *frame.placed.model;
    bool drawn = true;  // since the image before was added
    int image = 0;
    for (std::size_t i = first; i < last; ++i) {
        const Step& step = frame.steps[i];
        switch (step.pass.action) {
            case PassAction::Draw:
                drawn = drawn || draws(step, model);
                add_step_with_one_winner(list, frame.placed, step, frame.rules);
                break;
            case PassAction::Shadow: add_shadow(list, frame, i); break;
            case PassAction::Add:
                if (drawn) add_image(list, name_of(step, model), image++, frame.rules.most_images);
                drawn = false;
                break;
            case PassAction::Trace: add_traced(list, frame, step); break;
        }
        cut_if_long(list, frame.rules);
    }
}

std::size_t end_of_depth(const std::vector<Step>& steps) {
    const auto last = std::find_if(steps.rbegin(), steps.rend(), [](const Step& s) {
        return s.pass.depth.test && s.pass.depth.mask;
    });
    return std::size_t(steps.rend() - last);
}

int images_of(const std::vector<Step>& steps) {
    return int(std::count_if(steps.begin(), steps.end(),
                             [](const Step& s) { return s.pass.action == PassAction::Add; }));
}

LayerSteps layer_steps(const std::vector<Step>& steps) {
    const auto first = std::find_if(steps.begin(), steps.end(), is_layer_step);
    const auto last = std::find_if_not(first, steps.end(), is_layer_step);
    return {std::size_t(first - steps.begin()), std::size_t(last - steps.begin())};
}

}  // namespace gw::multipass
