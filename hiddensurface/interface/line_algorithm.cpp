#include "hiddensurface/interface/line_algorithm.h"

#include <algorithm>

namespace gw::hiddensurface {

// Each is defined in the file of its name in this folder.
LineAlgorithm roberts();
LineAlgorithm appel();
LineAlgorithm floating_horizon();

namespace {

/// Shorter parts come from the rounding of two equal ends.
constexpr double shortest_part = 1e-9;

}  // namespace

std::span<const LineCountName> line_count_names() {
    static constexpr LineCountName names[] = {
        {"lines", &LineCounts::lines},     {"faces", &LineCounts::faces},
        {"facings", &LineCounts::facings}, {"extents", &LineCounts::extents},
        {"planes", &LineCounts::planes},   {"crossings", &LineCounts::crossings},
        {"starts", &LineCounts::starts},   {"peak_bytes", &LineCounts::peak_bytes},
        {"parts", &LineCounts::parts},     {"pixels", &LineCounts::pixels},
        {"missing", &LineCounts::missing}, {"extra", &LineCounts::extra},
    };
    static_assert(sizeof(names) / sizeof(LineCountName) * sizeof(std::uint64_t) ==
                  sizeof(LineCounts));
    return names;
}

std::vector<WatchedCount> watched(const LineCounts& counts) {
    std::vector<WatchedCount> all;
    for (const auto& [name, count] : line_count_names()) all.push_back({name, &(counts.*count)});
    return all;
}

const std::vector<LineAlgorithm>& line_algorithms() {
    static const std::vector<LineAlgorithm> all{roberts(), appel(), floating_horizon()};
    return all;
}

const LineAlgorithm* line_algorithm_named(const std::string& name) {
    for (const LineAlgorithm& algorithm : line_algorithms())
        if (algorithm.name == name) return &algorithm;
    return nullptr;
}

std::vector<Part> rest_of(std::vector<Part> hidden) {
    std::sort(hidden.begin(), hidden.end());
    std::vector<Part> rest;
    double from = 0;
    const auto add = [&](double to) {
        if (to - from > shortest_part) rest.emplace_back(from, to);
    };
    for (const auto& [first, last] : hidden) {
        add(first);
        from = std::max(from, last);
    }
    add(1);
    return rest;
}

void log_line(const Line& line, const char* test, Values values, StepLog& log) {
    if (!log.on()) return;
    const bool all = line.visible == std::vector<Part>{{0, 1}};
    std::vector<double> visible;
    for (const auto& [from, to] : line.visible) visible.insert(visible.end(), {from, to});
    values.emplace_back("visible", visible);
    log.add({.action = Action::Draw,
             .test = test,
             .result = line.visible.empty() ? "hidden"
                       : all                ? "visible"
                                            : "parts",
             .pieces = {std::to_string(line.id)},
             .values = std::move(values),
             .line = DrawnLine{line.a, line.b, line.visible}});
}

}  // namespace gw::hiddensurface
