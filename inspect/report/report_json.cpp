#include "inspect/report/report_json.h"

#include "gw/names.h"
#include "inspect/manifest/json_of.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/report/tile_history.h"
#include "inspect/text/call_text.h"

#include <nlohmann/json.hpp>

namespace gw::report {
namespace {

using Json = nlohmann::ordered_json;

Json prices_json(const PriceList& list) {
    Json prices = Json::array();
    // A recording has no rays.
    for (const Price& price : list.prices)
        if (price.count.counter)
            prices.push_back({{"count", price.count.name},
                              {"stage", price.stage},
                              {"nanoseconds", price.nanoseconds},
                              {"estimate", price.estimate},
                              {"source", price.source}});
    return {{"machine", list.machine}, {"prices", prices}};
}

Json span_json(const std::optional<PassSpan>& span) {
    return span ? Json{{"first", span->first}, {"last", span->last}} : Json();
}

/// The colour maps of passes that are shown, asked for in their order.
class MapsJson {
public:
    explicit MapsJson(const inspect::Recording& recording) : maps_(recording) {}

    /// The pass's place in `all`; nothing: its colours are no indices.
    std::optional<std::size_t> place_of(std::size_t pass) {
        const inspect::ColorMap* const map = maps_.of_pass(pass);
        if (map == nullptr) return {};
        if (last_ == nullptr || *map != *last_) add(*map);
        return all.size() - 1;
    }

    Json all = Json::array();

private:
    /// With the entries that the map before it has not.
    void add(const inspect::ColorMap& map) {
        Json changes = Json::array();
        for (std::size_t i = 0; i < map.entries.size(); ++i) {
            const bool is_known = last_ != nullptr && i < last_->entries.size();
            if (map.entries[i] != (is_known ? last_->entries[i] : 0))
                changes.push_back({i, map.entries[i]});
        }
        all.push_back({{"planes", name_of(map.planes)},
                       {"bits", map.bits},
                       {"bits_in_r", map.bits_in_r},
                       {"changes", changes}});
        last_ = &map;
    }

    inspect::ShownMaps maps_;
    const inspect::ColorMap* last_ = nullptr;
};

Json pass_json(const ReportFacts& facts, std::size_t i, const inspect::PassRange& range,
               MapsJson& maps) {
    const inspect::ManifestPass& pass = facts.manifest.passes[i];
    Json state = Json::array();
    for (const inspect::Field& field : pass.state) state.push_back({field.name, field.value});
    Json json{{"pass", i},
              {"name", pass.report.name},
              {"set", pass.set},
              {"first", range.first},
              {"end", range.end},
              {"state", state},
              {"counters", inspect::json_of(pass.report.counters)},
              {"estimated_seconds", estimated_seconds(pass.report.counters, facts.options.prices)},
              {"identifiers", bool(facts.identifiers[i])},
              {"planes", facts.pictures[i - facts.shown.first]}};
    if (const auto map = maps.place_of(i)) json["map"] = *map;
    return json;
}

/// Commands by their places: a history names them.
Json commands_json(const ReportFacts& facts, const std::vector<inspect::PassRange>& ranges) {
    Json names = Json::array();
    if (!facts.history) return names;
    std::size_t index = 0;
    for (const CommandList& list : facts.recording.lists)
        for (const Command& command : list.commands) {
            if (index >= ranges[facts.history->first].first &&
                index < ranges[facts.history->last].end)
                names.push_back(name_of(command));
            ++index;
        }
    return names;
}

/// Of each of these commands its calls: [first, before, number, step, after, primitive, ordinal].
/// Empty if no command has any.
Json calls_json(const ReportFacts& facts, const std::vector<inspect::PassRange>& ranges) {
    Json calls = Json::array();
    const inspect::CallNames names(facts.recording);
    if (!facts.history || names.empty()) return calls;
    for (std::size_t i = ranges[facts.history->first].first; i < ranges[facts.history->last].end;
         ++i) {
        Json runs = Json::array();
        for (const inspect::CallWords& w : names.words(i))
            runs.push_back({w.first, w.before, w.number, w.step, w.after, w.primitive, w.ordinal});
        calls.push_back(runs);
    }
    return calls;
}

}  // namespace

std::string report_json(const ReportFacts& facts) {
    const auto ranges = inspect::pass_ranges(facts.recording);
    Json passes = Json::array();
    MapsJson maps(facts.recording);
    for (std::size_t i = facts.shown.first; i <= facts.shown.last; ++i)
        passes.push_back(pass_json(facts, i, ranges[i], maps));
    Json report{{"version", 1},
                {"file", facts.options.file},
                {"command", facts.options.command},
                {"language", facts.options.language == Language::Japanese ? "ja" : "en"},
                {"producer", facts.recording.producer},
                {"scene", facts.recording.scene},
                {"renderer", facts.recording.renderer},
                {"profile", inspect::json_of(facts.recording.profile)},
                {"width", facts.recording.width},
                {"height", facts.recording.height},
                {"passes_of_recording", facts.manifest.passes.size()},
                {"small", facts.with_small},
                {"time", prices_json(facts.options.prices)},
                {"history", span_json(facts.history)},
                {"tile", TileHistory::side},
                {"commands", commands_json(facts, ranges)},
                {"calls", calls_json(facts, ranges)},
                {"passes", passes}};
    if (!maps.all.empty()) report["maps"] = maps.all;
    return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gw::report
