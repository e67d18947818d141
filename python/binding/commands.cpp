// Command lists: a method for each command.
#include "gw/command_list.h"

#include "gw/names.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/lists.h"
#include "python/binding/module.h"

namespace gw::python {
namespace {

constexpr PlaneMask digested = all_planes;

std::vector<Rgba> colors_of(const py::object& object, int channels_at, const char* name) {
    const auto array = array_from(object, name);
    if (array.ndim() < 1 || array.shape(array.ndim() - 1) != channels_at)
        throw Error(std::string(name) + ": expected an array of colours, (..., 4)");
    const auto flat = whole_numbers_of<std::uint16_t>(array, name);
    std::vector<Rgba> out(flat.size() / 4);
    if (!out.empty()) std::memcpy(out.data(), flat.data(), flat.size() * sizeof flat[0]);
    return out;
}

void clear(ListHolder& list, const std::optional<vec4>& color, const std::optional<double>& depth,
           const std::optional<int>& stencil, const std::optional<vec4>& accum) {
    Clear command;
    const auto with = [&](Plane plane, const auto& value, auto& to) {
        if (!value) return;
        command.planes = PlaneMask(command.planes | mask_of(plane));
        to = *value;
    };
    with(Plane::Color, color, command.color);
    with(Plane::Depth, depth, command.depth);
    with(Plane::Stencil, stencil, command.stencil);
    with(Plane::Accum, accum, command.accum);
    list.add(command);
}

void draw(ListHolder& list, const std::shared_ptr<Mesh>& mesh,
          const std::optional<dmat4>& eye_from_object, const Material& material,
          const std::optional<Material>& back_material, const std::vector<Light>& lights,
          const std::shared_ptr<Texture>& texture, std::optional<std::uint32_t> slot, vec4 color,
          vec3 normal, vec4 texcoord, std::uint32_t id_base, int id_shift,
          std::optional<std::uint32_t> surface, Plane surface_plane) {
    Draw command;
    command.mesh = mesh;
    if (eye_from_object) command.eye_from_object = *eye_from_object;
    command.material = material;
    if (back_material) command.back_material = std::make_shared<const Material>(*back_material);
    const CurrentValues current{color, normal, texcoord};
    if (!(current == CurrentValues{}))
        command.current = std::make_shared<const CurrentValues>(current);
    if (!lights.empty()) command.lights = std::make_shared<const std::vector<Light>>(lights);
    command.map = {texture, slot};
    if (surface) command.map.surface = SurfacePlane{*surface, surface_plane};
    command.id_base = id_base;
    command.id_shift = id_shift;
    list.add(std::move(command));
}

void write_pixels(ListHolder& list, int x, int y, const py::array& values, Plane plane,
                  std::uint32_t depth) {
    const bool color = plane == Plane::Color;
    if (values.ndim() != (color ? 3 : 2))
        throw Error("values: an array of shape " + shape_text(values) + "; expected " +
                    (color ? "(height, width, 4)" : "(height, width)"));
    WritePixels command;
    command.rect = {x, y, length_of(values, 1, "values"), length_of(values, 0, "values")};
    command.plane = plane;
    command.depth = depth;
    if (color)
        command.colors = colors_of(values, 4, "values");
    else
        command.values = whole_numbers_of<std::uint32_t>(values, "values");
    list.add(std::move(command));
}

void write_spans(ListHolder& list, const py::object& spans, const py::object& colors,
                 std::uint32_t depth, bool flat) {
    const auto rows = array_from(spans, "spans");
    if (rows.ndim() != 2 || rows.shape(1) != 4)
        throw Error("spans: expected an array of whole numbers, (n, 4)");
    constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
    const auto numbers = whole_numbers_of<std::int32_t>(rows, "spans", least);
    WriteSpans command;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        const std::int32_t first = numbers[i + 3];
        if (first < 0) throw Error("spans: a first colour below 0; expected 0 or more");
        command.spans.push_back(
            {numbers[i], numbers[i + 1], numbers[i + 2], std::uint32_t(first), flat});
    }
    command.colors = colors_of(colors, 4, "colors");
    command.depth = depth;
    list.add(std::move(command));
}

void draw_pixels(ListHolder& list, double x, double y, const py::array& colors, std::uint32_t depth,
                 double zoom_x, double zoom_y) {
    if (colors.ndim() != 3)
        throw Error("colors: an array of shape " + shape_text(colors) +
                    "; expected (height, width, 4)");
    DrawPixels command;
    command.width = length_of(colors, 1, "colors");
    command.height = length_of(colors, 0, "colors");
    command.raster.x = x;
    command.raster.y = y;
    command.raster.depth = depth;
    command.zoom_x = zoom_x;
    command.zoom_y = zoom_y;
    command.colors = colors_of(colors, 4, "colors");
    list.add(std::move(command));
}

}  // namespace

void add_commands(py::module_& m) {
    py::class_<ListHolder> type(
        m, "CommandList", "The only input of a machine: commands in order. A method adds one.");
    type.def(py::init<>())
        .def("__len__", [](const ListHolder& l) { return l.list().commands.size(); })
        .def(
            "append",
            [](ListHolder& l, const ListHolder& other) {
                const auto kept = other.shared();
                l.changed().append(*kept);
            },
            py::arg("other"), "Adds the commands of another list.")
        .def(
            "copy", [](const ListHolder& l) { return ListHolder(l.list()); }, "A copy.")
        .def(
            "names",
            [](const ListHolder& l) {
                std::vector<std::string> names;
                for (const Command& command : l.list().commands) names.push_back(name_of(command));
                return names;
            },
            "The commands' types, in order.")
        .def(
            "begin_pass",
            [](ListHolder& l, const std::string& name, bool digests) {
                l.add(BeginPass{name, digests ? digested : PlaneMask(0)});
            },
            py::arg("name"), py::arg("digests") = false,
            "Opens a pass; the following commands are counted under its name. digests: of its "
            "planes at its end.")
        .def("clear", &clear, py::kw_only(), py::arg("color") = py::none(),
             py::arg("depth") = py::none(), py::arg("stencil") = py::none(),
             py::arg("accum") = py::none(),
             "Clears the planes that are given: color and accum R, G, B, A; depth 0 .. 1.")
        .def(
            "set_state", [](ListHolder& l, const State& state) { l.add(SetState{state}); },
            py::arg("state"), "Replaces the whole state for the following commands.")
        .def(
            "draw", &draw, py::arg("mesh").none(false), py::kw_only(),
            py::arg("eye_from_object") = py::none(), py::arg("material") = Material{},
            py::arg("back_material") = py::none(), py::arg("lights") = std::vector<Light>{},
            py::arg("texture") = py::none(), py::arg("slot") = py::none(),
            py::arg("color") = vec4(1), py::arg("normal") = vec3(0, 0, 1),
            py::arg("texcoord") = vec4(0, 0, 0, 1), py::arg("id_base") = 0, py::arg("id_shift") = 0,
            py::arg("surface") = py::none(), py::arg("surface_plane") = Plane::Color,
            "Draws a mesh with the current state. color, normal and texcoord are those of meshes "
            "without their own; a texture, the slot that copy_texture filled, or a surface's plane.")
        .def(
            "write_spans", &write_spans, py::arg("spans"), py::arg("colors"), py::kw_only(),
            py::arg("depth") = 0, py::arg("flat") = true,
            "Fragments of runs of pixels: spans (n, 4) are x, y, length and the index of the first "
            "colour; colors (m, 4) in units of the plane.")
        .def("write_pixels", &write_pixels, py::arg("x"), py::arg("y"), py::arg("values"),
             py::arg("plane") = Plane::Color, py::kw_only(), py::arg("depth") = 0,
             "Writes a rectangle: (height, width, 4) colours, or (height, width) depths or stencil "
             "values; the bottom row first.")
        .def(
            "draw_pixels", &draw_pixels, py::arg("x"), py::arg("y"), py::arg("colors"),
            py::kw_only(), py::arg("depth") = 0, py::arg("zoom_x") = 1.0, py::arg("zoom_y") = 1.0,
            "glDrawPixels (extension draw_pixels): (height, width, 4) colours at a raster position.")
        .def(
            "accumulate",
            [](ListHolder& l, AccumOp op, float value) {
                l.add(Accumulate{op, value});
            },
            py::arg("op"), py::arg("value") = 1.0f, "glAccum.")
        .def(
            "copy_pixels",
            [](ListHolder& l, Plane plane, const Rect& source, int x, int y) {
                l.add(Copy{plane, source, x, y});
            },
            py::arg("plane"), py::arg("source"), py::arg("x"), py::arg("y"),
            "Copies a rectangle of a plane to x, y (glCopyPixels).")
        .def(
            "copy_texture",
            [](ListHolder& l, std::uint32_t slot, Plane plane, const Rect& rect) {
                l.add(CopyTexture{slot, plane, rect});
            },
            py::arg("slot"), py::arg("plane"), py::arg("rect"),
            "Fills a texture slot, 0 .. 255, from a rectangle of the colour or depth plane.")
        .def(
            "read",
            [](ListHolder& l, std::uint32_t key, Plane plane, const Rect& rect) {
                l.add(Read{key, plane, rect});
            },
            py::arg("key"), py::arg("plane"), py::arg("rect"),
            "Reads a rectangle back: Machine.readbacks()[key].")
        .def(
            "swap_buffers", [](ListHolder& l) { l.add(SwapBuffers{}); },
            "Exchanges the front and the back plane.")
        .def(
            "make_surface",
            [](ListHolder& l, std::uint32_t number, int width, int height,
               const std::vector<Plane>& planes, int depth_bits, int samples) {
                PlaneMask mask = 0;
                for (const Plane plane : planes) mask = PlaneMask(mask | mask_of(plane));
                l.add(MakeSurface{number, {width, height, mask, depth_bits, samples}});
            },
            py::arg("number"), py::arg("width"), py::arg("height"), py::arg("planes"),
            py::kw_only(), py::arg("depth_bits") = 0, py::arg("samples") = 0,
            "Makes a surface, 1 .. 1023, of these planes, all 0 (extension surfaces). Samples: 0, 2, "
            "4 or 8 (extension multisample).")
        .def(
            "use_surface", [](ListHolder& l, std::uint32_t number) { l.add(UseSurface{number}); },
            py::arg("number"), "The following commands draw to it and read from it; 0: the window.")
        .def(
            "blit",
            [](ListHolder& l, std::uint32_t from, const std::vector<Plane>& planes,
               const Rect& source, const Rect& target, bool flip_x, bool flip_y, MagFilter filter) {
                PlaneMask mask = 0;
                for (const Plane plane : planes) mask = PlaneMask(mask | mask_of(plane));
                l.add(Blit{from, mask, source, target, flip_x, flip_y, filter});
            },
            py::arg("from_surface"), py::arg("planes"), py::arg("source"), py::arg("target"),
            py::kw_only(), py::arg("flip_x") = false, py::arg("flip_y") = false,
            py::arg("filter") = MagFilter::Nearest,
            "Copies a rectangle of a surface to the one in use, scaled (glBlitFramebuffer).");
}

}  // namespace gw::python
