// IRIS GL's materials, lights and lighting models in OpenGL.
#pragma once

namespace gw::irisgl {

/// Gives OpenGL the bound definitions. Positions of lights are those of lmbind.
void apply_materials();
void apply_light(int number);
void apply_light_model();
/// lmcolor.
void apply_color_mode();

}  // namespace gw::irisgl
