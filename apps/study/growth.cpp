#include "apps/study/growth.h"

#include "apps/study/growth_scenes.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/run/compare.h"
#include "scene/draw/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <memory>

namespace gw::study {

namespace hs = hiddensurface;

namespace {

/// One step of an axis: two frames, the same but for the axis of frames.
struct GrowthStep {
    double parameter = 0;
    int width = 160, height = 120;
    std::function<scene::Scene(double degrees)> scene;
    double degrees = 0;  ///< between the frames
};

std::vector<GrowthStep> places(const std::string& axis, bool lines) {
    std::vector<GrowthStep> all;
    const auto add = [&](double parameter, int count, double depth, int width, double degrees) {
        all.push_back({parameter, width, width * 3 / 4,
                       [=](double turned) {
                           return lines ? hill_grid(count, 8 / depth, turned)
                                        : triangle_soup(count, depth, turned);
                       },
                       degrees});
    };
    if (axis == "polygons")
        for (int n = 16; n <= 8192; n *= 2) add(n, n, 4, 160, 0);
    if (axis == "depth")
        for (double d = 1; d <= 32; d *= 2) add(d, 256, d, 160, 0);
    if (axis == "resolution")
        for (int width = 40; width <= 1280; width *= 2) add(width, 256, 4, width, 0);
    if (axis == "frames")
        for (double degrees = 0.25; degrees <= 8; degrees *= 2) add(degrees, 256, 4, 160, degrees);
    return all;
}

struct Setup {
    Setup(const GrowthStep& place, double degrees, const GrowthOptions& options)
        : scene(place.scene(degrees)),
          view((scene::add_defaults(scene, place.width, place.height),
                scene::make_view(scene, place.width, place.height))),
          machine(make_fast(vgx(), place.width, place.height, {.threads = options.threads})),
          input(hs::make_input(scene, view, vgx())) {}
    Setup(const Setup&) = delete;

    /// Mean number of polygons over a pixel of the window.
    double depth() const {
        double sum = 0;
        for (const std::uint8_t n : hs::depth_complexity(input)) sum += n;
        return sum / view.width / view.height;
    }

    scene::Scene scene;
    scene::View view;
    std::unique_ptr<Machine> machine;
    hs::Input input;
};

/// Processor time, the least of up to three runs; long runs are not repeated.
double seconds_of(const std::function<void()>& run) {
    double least = 1e30;
    for (int i = 0; i < 3 && (i == 0 || least < 0.05); ++i) {
        const std::clock_t begin = std::clock();
        run();
        least = std::min(least, double(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return std::max(least, 1e-6);  // the clock's step
}

std::vector<std::uint32_t> order_of(const hs::Input& input, const hs::Result& result) {
    std::vector<std::uint32_t> ids;
    for (const hs::Piece& piece : result.pieces) ids.push_back(input.polygons[piece.polygon].id);
    return ids;
}

std::map<std::string, double> measured(const hs::Algorithm& algorithm, Setup& setup,
                                       Setup* before) {
    hs::StepLog none;
    std::map<std::string, double> values;
    values["seconds"] =
        seconds_of([&] { setup.machine->execute(algorithm.run(setup.input, none).list); });
    const hs::Result result = hs::run_on(*setup.machine, algorithm, setup.input, none);
    for (const auto& [name, count] : hs::count_names()) values[name] = double(result.counts.*count);
    if (!before) return values;
    const hs::Result earlier = hs::run_on(*before->machine, algorithm, before->input, none);
    double changed = 0;
    for (std::size_t i = 0; i < result.ids.size(); ++i)
        changed += result.ids[i] != earlier.ids[i] ? 1 : 0;
    values["changed"] = changed;
    values["moved"] =
        double(moves_between(order_of(before->input, earlier), order_of(setup.input, result)));
    return values;
}

std::map<std::string, double> measured(const hs::LineAlgorithm& algorithm, Setup& setup,
                                       Setup* before) {
    hs::StepLog none;
    std::map<std::string, double> values;
    values["seconds"] = seconds_of([&] {
        const hs::LineOutput output = algorithm.run(setup.input, none);
        setup.machine->execute(hs::draw_lines(setup.input, algorithm.name, output.lines));
    });
    const hs::LineResult result = hs::run_on(*setup.machine, algorithm, setup.input, none);
    for (const auto& [name, count] : hs::line_count_names())
        values[name] = double(result.counts.*count);
    if (!before) return values;
    const hs::LineResult earlier = hs::run_on(*before->machine, algorithm, before->input, none);
    double changed = 0;
    for (std::size_t i = 0; i < result.lit.size(); ++i)
        changed += result.lit[i] != earlier.lit[i] ? 1 : 0;
    values["changed"] = changed;
    return values;
}

class GrowthStudy {
public:
    GrowthStudy(const GrowthOptions& options, const std::function<void(const std::string&)>& say)
        : options_(options), say_(say) {}

    template <class Algorithm>
    void run(const std::string& axis, bool lines, std::vector<Algorithm> algorithms) {
        std::erase_if(algorithms, [&](const Algorithm& algorithm) {
            const auto& only = options_.only;
            return !only.empty() &&
                   std::find(only.begin(), only.end(), algorithm.name) == only.end();
        });
        if (algorithms.empty()) return;
        std::map<std::string, std::vector<double>> times;
        for (const GrowthStep& place : places(axis, lines)) {
            const bool all_cut =
                std::all_of(algorithms.begin(), algorithms.end(), [&](const auto& algorithm) {
                    return next(times[algorithm.name]) > options_.limit;
                });
            if (all_cut) {
                for (const auto& algorithm : algorithms)
                    cut(axis, algorithm.name, times[algorithm.name].back());
                break;
            }
            Setup setup(place, place.degrees, options_);
            std::unique_ptr<Setup> before;
            if (place.degrees > 0) before = std::make_unique<Setup>(place, 0, options_);
            const double x = axis == "depth"        ? setup.depth()
                             : axis == "resolution" ? double(place.width) * place.height
                                                    : place.parameter;
            for (const auto& algorithm : algorithms) {
                std::vector<double>& t = times[algorithm.name];
                if (next(t) > options_.limit) {
                    cut(axis, algorithm.name, t.back());
                    continue;
                }
                say_(fmt::format("{} {:.6g}: {}", axis, x, algorithm.name));
                growth_.points.push_back(
                    {axis, lines, x, algorithm.name, measured(algorithm, setup, before.get())});
                t.push_back(growth_.points.back().values.at("seconds"));
            }
        }
    }
    Growth take() { return std::move(growth_); }

private:
    /// Predicts the next time from the ratio of the last two, clamped against noise.
    static double next(const std::vector<double>& t) {
        if (t.empty()) return 0;
        if (t.size() < 2) return t.back();
        return t.back() * std::clamp(t.back() / t[t.size() - 2], 1.0, 8.0);
    }

    void cut(const std::string& axis, const std::string& name, double seconds) {
        for (const GrowthCut& c : growth_.cuts)
            if (c.axis == axis && c.algorithm == name) return;
        for (auto p = growth_.points.rbegin(); p != growth_.points.rend(); ++p)
            if (p->axis == axis && p->algorithm == name)
                return growth_.cuts.push_back({axis, name, p->x, seconds});
    }

    GrowthOptions options_;
    const std::function<void(const std::string&)>& say_;
    Growth growth_;
};

}  // namespace

const std::vector<GrowthAxis>& growth_axes() {
    static const std::vector<GrowthAxis> axes{
        {"polygons", "polygons"},
        {"depth", "depth complexity: polygons over a pixel (mean of the window)"},
        {"resolution", "pixels", 10},
        {"frames", "degrees from frame to frame"}};
    return axes;
}

std::vector<std::string> growth_values(bool lines) {
    std::vector<std::string> names{"seconds", "moved", "changed"};
    if (lines)
        for (const auto& [name, count] : hs::line_count_names()) names.push_back(name);
    else
        for (const auto& [name, count] : hs::count_names()) names.push_back(name);
    return names;
}

std::vector<std::string> right_algorithms() {
    std::vector<std::string> names;
    for (const hs::Algorithm& algorithm : hs::algorithms())
        if (algorithm.claim == hs::Claim::Always) names.push_back(algorithm.name);
    return names;
}

Growth growth(const GrowthOptions& options, const std::function<void(const std::string&)>& say) {
    GrowthStudy study(options, say);
    for (const GrowthAxis& axis : growth_axes()) {
        if (!options.axis.empty() && axis.name != options.axis) continue;
        study.run(axis.name, false, hs::algorithms());
        study.run(axis.name, true, hs::line_algorithms());
    }
    return study.take();
}

std::size_t moves_between(const std::vector<std::uint32_t>& before,
                          const std::vector<std::uint32_t>& after) {
    // Equal identifiers (pieces of one polygon) are distinguished by their number so far.
    std::map<std::pair<std::uint32_t, int>, std::size_t> place;
    std::map<std::uint32_t, int> seen;
    for (std::size_t i = 0; i < before.size(); ++i) place[{before[i], seen[before[i]]++}] = i;
    seen.clear();
    // The least last place of the ascending sequences of each length.
    std::vector<std::size_t> ends;
    for (const std::uint32_t id : after) {
        const auto found = place.find({id, seen[id]++});
        if (found == place.end()) continue;
        const auto at = std::lower_bound(ends.begin(), ends.end(), found->second);
        at == ends.end() ? ends.push_back(found->second) : void(*at = found->second);
    }
    return std::max(before.size(), after.size()) - ends.size();
}

}  // namespace gw::study
