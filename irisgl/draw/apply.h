// Gives OpenGL the state of the current window, group by group.
#pragma once

#include "irisgl/state/program.h"
#include "irisgl/state/state.h"

#include <functional>

namespace gw::irisgl {

void apply_all();
/// Also turns off what only OpenGL keeps: fog, stencil, textures ...
void reset_all();
void apply_viewport();
void apply_lines();
void apply_pattern();
/// The pattern that polygons have; null: none.
const Pattern* pattern_now();
void apply_polygons();
/// Draws polygons inside `pixels`, with a pattern of 64 x 64 bits square by square.
void draw_in_pattern(const Bounds& pixels, const std::function<void()>& draw);
void apply_depth();
void apply_blending();
void apply_buffers();
void apply_color_mask();
/// Until apply_color_mask, the write mask does not hold.
void write_all_bits();
/// The state of the draw mode: other planes, other masks.
void apply_draw_mode();

/// The bound definitions of materials, lights and the model. Positions of lights are those of lmbind.
void apply_materials();
void apply_light(int number);
void apply_light_model();
/// lmcolor.
void apply_color_mode();

}  // namespace gw::irisgl
