#include "tests/fuzz/check/diversity.h"

#include "gw/names.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::fuzz {
namespace {

bool varies(const auto& plane) {
    return std::any_of(plane.begin(), plane.end(),
                       [&](const auto& v) { return v != plane.front(); });
}

}  // namespace

void Diversity::add(const Case& c, Machine& machine) {
    const Planes& p = machine.planes();
    lists += 1;
    commands += c.list.commands.size();
    varied[std::size_t(Plane::Color)] += varies(p.color) ? 1 : 0;
    varied[std::size_t(Plane::Depth)] += varies(p.depth) ? 1 : 0;
    varied[std::size_t(Plane::Stencil)] += varies(p.stencil) ? 1 : 0;
    varied[std::size_t(Plane::Accum)] += varies(p.accum) ? 1 : 0;
    varied[std::size_t(Plane::Back)] += varies(p.back) ? 1 : 0;
    for (const PassReport& pass : machine.passes()) counters += pass.counters;
}

std::string missing(const Diversity& reached, const Suite& suite) {
    if (reached.lists < 20) return "";
    std::string out;
    for (const Plane plane : every_plane)
        if ((suite.planes & mask_of(plane)) &&
            reached.varied[std::size_t(plane)] * 10 < reached.lists)
            out += fmt::format(" plane {} varies in {} of {} lists;", name_of(plane),
                               reached.varied[std::size_t(plane)], reached.lists);
    for (const CounterName& c : counter_names())
        if (std::count(suite.counters.begin(), suite.counters.end(), c.count) &&
            reached.counters.*c.count * 4 < reached.lists)
            out += fmt::format(" counter {} is {} after {} lists;", c.name,
                               reached.counters.*c.count, reached.lists);
    return out;
}

std::string summary(const Diversity& d) {
    return fmt::format(
        "{} lists, {} commands, {} fragments; vary: colour {}, depth {}, stencil {}, accum {}; killed by "
        "alpha {}, stencil {}, depth {}",
        d.lists, d.commands, d.counters.fragments, d.varied[0], d.varied[1], d.varied[2],
        d.varied[3], d.counters.alpha_killed, d.counters.stencil_killed, d.counters.depth_killed);
}

}  // namespace gw::fuzz
