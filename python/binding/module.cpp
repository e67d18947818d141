// The module gw._gw: the libraries in Python. python/gw/ is the package around it.
#include "python/binding/module.h"

#include "gw/error.h"
#include "gw/machine.h"
#include "image/output/output_file.h"
#include "python/binding/casters.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/sealed.h"

#include <new>
#include <stdexcept>

namespace py = pybind11;

PYBIND11_MODULE(_gw, module) {
    module.doc() =
        "The machine and the papers' renderers. Rows count from the bottom, as in OpenGL.";
    const auto error = py::register_exception<gw::Error>(module, "Error", PyExc_ValueError);
    error.attr("__doc__") = "Wrong input; one line that says what is wrong and what was expected.";
    // A method's `self` that is read in its body.
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const py::cast_error&) {
            PyErr_SetString(PyExc_TypeError,
                            "an object of another type; expected the method's own");
        } catch (const std::bad_alloc&) {
            PyErr_SetString(PyExc_MemoryError, "out of memory");
        } catch (const std::length_error&) {
            PyErr_SetString(PyExc_MemoryError, "out of memory");
        }
    });
    gw::python::add_state(module);
    gw::python::add_values(module);
    gw::python::add_commands(module);
    gw::python::add_machine(module);
    gw::python::add_recordings(module);
    gw::python::add_scenes(module);
    gw::python::add_shapes(module);
    gw::python::add_passes(module);
    gw::python::add_rendering(module);
    gw::python::add_radiosity(module);
    gw::python::add_hidden_surfaces(module);
    gw::python::add_pass_study(module);
    module.def("simd_target", &gw::simd_target,
               "The vector instruction set that the fast machine uses here.");
    module.def(
        "write_file",
        [](const std::filesystem::path& file, const py::bytes& bytes) {
            gw::image::write_file(file, std::string_view(bytes));
        },
        py::arg("file"), py::arg("bytes"),
        "Writes a whole file. It appears complete or not at all, keeps its owner and mode, and a "
        "link is followed.");
    gw::python::seal_classes(module);
    gw::python::end_work_with_interpreter();
}
