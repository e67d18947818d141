// Gives OpenGL the state of the current window, group by group.
#pragma once

namespace gw::irisgl {

void apply_all();
void apply_viewport();
void apply_lines();
void apply_pattern();
void apply_polygons();
void apply_depth();
void apply_buffers();
void apply_color_mask();
/// The state of the draw mode: other planes, other masks.
void apply_draw_mode();

}  // namespace gw::irisgl
