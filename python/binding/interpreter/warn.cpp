#include "python/binding/interpreter/warn.h"

#include <pybind11/pybind11.h>

namespace gw::python {

void warn(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        // Names of files may have bytes that are no UTF-8.
        const auto text = pybind11::reinterpret_steal<pybind11::object>(
            PyUnicode_DecodeFSDefaultAndSize(line.data(), pybind11::ssize_t(line.size())));
        if (!text || PyErr_WarnFormat(PyExc_UserWarning, 1, "%U", text.ptr()) != 0)
            throw pybind11::error_already_set();
    }
}

}  // namespace gw::python
