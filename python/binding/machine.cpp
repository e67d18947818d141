// The two machines: lists in, planes and counters out.
#include "gw/machine.h"

#include "gw/names.h"
#include "gw/profile_text.h"
#include "python/binding/arrays.h"
#include "python/binding/checked.h"
#include "python/binding/fields.h"
#include "python/binding/lists.h"
#include "python/binding/machines.h"
#include "python/binding/module.h"

namespace gw::python {

namespace {

std::unique_ptr<Machine> new_machine(const Profile& profile, int width, int height, bool reference,
                                     int threads) {
    check_threads(threads);
    return reference ? make_reference(profile, width, height)
                     : make_fast(profile, width, height, {.threads = threads});
}

}  // namespace

MachineHolder::MachineHolder(const Profile& profile, int width, int height, bool reference,
                             int threads, bool record)
    : machine_(new_machine(profile, width, height, reference, threads), reference, width, height),
      width_(width),
      height_(height),
      reference_(reference),
      record_(record) {
    if (record) machine_.kept = &lists_;
}

void MachineHolder::execute(const CommandList& list, Stop stop) {
    machine_.stop = std::move(stop);
    machine_.execute(list);
    if (watched_.use_count() > 1) machine_.planes();
}

std::shared_ptr<void> MachineHolder::watch_planes() { return watched_; }

void MachineHolder::execute(const CommandList& list) {
    python::in_turn(mutex_, [&] { execute(list, &check_signals); });
    check_signals();
}

void MachineHolder::execute_beside(const CommandList& list) {
    const std::lock_guard lock(mutex_);
    execute(list, [] { end_if_canceled(); });
}

inspect::Recording MachineHolder::recording() {
    if (!record_) throw Error("the machine does not record; expected Machine(..., record=True)");
    inspect::Recording recording;
    recording.producer = "python3-gw";
    recording.renderer = "python";
    recording.profile = machine_.profile();
    recording.width = width_;
    recording.height = height_;
    recording.lists = in_turn([&](Machine&) { return lists_; });
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
    return machine.in_turn([](Machine& m) -> const Planes& { return m.planes(); });
}

/// Keeps the machine, and its planes up to date, as long as a view lives.
struct ViewOwner {
    py::object machine;
    std::shared_ptr<void> watch;
};

py::object plane_of(const py::object& self, Plane plane) {
    auto& machine = self.cast<MachineHolder&>();
    const py::capsule owner(new ViewOwner{self, machine.watch_planes()},
                            [](void* p) { delete static_cast<ViewOwner*>(p); });
    return plane_view(current_planes(machine), plane, owner);
}

/// A plane that every machine has, with its type.
template <class Number, Plane plane>
py::array_t<Number> typed_plane(const py::object& self) {
    return py::reinterpret_borrow<py::array_t<Number>>(plane_of(self, plane));
}

py::dict readbacks(MachineHolder& machine) {
    py::dict out;
    const auto results = machine.in_turn([](Machine& m) { return m.readbacks(); });
    for (const auto& [key, read] : results) {
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
    const auto found = machine.in_turn([](Machine& m) {
        std::vector<std::pair<const char*, std::string>> all;
        for (const Plane plane : every_plane)
            if (planes_of(m.profile()) & mask_of(plane))
                all.emplace_back(name_of(plane), to_string(digest(m.planes(), plane)));
        return all;
    });
    py::dict out;
    for (const auto& [name, text] : found) out[name] = text;
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
            "passes",
            [](MachineHolder& s) {
                return pass_rows(s.in_turn([](Machine& machine) { return machine.passes(); }));
            },
            "A dict for each pass: its name, all counters, and digests if it asked for them.")
        .def(
            "reset_passes",
            [](MachineHolder& s) { s.in_turn([](Machine& machine) { machine.reset_passes(); }); },
            "Forgets the passes so far.")
        .def("readbacks", &readbacks, "The results of read, by key.")
        .def("digests", &digests, "XXH3-128 of each plane, 32 hexadecimal digits.");
}

}  // namespace gw::python
