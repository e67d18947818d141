#include "inspect/compare/compare_machines.h"

#include "gw/names.h"
#include "inspect/recording/check_lists.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::inspect {
namespace {

/// The first plane in a fragment's order that differs, and its first pixel.
bool find_pixel(Finding& f, const Planes& expected, const Planes& actual, const ColorMap* map) {
    for (const Plane plane : planes_in_order) {
        const auto pixel = first_difference(expected, actual, plane);
        if (!pixel) continue;
        f.what = std::string("plane ") + name_of(plane);
        f.pixel = pixel;
        f.expected = shown_value(expected, plane, pixel->x, pixel->y, map);
        f.actual = shown_value(actual, plane, pixel->x, pixel->y, map);
        return true;
    }
    return false;
}

}  // namespace

MachineMaker maker_of(const std::string& machine, int threads) {
    if (machine == "reference")
        return [](const Recording& r) { return make_reference(r.profile, r.width, r.height); };
    return [threads](const Recording& r) {
        return make_fast(r.profile, r.width, r.height, {.threads = threads});
    };
}

std::vector<PassReport> reports_of(const Recording& recording, const MachineMaker& make) {
    validate_lists(recording);
    const auto machine = make(recording);
    DigestingMachine digesting(*machine);
    Player(recording, digesting).play();
    return machine->passes();
}

std::optional<Finding> compare_machines(const Recording& recording, const MachineMaker& expected,
                                        const MachineMaker& actual) {
    const auto a = reports_of(recording, expected), b = reports_of(recording, actual);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        auto finding = first_difference(a[i], b[i], i);
        if (!finding) continue;
        locate(*finding, recording, expected, actual);
        return finding;
    }
    if (a.size() != b.size())
        return Finding{.what = "number of passes",
                       .expected = std::to_string(a.size()),
                       .actual = std::to_string(b.size())};
    return {};
}

void locate(Finding& finding, const Recording& recording, const MachineMaker& expected,
            const MachineMaker& actual) {
    const PassRange range = pass_ranges(recording).at(*finding.pass);
    const ShownMaps maps(recording);
    const auto a = expected(recording), b = actual(recording);
    Player player_a(recording, *a), player_b(recording, *b);
    for (std::size_t end = range.first; end <= range.end; ++end) {
        player_a.play_to(end);
        player_b.play_to(end);
        if (!find_pixel(finding, a->planes(), b->planes(), maps.of_pass(*finding.pass))) continue;
        if (end > range.first)
            finding.notes.push_back(
                fmt::format("after command {} of the recording ({}), the first whose planes differ",
                            end - 1, name_of(command_at(recording, end - 1))));
        return;
    }
}

}  // namespace gw::inspect
