// Recordings: opened, saved, replayed, verified and compared; the conformance suite.
#include "inspect/recording/recording.h"

#include "conformance/suite.h"
#include "gw/names.h"
#include "image/output/output_file.h"
#include "image/output/output_set.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "inspect/compare/compare_machines.h"
#include "inspect/compare/difference.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/recording/check_lists.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/plane_values.h"
#include "inspect/replay/player.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/lists.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gw::python {
namespace {

using inspect::Recording;
namespace fs = std::filesystem;

py::object from_json(const std::string& text) {
    return py::module_::import("json").attr("loads")(text);
}

py::list manifest_rows(const inspect::Manifest& manifest) {
    std::vector<PassReport> reports;
    for (const inspect::ManifestPass& pass : manifest.passes) reports.push_back(pass.report);
    py::list rows = pass_rows(reports);
    for (std::size_t i = 0; i < manifest.passes.size(); ++i)
        if (const auto& shown = manifest.passes[i].shown)
            rows[i]["digests"]["shown"] = to_string(*shown);
    return rows;
}

std::string machine_name(bool reference) { return reference ? "reference" : "fast"; }

/// Machines that end when they are cancelled.
inspect::MachineMaker maker_of(const std::string& name) {
    return [name](const Recording& r) {
        auto machine = std::make_unique<SlicedMachine>(
            inspect::maker_of(name)(r), name == machine_name(true), r.width, r.height);
        machine->stop = [] { end_if_canceled(); };
        return machine;
    };
}

/// What differs, with its text, and the pictures of the plane.
struct FoundDifference {
    std::string text, stage, what, pass_name;
    std::optional<std::size_t> pass;
    std::optional<ivec2> pixel;  ///< window coordinates
    std::string expected, actual;
    std::optional<Planes> expected_planes, actual_planes;
    std::optional<Plane> plane;
    Profile profile;
};

std::optional<Plane> plane_that_differs(const Planes& a, const Planes& b) {
    for (const Plane plane : inspect::planes_in_order)
        if (!inspect::same(a, b, plane)) return plane;
    return {};
}

FoundDifference difference_of(const inspect::Finding& f, const Recording& recording) {
    FoundDifference d;
    d.text = inspect::text(f, recording.height);
    d.stage = f.stage;
    d.what = f.what;
    d.pass = f.pass;
    d.pass_name = f.pass_name;
    d.pixel = f.pixel;
    d.expected = f.expected;
    d.actual = f.actual;
    d.profile = recording.profile;
    return d;
}

std::optional<FoundDifference> verified(const Recording& recording, const fs::path& manifest) {
    const auto expected = inspect::load_manifest(manifest);
    const auto v = inspect::verify(recording, expected.manifest, expected.values,
                                   maker_of("reference"), maker_of("fast"));
    if (!v.finding) return {};
    FoundDifference d = difference_of(*v.finding, recording);
    if (!v.same_commands) d.text += "the manifest is of another recording\n";
    d.expected_planes = v.expected_planes;
    d.actual_planes = v.actual_planes;
    if (v.expected_planes && v.actual_planes)
        d.plane = plane_that_differs(*v.expected_planes, *v.actual_planes);
    return d;
}

std::optional<FoundDifference> machines_differ(const Recording& recording) {
    const auto found =
        inspect::compare_machines(recording, maker_of("reference"), maker_of("fast"));
    if (!found) return {};
    return difference_of(*found, recording);
}

std::optional<FoundDifference> result_difference(const Recording& a, const Recording& b) {
    const auto found = inspect::first_result_difference(a, b, maker_of("fast"));
    if (!found) return {};
    FoundDifference d = difference_of(found->finding, b);
    d.plane = found->plane;
    d.expected_planes = found->a;
    d.actual_planes = found->b;
    return d;
}

/// NAME-PLANE-actual.png and, if both are known, -expected and -difference.
std::vector<std::string> save_pictures(const FoundDifference& d, const std::string& prefix) {
    std::vector<std::string> files;
    if (!d.actual_planes) return files;
    const Plane plane = d.plane.value_or(Plane::Color);
    const auto save = [&](const char* kind, const image::Picture& picture) {
        files.push_back(prefix + "-" + name_of(plane) + "-" + kind + ".png");
        image::write_picture(files.back(), picture);
    };
    save("actual", image::plane_picture(*d.actual_planes, plane, d.profile));
    if (!d.expected_planes) return files;
    save("expected", image::plane_picture(*d.expected_planes, plane, d.profile));
    save("difference",
         image::distance_picture(inspect::distances(*d.expected_planes, *d.actual_planes, plane),
                                 d.actual_planes->width, d.actual_planes->height));
    return files;
}

void save_manifest(const Recording& recording, const fs::path& file, bool values) {
    const auto made = cancelable([&] {
        return inspect::replayed_manifest_file(recording, maker_of("reference"), file, values);
    });
    image::OutputSet files;
    if (values) files.add(inspect::values_file(file)).write(made.values);
    files.add(file).write_text(to_json(made.manifest));
    files.commit();
}

std::shared_ptr<MachineHolder> replayed(const Recording& recording, bool reference, int threads) {
    auto machine = std::make_shared<MachineHolder>(recording.profile, recording.width,
                                                   recording.height, reference, threads, false);
    for (const CommandList& list : recording.lists) machine->execute(list);
    return machine;
}

Recording recording_of(const std::vector<ListHolder>& lists, const Profile& profile, int width,
                       int height) {
    Recording recording;
    recording.producer = "python3-gw";
    recording.renderer = "python";
    recording.profile = profile;
    recording.width = width;
    recording.height = height;
    for (const ListHolder& list : lists) recording.lists.push_back(list.list());
    check_window(width, height);
    inspect::validate_lists(recording);
    return recording;
}

py::list suite_members(const std::string& name) {
    py::list out;
    for (const conformance::Group& group : conformance::groups()) {
        if (group.name != name) continue;
        for (conformance::Member& member : conformance::members(group))
            out.append(py::make_tuple(member.name, std::move(member.recording)));
        return out;
    }
    throw Error("no group '" + name + "'; expected one of conformance_groups()");
}

void add_recording(py::module_& m) {
    py::class_<Recording>(m, "Recording", "Everything that entered one machine.")
        .def(py::init(&recording_of), py::arg("lists"), py::arg("profile"), py::arg("width"),
             py::arg("height"), "Of lists for a machine. Throws Error if they are not valid.")
        .def_static(
            "open",
            [](const fs::path& file, const std::string& window) {
                return without_lock(
                    [&] { return choose_window(inspect::read_recordings(file), window); });
            },
            py::arg("file"), py::arg("window") = "",
            "Reads a .gwt file; window: its name or number in a recording of several.")
        .def_static(
            "windows",
            [](const fs::path& file) {
                std::vector<std::string> names;
                for (const auto& window : inspect::read_recordings(file).windows)
                    names.push_back(window.name);
                return names;
            },
            py::arg("file"), "The windows of a file.")
        .def_static(
            "decode",
            [](const py::bytes& bytes) {
                const auto text = std::string_view(bytes);
                return inspect::decode(
                    {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            },
            py::arg("bytes"), "From a file's bytes.")
        .def(
            "encode",
            [](const Recording& r) {
                const auto bytes = inspect::encode(r);
                return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            },
            "The bytes of a .gwt file.")
        .def(
            "save",
            [](const Recording& r, const fs::path& file) {
                const auto bytes = inspect::encode(r);
                image::write_file(file,
                                  {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
            },
            py::arg("file"), "Writes a .gwt file, whole or not at all.")
        .def_readonly("profile", &Recording::profile, "The machine's.")
        .def_readonly("width", &Recording::width, "Pixels.")
        .def_readonly("height", &Recording::height, "Pixels.")
        .def_readonly("producer", &Recording::producer, "The program that made it.")
        .def_readonly("scene", &Recording::scene, "The scene's file.")
        .def_readonly("renderer", &Recording::renderer, "The renderer.")
        .def_property_readonly(
            "lists",
            [](const Recording& r) {
                std::vector<ListHolder> lists;
                for (const CommandList& list : r.lists) lists.emplace_back(list);
                return lists;
            },
            "Copies of its lists.")
        .def("replay", &replayed, py::kw_only(), py::arg("reference") = false,
             py::arg("threads") = 0, "A machine that has executed it.")
        .def(
            "passes",
            [](const Recording& r, bool reference) {
                return manifest_rows(cancelable([&] {
                    return inspect::replayed_manifest(r, maker_of(machine_name(reference)),
                                                      nullptr);
                }));
            },
            py::kw_only(), py::arg("reference") = false,
            "A dict for each pass: its name, all counters, digests of all planes; if colours are "
            "indices, of the shown picture.")
        .def(
            "manifest",
            [](const Recording& r) {
                return from_json(cancelable([&] {
                    return to_json(inspect::replayed_manifest(r, maker_of("reference"), nullptr));
                }));
            },
            "The expected results, as gw verify reads them.")
        .def(
            "save_manifest", &save_manifest, py::arg("file"), py::kw_only(),
            py::arg("values") = true,
            "Writes the manifest and, for the values of wrong pixels, the planes after every pass.")
        .def(
            "verify",
            [](const Recording& r, const fs::path& manifest) {
                return cancelable([&] { return verified(r, manifest); });
            },
            py::arg("manifest"), "None, or the first difference from the manifest's results.")
        .def(
            "compare_machines",
            [](const Recording& r) { return cancelable([&] { return machines_differ(r); }); },
            "None, or the first difference of the two machines.")
        .def(
            "compare",
            [](const Recording& r, const Recording& other) {
                return cancelable([&] { return result_difference(r, other); });
            },
            py::arg("other"),
            "None, or the first difference of the planes after a pass; this one is expected.")
        .def(
            "pixel_history",
            [](const Recording& r, int x, int y, std::uint32_t surface) {
                if (!inspect::surfaces_of(r).contains(surface))
                    throw py::value_error(
                        fmt::format("surface {}: the recording has none of this number", surface));
                return from_json(without_lock([&] {
                    return history_json(r, x, y, inspect::pixel_history(r, x, y, surface), surface)
                        .dump();
                }));
            },
            py::arg("x"), py::arg("y"), py::kw_only(), py::arg("surface") = 0,
            "The events of the pixel in column x, row y from the bottom, as gw pixel --json has "
            "them; of the window, or of a surface beside it.");
}

void add_difference(py::module_& m) {
    using D = FoundDifference;
    py::class_<D>(m, "Difference", "The first difference between expected and actual results.")
        .def("__str__", [](const D& d) { return d.text; })
        .def_readonly("text", &D::text, "One line, then notes.")
        .def_readonly("what", &D::what, "\"plane color\", \"counter written\", ...")
        .def_readonly("stage", &D::stage, "The stage of the machine that made it; \"\": unknown.")
        .def_readonly("pass_number", &D::pass, "From 0.")
        .def_readonly("pass_name", &D::pass_name, "Its name.")
        .def_property_readonly(
            "pixel",
            [](const D& d) -> std::optional<std::pair<int, int>> {
                if (!d.pixel) return {};
                return std::pair(d.pixel->x, d.pixel->y);
            },
            "Column, and row from the bottom.")
        .def_readonly("expected", &D::expected, "The value; \"\": unknown.")
        .def_readonly("actual", &D::actual, "The value; \"\": unknown.")
        .def("save_pictures", &save_pictures, py::arg("prefix"),
             "Writes PREFIX-PLANE-actual.png, -expected.png and -difference.png as far as they are "
             "known, and returns the names.");
}

}  // namespace

void add_recordings(py::module_& m) {
    add_difference(m);
    add_recording(m);
    m.def(
        "conformance_groups",
        [] {
            py::list out;
            for (const conformance::Group& g : conformance::groups()) {
                py::dict group;
                group["name"] = g.name;
                group["about"] = g.about;
                group["rules"] = conformance::rules_of(g);
                out.append(group);
            }
            return out;
        },
        "The groups of the conformance suite: name, about, the manual's rules that it reaches.");
    m.def("conformance_members", &suite_members, py::arg("group"),
          "The recordings of a group, with their names.");
}

}  // namespace gw::python
