#include "inspect/replay/pixel_history.h"

#include "gw/names.h"
#include "gw/reference/make.h"
#include "inspect/replay/following_observer.h"
#include "inspect/text/call_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gw::inspect {
namespace {

class PixelObserver : public FollowingObserver {
public:
    PixelObserver(const Recording& recording, int x, int y)
        : FollowingObserver(recording), calls_(recording), x_(x), y_(y) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        if (f.x != x_ || f.y != y_) return;
        PixelEvent e = event(before, after);
        e.polygon = polygon(f);
        e.call = calls_.text(e.command, place_in_mesh(f));
        e.fragment = f;
        e.fate = fate;
        events.push_back(std::move(e));
    }
    void pixel(int x, int y, const PixelValues& before, const PixelValues& after) override {
        if (x != x_ || y != y_) return;
        PixelEvent e = event(before, after);
        e.call = calls_.text(e.command);
        if (!events.empty() && events.back().command == e.command && !events.back().fragment)
            events.back().after = after;
        else
            events.push_back(e);
    }

    std::vector<PixelEvent> events;

private:
    PixelEvent event(const PixelValues& before, const PixelValues& after) const {
        PixelEvent e{.pass = pass(), .pass_name = pass_name(), .command = command_index()};
        e.command_name = name_of(command());
        e.draw = draw();
        e.before = before;
        e.after = after;
        return e;
    }

    CallNames calls_;
    int x_, y_;
};

class MapObserver : public FollowingObserver {
public:
    MapObserver(const Recording& recording, std::optional<std::size_t> pass, FragmentMaps& maps)
        : FollowingObserver(recording), width_(recording.width), wanted_(pass), maps_(maps) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues&, const PixelValues&) override {
        if (wanted_ && *wanted_ != pass()) return;
        const std::size_t i = std::size_t(f.y) * std::size_t(width_) + std::size_t(f.x);
        maps_.made[i] += 1;
        switch (fate) {
            case Fate::AlphaTest: maps_.alpha_killed[i] += 1; break;
            case Fate::StencilTest: maps_.stencil_killed[i] += 1; break;
            case Fate::DepthTest: maps_.depth_killed[i] += 1; break;
            case Fate::Written: maps_.written[i] += 1; break;
        }
    }
    void pixel(int, int, const PixelValues&, const PixelValues&) override {}

private:
    int width_;
    std::optional<std::size_t> wanted_;
    FragmentMaps& maps_;
};

void observe(const Recording& recording, Observer& observer) {
    const auto machine =
        reference::make(recording.profile, recording.width, recording.height, &observer);
    Player(recording, *machine).play();
}

template <typename T>
std::string text(const std::array<T, 4>& v) {
    return fmt::format("{}", fmt::join(v, " "));
}
std::string text(std::uint32_t v) { return std::to_string(v); }
std::string text(std::uint8_t v) { return std::to_string(v); }

std::string change(const auto& before, const auto& after) {
    return before == after ? text(before) : text(before) + " > " + text(after);
}

/// The event: a fragment's end, or the command.
std::string outcome(const PixelEvent& e) {
    if (!e.fragment) return e.command_name;
    return e.fate == Fate::Written ? "written" : std::string("killed: ") + name_of(e.fate);
}

std::string optional_text(const auto& value) { return value ? std::to_string(*value) : "-"; }

nlohmann::ordered_json values_json(const PixelValues& v, const Profile& profile) {
    nlohmann::ordered_json json{
        {"color", v.color}, {"depth", v.depth}, {"stencil", v.stencil}, {"accum", v.accum}};
    if (profile.color_planes == 2) json["back"] = v.back;
    return json;
}

nlohmann::ordered_json event_json(const PixelEvent& e, const Profile& profile) {
    nlohmann::ordered_json json{{"pass", e.pass},
                                {"pass_name", e.pass_name},
                                {"command", e.command},
                                {"command_name", e.command_name}};
    if (!e.call.empty()) json["call"] = e.call;
    if (e.draw) json["draw"] = *e.draw;
    if (e.fragment) {
        json["primitive"] = e.fragment->primitive;
        if (e.polygon) json["polygon"] = *e.polygon;
        json["front"] = e.fragment->front;
        json["color"] = e.fragment->color;
        json["depth"] = e.fragment->depth;
        if (e.fragment->coverage != 0) json["coverage"] = e.fragment->coverage;
        json["fate"] = name_of(e.fate);
    }
    json["before"] = values_json(e.before, profile);
    json["after"] = values_json(e.after, profile);
    return json;
}

}  // namespace

std::vector<PixelEvent> pixel_history(const Recording& recording, int x, int y) {
    PixelObserver observer(recording, x, y);
    observe(recording, observer);
    return observer.events;
}

const char* name_of(Fate fate) {
    switch (fate) {
        case Fate::AlphaTest: return "alpha test";
        case Fate::StencilTest: return "stencil test";
        case Fate::DepthTest: return "depth test";
        case Fate::Written: return "written";
    }
    return "";
}

bool has_surfaces(const Recording& recording) {
    return std::ranges::any_of(recording.lists, [](const CommandList& list) {
        return std::ranges::any_of(list.commands, [](const Command& command) {
            return std::holds_alternative<UseSurface>(command);
        });
    });
}

FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass) {
    const std::vector<std::uint32_t> none(std::size_t(recording.width) *
                                          std::size_t(recording.height));
    FragmentMaps maps{none, none, none, none, none};
    MapObserver observer(recording, pass, maps);
    observe(recording, observer);
    return maps;
}

std::vector<std::vector<std::string>> history_rows(const std::vector<PixelEvent>& events) {
    const std::array<std::int32_t, 4> zero{};
    const bool back = std::any_of(events.begin(), events.end(), [](const PixelEvent& e) {
        return e.before.back != Rgba{} || e.after.back != Rgba{};
    });
    const bool accum = std::any_of(events.begin(), events.end(), [&](const PixelEvent& e) {
        return e.before.accum != zero || e.after.accum != zero;
    });
    std::vector<std::vector<std::string>> rows{{"pass", "command", "draw", "primitive", "polygon",
                                                "outcome", "fragment's colour", "its Z", "colour",
                                                "Z", "stencil"}};
    const bool smooth = std::any_of(events.begin(), events.end(), [](const PixelEvent& e) {
        return e.fragment && e.fragment->coverage != 0;
    });
    if (back) rows[0].push_back("back colour");
    if (accum) rows[0].push_back("accumulation");
    if (smooth) rows[0].push_back("coverage");
    const bool called =
        std::ranges::any_of(events, [](const PixelEvent& e) { return !e.call.empty(); });
    if (called) rows[0].push_back("call");
    for (const PixelEvent& e : events) {
        const auto& f = e.fragment;
        rows.push_back({e.pass_name, std::to_string(e.command), optional_text(e.draw),
                        f ? text(f->primitive) : "-", optional_text(e.polygon), outcome(e),
                        f ? text(f->color) : "-", f ? text(f->depth) : "-",
                        change(e.before.color, e.after.color),
                        change(e.before.depth, e.after.depth),
                        change(e.before.stencil, e.after.stencil)});
        if (back) rows.back().push_back(change(e.before.back, e.after.back));
        if (accum) rows.back().push_back(change(e.before.accum, e.after.accum));
        if (smooth) rows.back().push_back(f && f->coverage != 0 ? text(f->coverage) : "-");
        if (called) rows.back().push_back(e.call.empty() ? "-" : e.call);
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
    for (const PixelEvent& e : events) json["events"].push_back(event_json(e, recording.profile));
    return json;
}

}  // namespace gw::inspect
