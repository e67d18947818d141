// The module gw._gw: the libraries in Python. python/gw/ is the package around it.
#include "python/binding/module.h"

#include "gw/error.h"
#include "gw/machine.h"
#include "image/output/output_file.h"
#include "image/write.h"
#include "python/binding/arrays.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/interpreter/sealed.h"

#include <new>
#include <stdexcept>

namespace py = pybind11;

namespace {

/// Rows from the bottom, grey or R, G, B.
void write_picture(const std::filesystem::path& file,
                   const gw::python::Input<std::uint16_t>& pixels, int bits) {
    if (pixels.ndim() != 2 && (pixels.ndim() != 3 || pixels.shape(2) != 3))
        throw gw::Error("pixels: an array of shape " + gw::python::shape_text(pixels) +
                        "; expected (height, width) or (height, width, 3)");
    gw::image::write_picture(file, {.width = int(pixels.shape(1)),
                                    .height = int(pixels.shape(0)),
                                    .channels = pixels.ndim() == 2 ? 1 : 3,
                                    .bits = bits,
                                    .values = {pixels.data(), pixels.data() + pixels.size()}});
}

}  // namespace

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
    module.def("write_picture", &write_picture, py::arg("file"), py::arg("pixels"), py::arg("bits"),
               "Writes a picture's rows, the lowest first, in the format of the file's extension.");
    gw::python::seal_classes(module);
    gw::python::end_work_with_interpreter();
}
