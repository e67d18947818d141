#include "apps/view/frame_drawer.h"

#include "apps/hidden/pictures.h"
#include "gw/error.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/run/estimate.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/report/prices.h"
#include "scene/draw/nearest.h"
#include "scene/draw/view.h"

#include <fmt/format.h>

#include <chrono>

namespace gw::apps {
namespace {

namespace hs = hiddensurface;

/// Seconds that an algorithm may take; more would look like a program that hangs.
constexpr double longest_algorithm = 5;

image::Picture picture_of(Machine& machine) {
    const Planes& planes = machine.planes();
    return image::picture_of(planes.color, planes.width, planes.height,
                             machine.profile().color_bits);
}

void check(const hs::Estimate& estimate) {
    if (hs::is_beyond(estimate, longest_algorithm))
        throw Error(hs::text_of(estimate) + "; expected fewer polygons, or another algorithm");
}

template <class Counts, class Names>
void add_counts(Frame& frame, const Counts& counts, const Names& names) {
    for (const auto& [name, count] : names)
        if (counts.*count != 0)
            frame.notes.push_back(fmt::format("{:<11}{:>12}", name, counts.*count));
}

}  // namespace

/// What stays from frame to frame.
struct FrameDrawer::Cache {
    std::string machine_key;
    std::unique_ptr<Machine> machine;
    std::string key;                          ///< of the last picture
    std::unique_ptr<Drawing> drawing;         ///< to which its drawer refers
    scene::Bounds bounds;                     ///< of its scene
    std::map<std::string, std::string> sets;  ///< parameter sets by pass
    std::function<void(const scene::View&)> draw;
};

FrameDrawer::FrameDrawer(scene::Scene scene, std::optional<multipass::PassList> own_passes,
                         std::map<std::string, Profile> profiles)
    : scene_(std::move(scene)),
      own_passes_(std::move(own_passes)),
      profiles_(std::move(profiles)),
      cache_(std::make_unique<Cache>()) {}

FrameDrawer::~FrameDrawer() = default;

Frame FrameDrawer::timed(const Settings& settings, const std::function<void(Frame&)>& work) {
    Frame frame{.settings = settings};
    const auto begin = std::chrono::steady_clock::now();
    try {
        work(frame);
    } catch (const Error& error) {
        frame.fault = error.what();
        cache_ = std::make_unique<Cache>();
    }
    frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return frame;
}

Drawing FrameDrawer::drawing_of(const Settings& settings) const {
    render::Request request = settings.picture;
    request.camera = {};
    return render::make_drawing(request, profiles_.at(request.profile),
                                {.scene = scene_of(scene_, settings), .passes = own_passes_});
}

Machine& FrameDrawer::machine_for(const Settings& settings) {
    const PictureOptions& options = settings.picture;
    const std::string key =
        fmt::format("{} {} {}", options.profile, options.size.width, options.size.height);
    if (key != cache_->machine_key) {
        cache_ = std::make_unique<Cache>();
        cache_->machine = render::make_machine(options, profiles_.at(options.profile));
        cache_->machine_key = key;
    }
    cache_->machine->reset_passes();
    return *cache_->machine;
}

void FrameDrawer::add_passes(Frame& frame, const std::map<std::string, std::string>& sets,
                             Machine& machine) const {
    static const report::PriceList prices = report::vgx_prices();
    for (const PassReport& pass : machine.passes()) {
        const auto set = sets.find(pass.name);
        frame.passes.push_back({pass.name, set == sets.end() ? "" : set->second, pass.counters,
                                report::estimated_seconds(pass.counters, prices)});
    }
}

Frame FrameDrawer::draw(const Settings& settings) {
    return timed(settings, [&](Frame& frame) {
        Machine& machine = machine_for(settings);
        const std::string key = key_of(settings);
        if (key != cache_->key) {
            cache_->draw = nullptr;
            cache_->key = key;
            cache_->drawing = std::make_unique<Drawing>(drawing_of(settings));
            cache_->bounds = scene::bounds(cache_->drawing->scene);
            cache_->sets = render::parameter_sets(*cache_->drawing);
            cache_->draw = render::view_drawer(*cache_->drawing, machine);
            machine.reset_passes();
        }
        cache_->drawing->scene.camera = settings.camera;
        const auto [width, height] = settings.picture.size;
        cache_->draw(scene::fitted_view(settings.camera, cache_->drawing->scene, cache_->bounds,
                                        width, height));
        frame.picture = picture_of(machine);
        add_passes(frame, cache_->sets, machine);
    });
}

Frame FrameDrawer::draw_by_pass(const Settings& settings) {
    return timed(settings, [&](Frame& frame) {
        const Drawing drawing = drawing_of(settings);
        const auto machine = render::make_machine(settings.picture, drawing.profile);
        inspect::Recording recording{.profile = drawing.profile,
                                     .width = settings.picture.size.width,
                                     .height = settings.picture.size.height};
        inspect::Recorder recorder(*machine, recording.lists);
        render::draw(drawing, drawing.view(), recorder);
        frame.picture = picture_of(*machine);
        add_passes(frame, render::parameter_sets(drawing), *machine);
        frame.by_pass =
            std::make_shared<inspect::Replayed>(std::move(recording), settings.picture.threads);
    });
}

std::string FrameDrawer::hidden_picture(Machine& machine, const std::string& algorithm,
                                        const scene::Scene& scene, Frame& frame) const {
    const auto [width, height] = frame.settings.picture.size;
    const scene::View view = scene::make_view(scene, width, height);
    const hs::Input input = hs::make_input(scene, view, machine.profile());
    hs::StepLog none;
    if (const hs::LineAlgorithm* lines = hs::line_algorithm_named(algorithm)) {
        check(hs::estimate(*lines, input));
        const hs::LineResult result = hs::run_on(machine, *lines, input, none);
        frame.picture = picture_of(machine);
        add_counts(frame, result.counts, hs::line_count_names());
        return lines->title;
    }
    const hs::Algorithm& surfaces = hs::algorithm_named(algorithm);
    check(hs::estimate(surfaces, input));
    const hs::Result result = hs::run_on(machine, surfaces, input, none);
    frame.picture = result.shares.empty()
                        ? picture_of_ids(input, result.ids, hs::flat_colors(input))
                        : picture_of_shares(input, result.shares, hs::flat_colors(input));
    add_counts(frame, result.counts, hs::count_names());
    return surfaces.title;
}

Frame FrameDrawer::draw_hidden(const Settings& settings, const std::string& algorithm) {
    return timed(settings, [&](Frame& frame) {
        Machine& machine = machine_for(settings);
        cache_->key.clear();
        const std::string title =
            hidden_picture(machine, algorithm, scene_of(scene_, settings), frame);
        frame.notes.insert(frame.notes.begin(), title);
    });
}

}  // namespace gw::apps
