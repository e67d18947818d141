#include "inspect/replay/pixel_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gw::inspect {
namespace {

template <typename T>
std::string text(const std::array<T, 4>& v) {
    return fmt::format("{}", fmt::join(v, " "));
}
std::string text(std::uint32_t v) { return std::to_string(v); }
std::string text(std::uint8_t v) { return std::to_string(v); }

std::string change(const auto& before, const auto& after) {
    return before == after ? text(before) : text(before) + " > " + text(after);
}

/// What happened: a fragment's end, or the command.
std::string outcome(const PixelEvent& e) {
    if (!e.fragment) return e.command_name;
    return e.fate == Fate::Written ? "written" : std::string("killed: ") + name_of(e.fate);
}

std::string optional_text(const auto& value) { return value ? std::to_string(*value) : "-"; }

nlohmann::ordered_json values_json(const PixelValues& v) {
    return {{"color", v.color}, {"depth", v.depth}, {"stencil", v.stencil}, {"accum", v.accum}};
}

nlohmann::ordered_json event_json(const PixelEvent& e) {
    nlohmann::ordered_json json{{"pass", e.pass},
                                {"pass_name", e.pass_name},
                                {"command", e.command},
                                {"command_name", e.command_name}};
    if (e.draw) json["draw"] = *e.draw;
    if (e.fragment) {
        json["primitive"] = e.fragment->primitive;
        if (e.polygon) json["polygon"] = *e.polygon;
        json["front"] = e.fragment->front;
        json["color"] = e.fragment->color;
        json["depth"] = e.fragment->depth;
        json["fate"] = name_of(e.fate);
    }
    json["before"] = values_json(e.before);
    json["after"] = values_json(e.after);
    return json;
}

}  // namespace

std::vector<std::vector<std::string>> history_rows(const std::vector<PixelEvent>& events) {
    const std::array<std::int32_t, 4> zero{};
    const bool accum = std::any_of(events.begin(), events.end(), [&](const PixelEvent& e) {
        return e.before.accum != zero || e.after.accum != zero;
    });
    std::vector<std::vector<std::string>> rows{{"pass", "command", "draw", "primitive", "polygon",
                                                "outcome", "fragment's colour", "its Z", "colour",
                                                "Z", "stencil"}};
    if (accum) rows[0].push_back("accumulation");
    for (const PixelEvent& e : events) {
        const auto& f = e.fragment;
        rows.push_back({e.pass_name, std::to_string(e.command), optional_text(e.draw),
                        f ? text(f->primitive) : "-", optional_text(e.polygon), outcome(e),
                        f ? text(f->color) : "-", f ? text(f->depth) : "-",
                        change(e.before.color, e.after.color),
                        change(e.before.depth, e.after.depth),
                        change(e.before.stencil, e.after.stencil)});
        if (accum) rows.back().push_back(change(e.before.accum, e.after.accum));
    }
    return rows;
}

nlohmann::ordered_json history_json(const Recording& recording, int x, int y,
                                    const std::vector<PixelEvent>& events) {
    nlohmann::ordered_json json{{"x", x},
                                {"y", recording.height - 1 - y},
                                {"profile", recording.profile.name},
                                {"width", recording.width},
                                {"height", recording.height},
                                {"events", nlohmann::ordered_json::array()}};
    for (const PixelEvent& e : events) json["events"].push_back(event_json(e));
    return json;
}

}  // namespace gw::inspect
