#include "inspect/report/report.h"

#include "gw/error.h"
#include "gw/machine.h"
#include "gw/reference/make.h"
#include "inspect/manifest/manifest.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/report/embedded.h"
#include "inspect/report/pass_observer.h"
#include "inspect/report/pass_pictures.h"
#include "inspect/report/report_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gw::report {
namespace {

/// Counts on the fast machine, before the slower one is observed: both count the same.
inspect::Manifest replayed_counters(const inspect::Recording& recording) {
    const auto machine = make_fast(recording.profile, recording.width, recording.height);
    inspect::Player(recording, *machine).play();
    return manifest_of(recording, machine->passes());
}

PassSpan passes_shown(std::size_t count, const ReportOptions& options) {
    if (count == 0) throw Error(options.file, 0, "has no pass; expected at least one");
    return options.passes.value_or(PassSpan{0, std::min(count, most_passes) - 1});
}

/// From the first pass, as many passes as `history_fragments` allows.
std::optional<PassSpan> history_that_fits(const inspect::Manifest& manifest, PassSpan shown) {
    std::uint64_t fragments = 0;
    std::optional<PassSpan> fits;
    for (std::size_t i = shown.first; i <= shown.last; ++i) {
        fragments += manifest.passes[i].report.counters.fragments;
        if (fragments > history_fragments) break;
        fits = {shown.first, i};
    }
    return fits;
}

/// Of every pass: it writes identifiers for colours, as an item buffer's does [K4i].
std::vector<bool> passes_of_identifiers(const inspect::Recording& recording,
                                        const ReportOptions& options) {
    const auto ranges = inspect::pass_ranges(recording);
    std::vector<bool> found(ranges.size(), options.identifiers);
    State state;
    std::size_t index = 0, pass = 0;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) {
            while (pass + 1 < ranges.size() && index >= ranges[pass].end) ++pass;
            if (const auto* set = std::get_if<SetState>(&command)) state = set->state;
            if (std::holds_alternative<Draw>(command) &&
                state.color_source == ColorSource::PolygonId)
                found[pass] = true;
            ++index;
        }
    return found;
}

/// Replays on the reference machine, which reports the fate of every fragment.
class Replay {
public:
    Replay(const inspect::Recording& recording, ReportFolder& folder, bool identifiers)
        : recording_(recording),
          ranges_(inspect::pass_ranges(recording)),
          maps_(recording),
          folder_(folder),
          observer_(recording, identifiers),
          machine_(
              reference::make(recording.profile, recording.width, recording.height, &observer_)),
          player_(recording, *machine_) {}

    /// The pictures of every pass.
    nlohmann::ordered_json run(PassSpan shown, std::optional<PassSpan> kept,
                               const std::vector<bool>& identifiers,
                               const std::function<void(const std::string&)>& progress) {
        player_.play_to(ranges_[shown.first].first);
        PassPictures pictures(folder_, recording_.profile, snapshot(shown.first));
        auto all = nlohmann::ordered_json::array();
        for (std::size_t i = shown.first; i <= shown.last; ++i) {
            progress(fmt::format("pass {} of {}-{}", i, shown.first, shown.last));
            if (kept && i == kept->first) begin_history();
            player_.play_to(ranges_[i].end);
            if (history_) history_->flush();
            if (kept && i == kept->last) end_history();
            all.push_back(pictures.add(i, snapshot(i), identifiers[i]));
        }
        with_small_ = pictures.with_small();
        return all;
    }

    bool with_small() const { return with_small_; }

private:
    /// As a screen shows it at the end of the pass.
    Snapshot snapshot(std::size_t pass) {
        return {machine_->planes(), observer_.polygons().ids(), maps_.of(ranges_[pass].end - 1)};
    }

    void begin_history() {
        folder_.make_folder("history");
        history_.emplace(folder_, machine_->planes());
        observer_.keep_in(&*history_);
    }
    void end_history() {
        history_->finish();
        observer_.keep_in(nullptr);
        history_.reset();
    }

    const inspect::Recording& recording_;
    std::vector<inspect::PassRange> ranges_;
    inspect::ShownMaps maps_;
    ReportFolder& folder_;
    PassObserver observer_;
    std::unique_ptr<Machine> machine_;
    inspect::Player player_;
    std::optional<TileHistory> history_;
    bool with_small_ = false;
};

void check_spans(const inspect::Recording& recording, const ReportOptions& options) {
    const std::size_t count = inspect::pass_ranges(recording).size();
    const PassSpan shown = passes_shown(count, options);
    if (shown.last >= count)
        throw Error(fmt::format("passes {}-{} are not in {}; expected passes of 0-{}", shown.first,
                                shown.last, options.file, count - 1));
    if (shown.last - shown.first >= most_passes)
        throw Error(fmt::format("{} passes are too many for one page; expected at most {}",
                                shown.last - shown.first + 1, most_passes));
    const auto& kept = options.history;
    if (kept && (kept->first < shown.first || kept->last > shown.last))
        throw Error(
            fmt::format("histories of passes {}-{} are not on the page; expected passes of {}-{}",
                        kept->first, kept->last, shown.first, shown.last));
}

}  // namespace

std::vector<std::string> report_files() { return {"index.html", "data.js", "pictures", "history"}; }

ReportSummary write_report(const inspect::Recording& recording, const std::filesystem::path& folder,
                           const ReportOptions& options) {
    check_spans(recording, options);
    options.progress("counting");
    const inspect::Manifest manifest = replayed_counters(recording);
    const PassSpan shown = passes_shown(manifest.passes.size(), options);
    std::optional<PassSpan> kept = options.history;
    if (!options.with_history)
        kept.reset();
    else if (!kept)
        kept = history_that_fits(manifest, shown);
    ReportFolder files(folder, options.most_bytes);
    files.make_folder("pictures");
    Replay replay(recording, files, options.identifiers);
    const std::vector<bool> identifiers = passes_of_identifiers(recording, options);
    const auto pictures = replay.run(shown, kept, identifiers, options.progress);
    options.progress("writing");
    const ReportFacts facts{recording,           manifest, shown, kept, pictures, identifiers,
                            replay.with_small(), options};
    files.write("data.js", "gw_report(" + report_json(facts) + ");\n");
    const std::string_view page = embedded("report.html");
    if (!page.empty()) files.write("index.html", page);
    return {shown.last - shown.first + 1, manifest.passes.size(), kept, files.bytes(),
            !page.empty()};
}

}  // namespace gw::report
