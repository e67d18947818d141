// Passes: the list, each pass's planes, counters and estimated time; pixel histories.
#include "gw/error.h"
#include "image/plane_pictures.h"
#include "inspect/manifest/json_of.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/plane_values.h"
#include "inspect/report/prices.h"
#include "multipass/passes/pass_toml.h"
#include "web/engine/method.h"
#include "web/engine/rgba.h"

#include <algorithm>
#include <utility>

namespace gw::lab {
namespace {

Plane plane_from(const std::string& word) {
    for (const Plane plane : every_plane)
        if (word == name_of(plane)) return plane;
    throw Error("plane '" + word + "'; expected color, depth, stencil, accum or back");
}

inspect::Replayed& kept(const std::unique_ptr<inspect::Replayed>& replayed) {
    if (!replayed) throw Error("nothing was drawn pass by pass; expected passes() before");
    return *replayed;
}

}  // namespace

Json LabSession::passes(const Json& options) {
    const render::Drawing drawing = drawing_of(options);
    const auto machine = render::make_machine(drawing.request, drawing.profile);
    inspect::Recording recording{.profile = drawing.profile,
                                 .width = drawing.request.size.width,
                                 .height = drawing.request.size.height};
    inspect::Recorder recorder(*machine, recording.lists);
    render::draw(drawing, drawing.view(), recorder);
    keep_picture(*machine);

    const multipass::PassList list = render::pass_list(drawing);
    const auto sources = render::pass_sources(drawing);
    const report::PriceList prices = report::vgx_prices();
    Json passes = Json::array();
    for (const PassReport& pass : machine->passes()) {
        const auto source = sources.find(pass.name);
        const bool own = source != sources.end();
        passes.push_back({{"name", pass.name},
                          {"set", own ? source->second.set : ""},
                          {"row", own ? Json(source->second.row) : Json()},
                          {"counters", inspect::json_of(pass.counters)},
                          {"seconds", report::estimated_seconds(pass.counters, prices)}});
    }
    replayed_ = std::make_unique<inspect::Replayed>(std::move(recording));
    map_ = {};
    std::vector<std::string> warnings = render::warnings(drawing);
    const std::string empty = render::empty_warning(drawing, *machine);
    if (!empty.empty()) warnings.push_back(empty);
    return {{"toml", multipass::to_toml(list)},
            {"passes", passes},
            {"machine", prices.machine},
            {"warnings", warnings}};
}

image::Picture LabSession::seen(const Planes& planes, Plane plane, const Profile& profile) const {
    const bool is_color = plane == Plane::Color || plane == Plane::Back;
    if (map_.bits == 0 || !is_color) return image::plane_picture(planes, plane, profile);
    const auto& indices = plane == Plane::Color ? planes.color : planes.back;
    constexpr int bits = 8;
    return image::picture_of(inspect::through_map(indices, map_), planes.width, planes.height,
                             bits);
}

Json LabSession::plane(const Json& options) {
    inspect::Replayed& replayed = kept(replayed_);
    const std::size_t pass = options.at("pass");
    if (pass >= replayed.passes())
        throw Error("pass " + std::to_string(pass) + "; expected less than " +
                    std::to_string(replayed.passes()));
    const Plane plane = plane_from(options.at("plane"));
    const Profile& profile = replayed.recording().profile;
    const Planes before = replayed.planes_after(pass);
    const Planes& after = replayed.planes_after(pass + 1);
    const image::Picture picture = seen(after, plane, profile);
    const auto apart = inspect::distances(before, after, plane);
    image::Change change{image::distance_picture(apart, after.width, after.height)};
    if (plane == Plane::Color || plane == Plane::Back)
        change = image::change_picture(seen(before, plane, profile), picture);
    picture_ = rgba_of(picture);
    change_ = rgba_of(change.picture);
    return {{"changed", std::count_if(apart.begin(), apart.end(),
                                      [](std::uint64_t distance) { return distance != 0; })},
            {"times", change.times}};
}

Json LabSession::history(const Json& options) {
    const inspect::Recording& recording = kept(replayed_).recording();
    const int x = options.at("x"), y = options.at("y");
    if (x < 0 || y < 0 || x >= recording.width || y >= recording.height)
        throw Error("pixel " + std::to_string(x) + " " + std::to_string(y) +
                    " is outside the picture");
    return inspect::history_rows(inspect::pixel_history(recording, x, recording.height - 1 - y));
}

const Method passes_methods[] = {
    {"passes", &LabSession::passes, {{"picture", &LabSession::picture}}},
    {"plane",
     &LabSession::plane,
     {{"picture", &LabSession::picture}, {"change", &LabSession::change}}},
    {"history", &LabSession::history},
};

}  // namespace gw::lab
