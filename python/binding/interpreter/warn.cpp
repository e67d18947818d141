#include "python/binding/interpreter/warn.h"

#include <pybind11/pybind11.h>

namespace gw::python {

void warn(const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
        if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0)
            throw pybind11::error_already_set();
}

}  // namespace gw::python
