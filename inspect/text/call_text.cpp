#include "inspect/text/call_text.h"

#include "gw/escape_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace gw::inspect {
namespace {

const char* primitive_word(Primitive primitive) {
    switch (primitive) {
        case Primitive::Points: return "point";
        case Primitive::Lines:
        case Primitive::LineStrip: return "line";
        case Primitive::Triangles:
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan: return "triangle";
        case Primitive::Quads: return "quad";
        case Primitive::Polygons: return "polygon";
    }
    return "";
}

std::string source_words(const CallTable& table, const Call& call) {
    return call.source != no_call ? " at " + table.sources[call.source] : "";
}

/// The lists that a call is made by, from the frame on.
std::string words_before(const CallTable& table, const Call& call) {
    std::string words;
    for (std::uint32_t at = call.list; at != no_call; at = table.lists[at].caller.list) {
        const auto& [name, caller] = table.lists[at];
        const std::string& function = table.functions[caller.function];
        const char* const kind = function == "callobj" ? "object" : "list";  // IRIS GL's; OpenGL's
        words = fmt::format("call {} {}{}, {} {}: {}", caller.number, function,
                            source_words(table, caller), kind, name, words);
    }
    return escape_controls(words) + "call ";
}

CallWords words_of(const CallTable& table, const CallRun& run, const Command& command) {
    const auto* const draw = std::get_if<Draw>(&command);
    return {
        run.first,
        words_before(table, run.call),
        run.call.number,
        run.step,
        escape_controls(" " + table.functions[run.call.function] + source_words(table, run.call)),
        draw ? primitive_word(draw->mesh->data().primitive) : "",
        run.ordinal};
}

/// The runs of a command.
std::span<const CallRun> runs_of(const CallTable& table, std::uint32_t command) {
    const auto first = std::ranges::lower_bound(table.runs, command, {}, &CallRun::command),
               end = std::ranges::upper_bound(table.runs, command, {}, &CallRun::command);
    return std::span(table.runs)
        .subspan(std::size_t(first - table.runs.begin()), std::size_t(end - first));
}

}  // namespace

CallNames::CallNames(const Recording& recording) : recording_(recording), first_commands_{0} {
    for (const CommandList& list : recording.lists)
        first_commands_.push_back(first_commands_.back() + list.commands.size());
    for (const CallTable& table : recording.calls) empty_ &= table.runs.empty();
}

CallNames::Place CallNames::place_of(std::size_t command) const {
    const auto after = std::ranges::upper_bound(first_commands_, command);
    const std::size_t list = std::size_t(after - first_commands_.begin()) - 1;
    return {list < recording_.calls.size() ? &recording_.calls[list] : nullptr,
            recording_.lists[list], static_cast<std::uint32_t>(command - first_commands_[list])};
}

std::string CallWords::text(std::optional<std::uint32_t> wanted) const {
    const std::uint32_t further = wanted.value_or(first) - first;
    const std::string call = before + std::to_string(number + step * further) + after;
    return !wanted || primitive.empty()
               ? call
               : fmt::format("{}, {} {}", call, primitive, ordinal + further);
}

std::string CallNames::text(std::size_t command, std::optional<std::uint32_t> primitive) const {
    const auto [table, list, place] = place_of(command);
    if (table == nullptr) return "";
    const auto runs = runs_of(*table, place);
    const auto after = std::ranges::upper_bound(runs, primitive.value_or(0), {}, &CallRun::first);
    if (after == runs.begin()) return "";
    return words_of(*table, *std::prev(after), list.commands[place]).text(primitive);
}

std::vector<CallWords> CallNames::words(std::size_t command) const {
    const auto [table, list, place] = place_of(command);
    std::vector<CallWords> all;
    if (table == nullptr) return all;
    for (const CallRun& run : runs_of(*table, place))
        all.push_back(words_of(*table, run, list.commands[place]));
    return all;
}

}  // namespace gw::inspect
