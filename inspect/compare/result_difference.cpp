#include "inspect/compare/difference.h"

#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gw::inspect {
namespace {

Planes planes_of(const Recording& recording, const MachineMaker& make, std::size_t pass) {
    const auto machine = make(recording);
    Player(recording, *machine).play_to(pass_ranges(recording).at(pass).end);
    return machine->planes();
}

bool same_event(const PixelEvent& a, const PixelEvent& b) {
    const auto fragment = [](const PixelEvent& e) {
        return e.fragment ? std::tuple(e.fragment->color, e.fragment->depth, e.fragment->primitive)
                          : std::tuple<Rgba, std::uint32_t, std::uint32_t>();
    };
    return a.pass_name == b.pass_name && std::string_view(a.command_name) == b.command_name &&
           a.draw == b.draw && a.fragment.has_value() == b.fragment.has_value() &&
           fragment(a) == fragment(b) && a.fate == b.fate && a.after == b.after;
}

std::string event_line(const std::vector<PixelEvent>& events, std::size_t i) {
    if (i >= events.size()) return "nothing more";
    const auto rows = history_rows({events[i]});
    std::string line;
    for (std::size_t column = 0; column < rows[0].size(); ++column)
        if (rows[1][column] != "-")
            line += (column ? ", " : "") + rows[0][column] + " " + rows[1][column];
    return line;
}

/// Null: colours are not indices.
Finding map_difference(const ColorMap* a, const ColorMap* b) {
    const auto kind = [](const ColorMap* m) {
        return m == nullptr ? "colours"
                            : fmt::format("{} indices of {} bits, {} in R", name_of(m->planes),
                                          m->bits, m->bits_in_r);
    };
    if (kind(a) != kind(b)) return {.what = "kind", .expected = kind(a), .actual = kind(b)};
    const auto entry = [](const ColorMap& m, unsigned i) {
        return fmt::format("{}", fmt::join(m.entry(i), " "));
    };
    unsigned i = 0;
    while (i + 1 < a->entries.size() && entry(*a, i) == entry(*b, i)) ++i;
    return {.what = fmt::format("entry {}", i), .expected = entry(*a, i), .actual = entry(*b, i)};
}

/// Of the planes that both have.
bool same_digests(const PassReport& a, const PassReport& b) {
    return std::ranges::all_of(planes_in_order, [&](Plane plane) {
        const auto i = std::size_t(plane);
        return !(a.digested & b.digested & mask_of(plane)) || a.digests[i] == b.digests[i];
    });
}

}  // namespace

ResultDifference located(ResultDifference result) {
    for (const Plane plane : planes_in_order) {
        const auto wrong = wrong_pixels(result.a, result.b, plane);
        if (wrong.empty()) continue;
        const auto [x, y, distance] = wrong.front();
        result.plane = plane;
        result.finding.what = fmt::format("plane {}, {}, the worst one", name_of(plane),
                                          plural(wrong.size(), "pixel", "pixels"));
        result.finding.pixel = ivec2(x, y);
        result.finding.expected = shown_value(result.a, plane, x, y, result.map_a);
        result.finding.actual = shown_value(result.b, plane, x, y, result.map_b);
        break;
    }
    return result;
}

std::optional<ResultDifference> first_result_difference(const Recording& a, const Recording& b,
                                                        const MachineMaker& make) {
    const auto p = reports_of(a, make), q = reports_of(b, make);
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
        if (same_digests(p[i], q[i])) continue;
        Finding finding{
            .pass = i, .pass_name = p[i].name, .stage = stage_of(p[i].counters, q[i].counters)};
        return located({.finding = std::move(finding),
                        .a = planes_of(a, make, i),
                        .b = planes_of(b, make, i),
                        .map_a = ShownMaps(a).of_pass(i),
                        .map_b = ShownMaps(b).of_pass(i)});
    }
    return {};
}

std::optional<Finding> first_map_difference(const Recording& a, const Recording& b) {
    const ShownMaps maps_a(a), maps_b(b);
    const auto passes = pass_ranges(a);
    for (std::size_t i = 0; i < std::min(passes.size(), pass_ranges(b).size()); ++i) {
        const ColorMap *p = maps_a.of_pass(i), *q = maps_b.of_pass(i);
        if (p == q || (p != nullptr && q != nullptr && *p == *q)) continue;
        Finding f = map_difference(p, q);
        f.pass = i;
        f.pass_name = passes[i].name;
        return f;
    }
    return {};
}

std::string first_event_difference(const Recording& a, const Recording& b, int x, int y) {
    const auto p = pixel_history(a, x, y), q = pixel_history(b, x, y);
    std::size_t i = 0;
    while (i < p.size() && i < q.size() && same_event(p[i], q[i])) ++i;
    if (i == p.size() && i == q.size()) return "";
    return "A: " + event_line(p, i) + "\nB: " + event_line(q, i) + "\n";
}

std::string wrong_pixel_lines(const ResultDifference& d, std::size_t most) {
    std::string lines;
    const auto wrong = wrong_pixels(d.a, d.b, d.plane);
    for (std::size_t i = 0; i < std::min(most, wrong.size()); ++i) {
        const auto [x, y, distance] = wrong[i];
        lines += fmt::format("{} {}: {}, {}\n", x, d.a.height - 1 - y,
                             shown_value(d.a, d.plane, x, y, d.map_a),
                             shown_value(d.b, d.plane, x, y, d.map_b));
    }
    if (wrong.size() > most) lines += fmt::format("... and {} more\n", wrong.size() - most);
    return lines;
}

}  // namespace gw::inspect
