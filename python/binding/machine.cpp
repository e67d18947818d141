// The two machines: lists in, planes and counters out.
#include "gw/machine.h"

#include "gw/names.h"
#include "gw/profile_text.h"
#include "inspect/recording/check_lists.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/lists.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"
#include "python/binding/running.h"

namespace gw::python {

MachineHolder::MachineHolder(const Profile& profile, int width, int height, bool reference,
                             int threads, bool record)
    : width_(width), height_(height), reference_(reference), record_(record) {
    if (threads < 0)
        throw Error("threads: " + std::to_string(threads) + "; expected 0 (all) or more");
    machine_ = reference ? make_reference(profile, width, height)
                         : make_fast(profile, width, height, {.threads = threads});
}

void MachineHolder::execute(const CommandList& list) {
    without_lock([&] {
        const std::lock_guard lock(mutex_);
        if (reference_)
            execute_one_by_one(list);
        else
            machine_->execute(list);
        if (record_) lists_.push_back(list);
    });
    check_signals();
}

void MachineHolder::execute_whole(const CommandList& list) {
    check_signals();
    const std::lock_guard lock(mutex_);
    machine_->execute(list);
    if (reference_) inspect::follow(list, context_);
    if (record_) lists_.push_back(list);
}

void MachineHolder::execute_one_by_one(const CommandList& list) {
    validate(list, machine_->profile(), width_, height_, context_);
    for (const Command& command : list.commands) {
        check_signals();
        machine_->execute({{command}});
    }
    inspect::follow(list, context_);
}

inspect::Recording MachineHolder::recording() const {
    if (!record_) throw Error("the machine does not record; expected Machine(..., record=True)");
    inspect::Recording recording;
    recording.producer = "python3-gw";
    recording.renderer = "python";
    recording.profile = machine_->profile();
    recording.width = width_;
    recording.height = height_;
    recording.lists = lists_;
    return recording;
}

py::object plane_view(const Planes& planes, Plane plane, py::handle owner) {
    const auto shape = [&](int channels) { return rows(planes.height, planes.width, channels); };
    switch (plane) {
        case Plane::Color: return view_of<std::uint16_t>(planes.color.data(), shape(4), owner);
        case Plane::Depth: return view_of<std::uint32_t>(planes.depth.data(), shape(0), owner);
        case Plane::Stencil: return view_of<std::uint8_t>(planes.stencil.data(), shape(0), owner);
        case Plane::Accum: return view_of<std::int32_t>(planes.accum.data(), shape(4), owner);
        case Plane::Back: break;
    }
    if (planes.back.empty()) return py::none();
    return view_of<std::uint16_t>(planes.back.data(), shape(4), owner);
}

py::list pass_rows(const std::vector<PassReport>& passes) {
    py::list rows;
    for (const PassReport& pass : passes) {
        py::dict row, digests;
        row["pass"] = pass.name;
        for (const auto& [name, count] : counter_names()) row[name] = pass.counters.*count;
        for (const Plane plane : every_plane)
            if (pass.digested & mask_of(plane))
                digests[name_of(plane)] = to_string(pass.digests[std::size_t(plane)]);
        row["digests"] = digests;
        rows.append(row);
    }
    return rows;
}

namespace {

const Planes& current_planes(MachineHolder& machine) {
    return without_lock([&]() -> const Planes& {
        const std::lock_guard lock(machine.mutex());
        return machine.machine().planes();
    });
}

py::object plane_of(const py::object& self, Plane plane) {
    return plane_view(current_planes(self.cast<MachineHolder&>()), plane, self);
}

/// A plane that every machine has, with its type.
template <class Number, Plane plane>
py::array_t<Number> typed_plane(const py::object& self) {
    return py::reinterpret_borrow<py::array_t<Number>>(plane_of(self, plane));
}

py::dict readbacks(MachineHolder& machine) {
    py::dict out;
    for (const auto& [key, read] : machine.machine().readbacks()) {
        const int w = read.rect.width, h = read.rect.height;
        const py::int_ place(key);
        if (!read.color.empty())
            out[place] = array_of<std::uint16_t>(read.color, rows(h, w, 4));
        else if (!read.accum.empty())
            out[place] = array_of<std::int32_t>(read.accum, rows(h, w, 4));
        else
            out[place] = array_of<std::uint32_t>(
                std::vector<std::uint32_t>(read.values.begin(), read.values.end()), rows(h, w));
    }
    return out;
}

py::dict digests(MachineHolder& machine) {
    const Planes& planes = current_planes(machine);
    py::dict out;
    for (const Plane plane : every_plane)
        if (planes_of(machine.machine().profile()) & mask_of(plane))
            out[name_of(plane)] = to_string(digest(planes, plane));
    return out;
}

}  // namespace

void add_machine(py::module_& m) {
    py::class_<MachineHolder, std::shared_ptr<MachineHolder>> type(
        m, "Machine",
        "A machine: command lists in, planes and counters out. State and "
        "planes persist from list to list.");
    type.def(
            py::init<const Profile&, int, int, bool, int, bool>(), py::arg("profile") = vgx(),
            py::arg("width") = 640, py::arg("height") = 480, py::kw_only(),
            py::arg("reference") = false, py::arg("threads") = 0, py::arg("record") = false,
            "The fast machine on so many threads (0: all), or the reference machine; both have the "
            "same bits. record: recording() has all lists.")
        .def(
            "execute",
            [](MachineHolder& machine, const ListHolder& list) {
                const auto kept = list.shared();
                machine.execute(*kept);
            },
            py::arg("commands"),
            "Executes a list. Throws Error, before anything is drawn, if it is not valid.")
        .def_property_readonly("color", &typed_plane<std::uint16_t, Plane::Color>,
                               "The colour plane, (height, width, 4) of uint16: a view of memory "
                               "that the next execute changes.")
        .def_property_readonly("depth", &typed_plane<std::uint32_t, Plane::Depth>,
                               "The depth plane, (height, width) of uint32, a view; 0 is nearest.")
        .def_property_readonly("stencil", &typed_plane<std::uint8_t, Plane::Stencil>,
                               "The stencil plane, (height, width) of uint8, a view.")
        .def_property_readonly("accum", &typed_plane<std::int32_t, Plane::Accum>,
                               "The accumulation buffer, (height, width, 4) of int32, a view.")
        .def_property_readonly(
            "back", [](const py::object& s) { return plane_of(s, Plane::Back); },
            "The back plane, as color; None if there is one colour plane.")
        .def("plane", &plane_of, py::arg("plane"), "The plane of this name, a view.")
        .def_property_readonly(
            "profile", [](MachineHolder& s) { return s.machine().profile(); },
            "Its profile, a copy.")
        .def_property_readonly("width", &MachineHolder::width, "Pixels.")
        .def_property_readonly("height", &MachineHolder::height, "Pixels.")
        .def_property_readonly("reference", &MachineHolder::is_reference,
                               "Whether it is the reference machine.")
        .def("recording", &MachineHolder::recording, "All lists so far, if it was made to record.")
        .def(
            "passes", [](MachineHolder& s) { return pass_rows(s.machine().passes()); },
            "A dict for each pass: its name, all counters, and digests if it asked for them.")
        .def(
            "reset_passes", [](MachineHolder& s) { s.machine().reset_passes(); },
            "Forgets the passes so far.")
        .def("readbacks", &readbacks, "The results of read, by key.")
        .def("digests", &digests, "XXH3-128 of each plane, 32 hexadecimal digits.");
}

}  // namespace gw::python
