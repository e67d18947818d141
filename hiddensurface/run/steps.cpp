// Steps as lines of JSON.
#include "hiddensurface/run/steps.h"

#include "gw/error.h"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array level_names{"polygon", "line", "span", "pixel"};
constexpr std::array action_names{"compare", "decide", "sort", "split", "draw"};

template <class Enum, std::size_t N>
Enum enum_from(const std::array<const char*, N>& names, const std::string& word) {
    for (std::size_t i = 0; i < N; ++i)
        if (word == names[i]) return static_cast<Enum>(i);
    throw Error("unknown word '" + word + "' in a step; expected a line that gw hidden wrote");
}

Json json_of(const std::vector<Loop>& loops) {
    Json out = Json::array();
    for (const Loop& loop : loops) {
        Json points = Json::array();
        for (const dvec3& p : loop) points.push_back({p.x, p.y, p.z});
        out.push_back(points);
    }
    return out;
}

std::vector<Loop> loops_from(const Json& json) {
    std::vector<Loop> loops;
    for (const Json& points : json) {
        Loop loop;
        for (const Json& p : points) loop.emplace_back(p.at(0), p.at(1), p.at(2));
        loops.push_back(loop);
    }
    return loops;
}

Step parse(const std::string& line) {
    const Json json = Json::parse(line);
    Step step;
    step.level = enum_from<Level>(level_names, json.at("level"));
    step.action = enum_from<Action>(action_names, json.at("action"));
    step.polygons = json.value("polygons", step.polygons);
    step.test = json.value("test", "");
    step.result = json.value("result", "");
    step.row = json.value("row", -1);
    for (const Json& p : json.value("painted", Json::array()))
        step.painted.push_back({{p.at(0), p.at(1), p.at(2)}, p.at(3)});
    step.before = loops_from(json.value("before", Json::array()));
    step.behind = loops_from(json.value("behind", Json::array()));
    if (const Json w = json.value("window", Json::array()); !w.empty())
        step.window = {w.at(0), w.at(1), w.at(2), w.at(3)};
    return step;
}

void check(const Step& step, int width, int height) {
    for (const auto& [run, id] : step.painted)
        if (run.y < 0 || run.y >= height || run.x0 < 0 || run.x1 > width || run.x0 > run.x1)
            throw Error("a step paints outside the window; expected a log of this size");
    const Rect& w = step.window;
    if (w.x < 0 || w.y < 0 || w.width < 0 || w.height < 0 || w.width > width - w.x ||
        w.height > height - w.y)
        throw Error("a step marks pixels outside the window; expected a log of this size");
}

}  // namespace

const char* name_of(Level level) { return level_names[std::size_t(level)]; }
const char* name_of(Action action) { return action_names[std::size_t(action)]; }

std::string to_json(const Step& step) {
    Json json{{"level", name_of(step.level)}, {"action", name_of(step.action)}};
    if (!step.polygons.empty()) json["polygons"] = step.polygons;
    if (!step.test.empty()) json["test"] = step.test;
    if (!step.result.empty()) json["result"] = step.result;
    if (step.row >= 0) json["row"] = step.row;
    for (const auto& [run, id] : step.painted)
        json["painted"].push_back({run.y, run.x0, run.x1, id});
    if (!step.before.empty()) json["before"] = json_of(step.before);
    if (!step.behind.empty()) json["behind"] = json_of(step.behind);
    if (const Rect& w = step.window; w.width > 0) json["window"] = {w.x, w.y, w.width, w.height};
    return json.dump();
}

Step step_from_json(const std::string& line) {
    try {
        return parse(line);
    } catch (const nlohmann::json::exception& error) {
        throw Error(std::string(error.what()) + "; expected a line that gw hidden wrote");
    }
}

Replay::Replay(std::vector<Step> steps, int width, int height)
    : steps_(std::move(steps)), ids_(std::size_t(width) * std::size_t(height)), width_(width) {
    for (const Step& step : steps_) check(step, width, height);
}

template <class Change>
void Replay::for_painted(const Step& step, const Change& change) {
    for (const auto& [run, id] : step.painted)
        for (int x = run.x0; x < run.x1; ++x)
            change(ids_[std::size_t(run.y) * std::size_t(width_) + std::size_t(x)], id);
}

void Replay::forward() {
    const Step& step = steps_.at(position());
    Undo undo;
    for_painted(step, [&](std::uint32_t& pixel, std::uint32_t id) {
        undo.ids.push_back(std::exchange(pixel, id));
    });
    if (step.action == Action::Sort) undo.order = std::exchange(order_, step.polygons);
    undo_.push_back(std::move(undo));
}

void Replay::backward() {
    const Undo undo = std::move(undo_.back());
    undo_.pop_back();
    const Step& step = steps_[position()];
    // A step may paint a pixel twice: restore in reverse, so that the first value comes back last.
    std::vector<std::uint32_t*> pixels;
    for_painted(step, [&](std::uint32_t& pixel, std::uint32_t) { pixels.push_back(&pixel); });
    for (std::size_t i = pixels.size(); i-- > 0;) *pixels[i] = undo.ids[i];
    if (step.action == Action::Sort) order_ = undo.order;
}

void Replay::go_to(std::size_t to) {
    while (position() < to && position() < size()) forward();
    while (position() > to) backward();
}

}  // namespace gw::hiddensurface
