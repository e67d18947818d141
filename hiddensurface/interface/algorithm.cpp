#include "hiddensurface/interface/algorithm.h"

#include "gw/error.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

Rgba color_of(std::uint32_t id) {
    const auto byte = [id](int shift) { return static_cast<std::uint16_t>(id >> shift & 255); };
    return {byte(0), byte(8), byte(16), 255};
}

}  // namespace

Input make_input(const scene::Scene& scene, const scene::View& view, const Profile& profile) {
    return {scene, view, profile, project(scene, view, profile)};
}

std::vector<std::string> algorithm_names() {
    std::vector<std::string> names;
    for (const Algorithm& algorithm : algorithms()) names.push_back(algorithm.name);
    return names;
}

const Algorithm& algorithm_named(const std::string& name) {
    std::string known;
    for (const Algorithm& a : algorithms()) {
        if (a.name == name) return a;
        known += (known.empty() ? "" : ", ") + a.name;
    }
    throw Error("unknown algorithm '" + name + "'; expected one of " + known);
}

CommandList begin_picture(const Input& input, const std::string& name) {
    State state;
    state.viewport = {0, 0, input.view.width, input.view.height};
    state.depth = {.test = false, .mask = false};
    CommandList list;
    list.add(BeginPass{.name = name});
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Color)});
    return list;
}

void add_painted(CommandList& list, const std::vector<Painted>& painted) {
    WriteSpans spans;
    for (const auto& [run, id] : painted) {
        const Rgba color = color_of(id);
        if (spans.colors.empty() || spans.colors.back() != color) spans.colors.push_back(color);
        spans.spans.push_back({.x = run.x0,
                               .y = run.y,
                               .length = run.x1 - run.x0,
                               .first = static_cast<std::uint32_t>(spans.colors.size() - 1)});
    }
    if (!spans.spans.empty()) list.add(std::move(spans));
}

void add_run(std::vector<Painted>& painted, const Run& run, std::uint32_t id) {
    if (!painted.empty() && painted.back().id == id && painted.back().run.y == run.y &&
        painted.back().run.x1 == run.x0)
        painted.back().run.x1 = run.x1;
    else
        painted.push_back({run, id});
}

std::int64_t size_of(const std::vector<Painted>& painted) {
    std::int64_t pixels = 0;
    for (const auto& [run, id] : painted) pixels += run.x1 - run.x0;
    return pixels;
}

void draw_line(const Input& input, int y, std::vector<Painted> painted, Output& output,
               StepLog& log) {
    if (painted.empty()) return;
    add_painted(output.list, painted);
    if (log.on())
        log.add({.level = Level::Line,
                 .action = Action::Draw,
                 .test = "draw",
                 .result = "line",
                 .values = {{"spans", std::int64_t(painted.size())}},
                 .window = line_of(input, y),
                 .painted = std::move(painted)});
}

void draw_piece(const Input& input, const Piece& piece, Output& output, StepLog& log) {
    const Polygon& polygon = input.polygons[piece.polygon];
    std::vector<Painted> painted;
    for (const Run& run : runs_of(piece, polygon, input.subpixel_bits(), input.window()))
        painted.push_back({run, polygon.id});
    output.counts.spans += painted.size();
    add_painted(output.list, painted);
    output.pieces.push_back(piece);
    if (log.on())
        log.add({.action = Action::Draw,
                 .test = "draw",
                 .result = "piece",
                 .pieces = {piece.name},
                 .values = {{"pixels", size_of(painted)}},
                 .painted = std::move(painted)});
}

std::vector<WatchedCount> watched(const Counts& counts) {
    std::vector<WatchedCount> all;
    for (const auto& [name, count] : count_names()) all.push_back({name, &(counts.*count)});
    return all;
}

std::span<const CountName> count_names() {
    static constexpr CountName names[] = {
        {"polygons", &Counts::polygons},
        {"facings", &Counts::facings},
        {"keys", &Counts::keys},
        {"extents", &Counts::extents},
        {"planes", &Counts::planes},
        {"overlaps", &Counts::overlaps},
        {"crossings", &Counts::crossings},
        {"depths", &Counts::depths},
        {"rays", &Counts::rays},
        {"sorts", &Counts::sorts},
        {"swaps", &Counts::swaps},
        {"splits", &Counts::splits},
        {"undecided", &Counts::undecided},
        {"rejected", &Counts::rejected},
        {"nodes", &Counts::nodes},
        {"spans", &Counts::spans},
        {"peak_bytes", &Counts::peak_bytes},
        {"fragments", &Counts::fragments},
        {"passed", &Counts::passed},
        {"pixels", &Counts::pixels},
        {"overdraw", &Counts::overdraw},
        {"ties", &Counts::ties},
        {"edges", &Counts::edges},
        {"snapped", &Counts::snapped},
        {"wrong", &Counts::wrong},
    };
    static_assert(sizeof(names) / sizeof(CountName) * sizeof(std::uint64_t) == sizeof(Counts));
    return names;
}

}  // namespace gw::hiddensurface
