#include "inspect/replay/pixel_history.h"

#include "gw/names.h"
#include "gw/reference/make.h"
#include "inspect/replay/following_observer.h"
#include "inspect/replay/shown_maps.h"
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
        : FollowingObserver(recording), calls_(recording), maps_(recording), x_(x), y_(y) {}

    void fragment(const Fragment& f, Fate fate, const PixelValues& before,
                  const PixelValues& after) override {
        if (f.x != x_ || f.y != y_) return;
        PixelEvent e = event(before, after);
        e.polygon = polygon(f);
        if (compared_command_ == e.command && compared_primitive_ == f.primitive) {
            e.comparisons = compared_;
            for (const DepthComparison& c : compared_)
                e.compared_surfaces.push_back(surface_read(c.unit));
        }
        e.call = calls_.text(e.command, place_in_mesh(f));
        e.fragment = f;
        e.fate = fate;
        events.push_back(std::move(e));
    }
    void comparison(int x, int y, std::uint32_t primitive, const DepthComparison& c) override {
        if (x != x_ || y != y_) return;
        if (compared_command_ != command_index() || compared_primitive_ != primitive)
            compared_.clear();
        compared_command_ = command_index();
        compared_primitive_ = primitive;
        compared_.push_back(c);
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
        e.map = maps_.of(e.command);
        return e;
    }

    /// The surface that a unit of the command reads; 0: none.
    std::uint32_t surface_read(std::size_t unit) const {
        const auto of = [&](const auto& drawing) -> std::uint32_t {
            if constexpr (requires { drawing.more_maps; }) {
                const TextureBinding& map = map_of(drawing, unit);
                return map.surface ? map.surface->surface : 0;
            }
            return 0;
        };
        return std::visit(of, command());
    }

    CallNames calls_;
    ShownMaps maps_;
    int x_, y_;
    std::vector<DepthComparison> compared_;  ///< of one primitive of one command
    std::optional<std::size_t> compared_command_;
    std::uint32_t compared_primitive_ = 0;
};

class MapObserver : public FollowingObserver {
public:
    MapObserver(const Recording& recording, int width, std::optional<std::size_t> pass,
                FragmentMaps& maps)
        : FollowingObserver(recording), width_(width), wanted_(pass), maps_(maps) {}

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

void observe(const Recording& recording, Observer& observer, std::uint32_t surface = 0) {
    const auto machine =
        reference::make(recording.profile, recording.width, recording.height, &observer, surface);
    Player(recording, *machine).play();
}

std::string value_text(const auto& v) { return fmt::to_string(v); }
template <typename T>
std::string value_text(const std::array<T, 4>& v) {
    return fmt::to_string(fmt::join(v, " "));
}

std::string change(const auto& before, const auto& after) {
    return before == after ? value_text(before) : value_text(before) + " > " + value_text(after);
}

/// A colour that changes, or the index that it is.
std::string color_change(const PixelEvent& e, const Rgba& before, const Rgba& after) {
    return e.map != nullptr ? index_change_text(*e.map, before, after) : change(before, after);
}

/// The event: a fragment's end, or the command.
std::string outcome(const PixelEvent& e) {
    if (!e.fragment) return e.command_name;
    return e.fate == Fate::Written ? "written" : std::string("killed: ") + name_of(e.fate);
}

/// "unit 1: 4052 > 4000 of texel 7 9 of surface 2: 0"
std::string comparisons_text(const PixelEvent& e) {
    std::string out;
    for (std::size_t i = 0; i < e.comparisons.size(); ++i) {
        const DepthComparison& c = e.comparisons[i];
        const char sign = c.r < c.stored ? '<' : c.r > c.stored ? '>' : '=';
        out += fmt::format("{}unit {}: {} {} {} of texel {} {}", i == 0 ? "" : "; ", c.unit, c.r,
                           sign, c.stored, c.i, c.j);
        if (const std::uint32_t surface = e.compared_surfaces[i])
            out += fmt::format(" of surface {}", surface);
        out += c.passes ? ": 1" : ": 0";
    }
    return out.empty() ? "-" : out;
}

nlohmann::ordered_json comparisons_json(const PixelEvent& e) {
    auto json = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < e.comparisons.size(); ++i) {
        const DepthComparison& c = e.comparisons[i];
        json.push_back({{"unit", c.unit}, {"texel", {c.i, c.j}}, {"r", c.r}, {"stored", c.stored}});
        if (e.compared_surfaces[i] != 0) json.back()["surface"] = e.compared_surfaces[i];
        json.back()["value"] = c.passes ? 1 : 0;
    }
    return json;
}

std::string optional_text(const auto& value) { return value ? std::to_string(*value) : "-"; }

nlohmann::ordered_json values_json(const PixelValues& v, const Profile& profile,
                                   const ColorMap* map) {
    nlohmann::ordered_json json{
        {"color", v.color}, {"depth", v.depth}, {"stencil", v.stencil}, {"accum", v.accum}};
    const auto add_index = [&](const std::string& before, const Rgba& color) {
        if (map == nullptr) return;
        const unsigned index = map->index_of(color);
        json[before + "index"] = index;
        json[before + "entry"] = map->entry(index);
    };
    add_index("", v.color);
    if (profile.color_planes == 2) {
        json["back"] = v.back;
        add_index("back_", v.back);
    }
    return json;
}

nlohmann::ordered_json event_json(const PixelEvent& e, const Profile& profile) {
    nlohmann::ordered_json json{{"pass", e.pass},
                                {"pass_name", e.pass_name},
                                {"command", e.command},
                                {"command_name", e.command_name}};
    if (!e.call.empty()) json["call"] = e.call;
    if (e.map != nullptr) json["index_planes"] = name_of(e.map->planes);
    if (e.draw) json["draw"] = *e.draw;
    if (e.fragment) {
        json["primitive"] = e.fragment->primitive;
        if (e.polygon) json["polygon"] = *e.polygon;
        json["front"] = e.fragment->front;
        json["color"] = e.fragment->color;
        if (e.map != nullptr) json["index"] = e.map->index_of(e.fragment->color);
        json["depth"] = e.fragment->depth;
        if (e.fragment->coverage != 0) json["coverage"] = e.fragment->coverage;
        if (e.fragment->sample != 0) json["sample"] = e.fragment->sample;
        if (!e.comparisons.empty()) json["comparisons"] = comparisons_json(e);
        json["fate"] = name_of(e.fate);
    }
    json["before"] = values_json(e.before, profile, e.map);
    json["after"] = values_json(e.after, profile, e.map);
    return json;
}

}  // namespace

std::map<std::uint32_t, Surface> surfaces_of(const Recording& recording) {
    std::map<std::uint32_t, Surface> all{{0, {recording.width, recording.height, all_planes}}};
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands)
            if (const auto* made = std::get_if<MakeSurface>(&command))
                if (made->surface.width != 0) {
                    Surface& largest = all.try_emplace(made->number, made->surface).first->second;
                    largest.width = std::max(largest.width, made->surface.width);
                    largest.height = std::max(largest.height, made->surface.height);
                    largest.samples = std::max(largest.samples, made->surface.samples);
                }
    return all;
}

std::vector<PixelEvent> pixel_history(const Recording& recording, int x, int y,
                                      std::uint32_t surface) {
    PixelObserver observer(recording, x, y);
    observe(recording, observer, surface);
    if (surface != 0)
        for (PixelEvent& e : observer.events) e.map = nullptr;
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

FragmentMaps fragment_maps(const Recording& recording, std::optional<std::size_t> pass,
                           std::uint32_t surface) {
    const Surface size = surfaces_of(recording).at(surface);
    const std::vector<std::uint32_t> none(std::size_t(size.width) * std::size_t(size.height));
    FragmentMaps maps{none, none, none, none, none};
    MapObserver observer(recording, size.width, pass, maps);
    observe(recording, observer, surface);
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
    const bool sampled = std::ranges::any_of(
        events, [](const PixelEvent& e) { return e.fragment && e.fragment->sample != 0; });
    const bool compares =
        std::ranges::any_of(events, [](const PixelEvent& e) { return !e.comparisons.empty(); });
    if (sampled) rows[0].push_back("sample");
    if (compares) rows[0].push_back("compared depths");
    if (called) rows[0].push_back("call");
    for (const PixelEvent& e : events) {
        const auto& f = e.fragment;
        rows.push_back(
            {e.pass_name, std::to_string(e.command), optional_text(e.draw),
             f ? std::to_string(f->primitive) : "-", optional_text(e.polygon), outcome(e),
             f ? e.map != nullptr ? index_text(*e.map, f->color) : value_text(f->color) : "-",
             f ? std::to_string(f->depth) : "-", color_change(e, e.before.color, e.after.color),
             change(e.before.depth, e.after.depth), change(e.before.stencil, e.after.stencil)});
        if (back) rows.back().push_back(color_change(e, e.before.back, e.after.back));
        if (accum) rows.back().push_back(change(e.before.accum, e.after.accum));
        if (smooth)
            rows.back().push_back(f && f->coverage != 0 ? std::to_string(f->coverage) : "-");
        if (sampled) rows.back().push_back(f ? std::to_string(f->sample) : "-");
        if (compares) rows.back().push_back(comparisons_text(e));
        if (called) rows.back().push_back(e.call.empty() ? "-" : e.call);
    }
    return rows;
}

nlohmann::ordered_json history_json(const Recording& recording, int x, int y,
                                    const std::vector<PixelEvent>& events, std::uint32_t surface) {
    const Surface size = surfaces_of(recording).at(surface);
    nlohmann::ordered_json json{{"x", x},
                                {"y", size.height - 1 - y},
                                {"profile", recording.profile.name},
                                {"width", size.width},
                                {"height", size.height},
                                {"events", nlohmann::ordered_json::array()}};
    if (surface != 0) json["surface"] = surface;
    for (const PixelEvent& e : events) json["events"].push_back(event_json(e, recording.profile));
    return json;
}

}  // namespace gw::inspect
