// Classes whose objects are whole: only a class's own constructor makes one. Does not know any class.
#pragma once

#include <pybind11/pybind11.h>

namespace gw::python {

/// Closes all classes of the module. From then on `__new__` and `__class__` make no object without
/// its constructor, and no class derives from them: pybind11 would read such an object's memory as
/// it is. Each attempt raises TypeError. Called once, when the module is complete.
void seal_classes(const pybind11::module_& module);

}  // namespace gw::python
