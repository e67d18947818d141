// The parts of the module, each in the source of its name.
#pragma once

#include <pybind11/pybind11.h>

namespace gw::python {

void add_state(pybind11::module_& module);     ///< enumerations, profiles, the state's groups
void add_values(pybind11::module_& module);    ///< meshes, textures, materials, lights
void add_commands(pybind11::module_& module);  ///< command lists
void add_machine(pybind11::module_& module);   ///< the two machines, planes, counters
void add_recordings(pybind11::module_& module);
void add_scenes(pybind11::module_& module);
void add_shapes(pybind11::module_& module);     ///< meshes of scene files' shapes
void add_passes(pybind11::module_& module);     ///< the papers' passes as values
void add_rendering(pybind11::module_& module);  ///< renderers, item buffer, rays
void add_radiosity(pybind11::module_& module);
void add_hidden_surfaces(pybind11::module_& module);
void add_pass_study(pybind11::module_& module);  ///< passes against rays [K4f]

}  // namespace gw::python
