// Recordings of programs: their frames, a frame step by step, and what happened to a pixel.
#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "gw/names.h"
#include "inspect/manifest/json_of.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/report/prices.h"
#include "web/engine/method.h"
#include "web/engine/recorded/frame_steps.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace gw::lab {
namespace {

/// A recording that begins in the middle of a program begins with its planes.
bool is_frame(const inspect::PassRange& pass) { return pass.name.starts_with("frame "); }

Json frames_of(const inspect::Recording& recording) {
    Json frames = Json::array();
    const auto passes = inspect::pass_ranges(recording);
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (is_frame(passes[i])) frames.push_back({{"pass", i}, {"name", passes[i].name}});
    return frames;
}

inspect::WindowRecording chosen_window(std::vector<inspect::WindowRecording> windows,
                                       const std::string& name) {
    const auto fits = [&](const inspect::WindowRecording& one) { return one.name == name; };
    auto found = std::find_if(windows.begin(), windows.end(), fits);
    if (found == windows.end()) {
        if (!name.empty()) throw Error("the recording has no window '" + name + "'");
        const auto is_less = [](const auto& a, const auto& b) {
            const auto rank = [](const inspect::Recording& r) {
                const inspect::ColorMap* const map = inspect::ShownMaps(r).last();
                const bool is_aside = map != nullptr && map->planes != inspect::IndexPlanes::Window;
                return std::pair(!is_aside, frames_of(r).size());
            };
            return rank(a.recording) < rank(b.recording);
        };
        found = std::max_element(windows.begin(), windows.end(), is_less);
    }
    if (found == windows.end() || frames_of(found->recording).empty())
        throw Error("the recording has no frame; expected a program that draws");
    return std::move(*found);
}

const char* name_of(FrameStep::Kind kind) {
    switch (kind) {
        case FrameStep::Kind::Clear: return "clear";
        case FrameStep::Kind::Primitives: return "primitives";
        case FrameStep::Kind::Pixels: return "pixels";
        case FrameStep::Kind::Shown: return "shown";
        case FrameStep::Kind::Other: return "other";
    }
    return "";
}

Json json_of(const FrameStep& step, const Counters& counters) {
    return {{"kind", name_of(step.kind)},
            {"polygons", step.polygons},
            {"lines", step.lines},
            {"points", step.points},
            {"counters", inspect::json_of(counters)},
            {"seconds", report::estimated_seconds(counters, report::vgx_prices())}};
}

/// A colour, 0 to 255 a channel, and the index that stands for it.
Json value_json(const Rgba& color, const inspect::ColorMap& map, int bits) {
    if (map.bits != 0) {
        const unsigned index = map.index_of(color);
        return {{"index", index}, {"rgb", map.entry(index)}};
    }
    Json rgb = Json::array();
    for (std::size_t c = 0; c < 3; ++c) rgb.push_back(rescale(color[c], bits, 8));
    return {{"rgb", rgb}};
}

/// What each pass counts.
std::vector<PassReport> reports_of(const inspect::Recording& recording) {
    const auto machine =
        make_fast(recording.profile, recording.width, recording.height, {.threads = 1});
    inspect::Player(recording, *machine).play();
    return machine->passes();
}

}  // namespace

Json LabSession::recording(const Json& options) {
    const std::filesystem::path file = options.at("file").get<std::string>();
    inspect::Stream stream = inspect::read_recordings(file);
    Json names = Json::array();
    for (const inspect::WindowRecording& window : stream.windows)
        if (!frames_of(window.recording).empty()) names.push_back(window.name);
    inspect::WindowRecording window =
        chosen_window(std::move(stream.windows), options.value("window", ""));
    recorded_ = std::move(window.recording);
    replayed_ = nullptr;
    return {{"windows", names},
            {"window", window.name},
            {"width", recorded_.width},
            {"height", recorded_.height},
            {"frames", frames_of(recorded_)}};
}

Json LabSession::frame(const Json& options) {
    const auto passes = inspect::pass_ranges(recorded_);
    const std::size_t pass = options.at("frame");
    if (pass >= passes.size() || !is_frame(passes[pass]))
        throw Error("the pass " + std::to_string(pass) + " of the recording is no frame");
    FrameSteps made = steps_of(recorded_, pass, options.at("most"));
    const auto reports = reports_of(made.recording);
    Json steps = Json::array();
    for (std::size_t i = 0; i < made.steps.size(); ++i)
        steps.push_back(json_of(made.steps[i], reports.at(i + 1).counters));
    drawn_plane_ = made.is_back ? Plane::Back : Plane::Color;
    const inspect::ShownMaps maps(recorded_);
    const inspect::ColorMap* const map = maps.of(passes[pass].end - 1);
    map_ = map != nullptr ? *map : inspect::ColorMap{};
    const bool uses_depth = made.uses_depth;
    replayed_ = std::make_unique<inspect::Replayed>(std::move(made.recording));
    return {{"steps", steps},
            {"plane", gw::name_of(drawn_plane_)},
            {"uses_depth", uses_depth},
            {"machine", report::vgx_prices().machine}};
}

Json LabSession::events(const Json& options) {
    if (!replayed_) throw Error("no frame was chosen; expected frame() before");
    const inspect::Recording& recording = replayed_->recording();
    const int x = options.at("x"), y = options.at("y");
    if (x < 0 || y < 0 || x >= recording.width || y >= recording.height)
        throw Error("pixel " + std::to_string(x) + " " + std::to_string(y) +
                    " is outside the picture");
    Json events = Json::array();
    const bool is_back = drawn_plane_ == Plane::Back;
    for (const auto& e : inspect::pixel_history(recording, x, recording.height - 1 - y)) {
        if (e.pass == 0 || std::string_view(e.command_name) == "Read") continue;
        const Rgba& after = is_back ? e.after.back : e.after.color;
        const auto value = [&](const Rgba& color) {
            return value_json(color, map_, recording.profile.color_bits);
        };
        Json event{{"step", e.pass - 1},
                   {"command", e.command_name},
                   {"stored", e.before.depth},
                   {"value", value(e.fragment ? e.fragment->color : after)},
                   {"after", value(after)}};
        if (e.fragment) {
            event["fate"] = inspect::name_of(e.fate);
            event["depth"] = e.fragment->depth;
        }
        events.push_back(std::move(event));
    }
    return events;
}

const Method recording_methods[] = {
    {"recording", &LabSession::recording},
    {"frame", &LabSession::frame},
    {"events", &LabSession::events},
};

}  // namespace gw::lab
