// gw radiosity: pixmaps are solved, saved, shown [F].
#include "apps/command.h"
#include "apps/progress.h"
#include "apps/radiosity_options.h"
#include "apps/radiosity_pictures.h"
#include "apps/terminal.h"
#include "gw/error.h"
#include "image/layers.h"
#include "plot/plot.h"
#include "radiosity/saved.h"

#include <fmt/format.h>

#include <chrono>
#include <set>

namespace gw::apps {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double seconds_between_saves = 5;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// --- one form factor

/// The mean over a figure's patches of what they send to another figure, and what the first one's area is.
std::pair<double, double> form_factor(const radiosity::Model& model, radiosity::FormFactors& factors,
                                      const std::string& from, const std::string& to, Progress& progress) {
    std::set<std::uint32_t> sources, targets;
    for (const radiosity::Figure& figure : model.figures) {
        if (figure.name == from) sources.insert(figure.pixmap);
        if (figure.name == to) targets.insert(figure.pixmap);
    }
    double sum = 0, area = 0;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        if (!sources.contains(model.patches[p].pixmap)) continue;
        progress.at(fmt::format("from {}, patch {}", from, p + 1));
        const radiosity::Row row = factors.from_patch(p);
        area += model.patches[p].area;
        for (std::size_t i = 0; i < row.texels.size(); ++i)
            for (std::uint32_t pixmap : targets) {
                const std::size_t first = model.pixmaps[pixmap].first;
                if (row.texels[i] >= first && row.texels[i] < first + model.pixmaps[pixmap].count())
                    sum += model.patches[p].area * row.factors[i];
            }
    }
    return {sum / area, area};
}

void check_figure(const radiosity::Model& model, const std::string& name) {
    std::set<std::string> names;
    for (const radiosity::Figure& figure : model.figures) names.insert(figure.name);
    if (names.contains(name)) return;
    std::string known;
    for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
    throw Error(fmt::format("--form-factor: no figure '{}'; expected one of {}", name, known));
}

int print_form_factor(const RadiosityOptions& options, const radiosity::Model& model, Progress& progress) {
    const std::string &a = options.form_factor[0], &b = options.form_factor[1];
    check_figure(model, a);
    check_figure(model, b);
    radiosity::FormFactors factors(model, options.solver.form_factors);
    const auto [ab, area_a] = form_factor(model, factors, a, b, progress);
    const auto [ba, area_b] = form_factor(model, factors, b, a, progress);
    print(fmt::format("F({} -> {}) = {:.9f}   area {:.9g}\nF({} -> {}) = {:.9f}   area {:.9g}\n", a, b, ab,
                      area_a, b, a, ba, area_b));
    if (ab > 0 && ba > 0)
        print(fmt::format("reciprocity: A F / (A F) = {:.6f}\n", area_a * ab / (area_b * ba)));
    return done;
}

// --- saved pixmaps

image::Layers layers_of(const radiosity::Saved& saved) {
    image::Layers layers{saved.facts, {}};
    for (const radiosity::SavedPixmap& p : saved.pixmaps)
        layers.layers.push_back({fmt::format("{:05} {}", layers.layers.size(), p.name), p.width, p.height,
                                 radiosity::saved_channels(), p.values});
    return layers;
}

radiosity::Solution load_solution(const std::filesystem::path& file, const radiosity::Model& model,
                                  const radiosity::FormFactorOptions& options) {
    // What it is for is said before what is wrong with its values.
    radiosity::check_saved({image::read_layer_facts(file).facts, {}}, model, options, file.string());
    radiosity::Saved saved;
    image::Layers layers = image::read_layers(file);
    saved.facts = std::move(layers.facts);
    for (image::Layer& layer : layers.layers)
        saved.pixmaps.push_back({layer.name, layer.width, layer.height, std::move(layer.values)});
    return radiosity::load(saved, model, options, file.string());
}

// --- the report

struct Step {
    std::uint64_t shots = 0;
    double seconds = 0, unshot = 0, absorbed = 0, escaped = 0, imbalance = 0;
    int hemicubes = 0;
};

Step step_of(const radiosity::Solver& solver, double seconds, int hemicubes) {
    const radiosity::Books b = radiosity::books(solver.model(), solver.solution());
    const auto share = [&](const dvec3& v) {
        return ((v.x + v.y) + v.z) / ((b.emitted.x + b.emitted.y) + b.emitted.z);
    };
    return {solver.solution().shots, seconds,       b.unshot_share(), share(b.absorbed),
            share(b.escaped),        b.imbalance(), hemicubes};
}

std::string report(const std::vector<Step>& steps) {
    std::string text = "shots,seconds,hemicubes,unshot,absorbed,escaped,imbalance\n";
    for (const Step& s : steps)
        text += fmt::format("{},{:.3f},{},{:.9g},{:.9g},{:.9g},{:.3g}\n", s.shots, s.seconds, s.hemicubes,
                            s.unshot, s.absorbed, s.escaped, s.imbalance);
    return text;
}

void put_plot(const std::vector<Step>& steps, const char* name, const char* label, auto x,
              const std::filesystem::path& folder, image::OutputSet& files) {
    plot::Series series{.name = "unshot share", .points = {}, .markers = steps.size() < 60};
    for (const Step& s : steps)
        if (s.unshot > 0) series.points.push_back({x(s), s.unshot});
    if (series.points.empty()) return;
    files.add(folder / name)
        .write_text(plot::svg({.title = "Energy that is still to be sent on",
                               .x = {.label = label},
                               .y = {.label = "share of the emitted energy", .log = 10},
                               .series = {series}}));
}

// --- the computation

class Run {
public:
    Run(const RadiosityOptions& options, const scene::Scene& scene, radiosity::Model model,
        Progress& progress)
        : options_(options),
          progress_(progress),
          pictures_(options, scene),
          solver_(std::move(model), options.solver) {}

    int run() {
        image::OutputSet folder;
        folder.make_folder(options_.output);
        image::check_target(saved_file());
        if (options_.resume)
            solver_.resume(load_solution(saved_file(), solver_.model(), options_.solver.form_factors));
        steps_.push_back(step_of(solver_, 0, 0));
        folder.commit();
        while (!finished() && shoot()) after_shot();
        finish();
        return done;
    }

private:
    std::filesystem::path saved_file() const { return options_.output / "pixmaps.exr"; }

    bool finished() const {
        const Step& last = steps_.back();
        return options_.shots >= 0 ? last.shots >= static_cast<std::uint64_t>(options_.shots)
                                   : last.unshot <= options_.until;
    }

    bool shoot() {
        const auto shot = solver_.shoot();
        if (!shot) return false;
        hemicubes_ += shot->hemicubes;
        steps_.push_back(step_of(solver_, seconds_since(begin_), hemicubes_));
        progress_.at(
            fmt::format("shot {}, {:.2f} % unshot", steps_.back().shots, 100 * steps_.back().unshot));
        return true;
    }

    void after_shot() {
        if (options_.every > 0 &&
            solver_.solution().shots % static_cast<std::uint64_t>(options_.every) == 0) {
            image::OutputSet files;
            pictures_.put(solver_, fmt::format("shot_{:06}", solver_.solution().shots), files);
            files.commit();
        }
        if (options_.save && seconds_since(saved_at_) > seconds_between_saves) {
            image::OutputSet files;
            put_saved(files);
            files.commit();
            saved_at_ = Clock::now();
        }
    }

    void put_saved(image::OutputSet& files) {
        image::put_layers(
            files.add(saved_file()),
            layers_of(radiosity::save(solver_.model(), options_.solver.form_factors, solver_.solution())));
    }

    void finish() {
        image::OutputSet files;
        const std::string text = pictures_.put(solver_, "picture", files);
        if (options_.save) put_saved(files);
        files.add(options_.output / "convergence.csv").write_text(report(steps_));
        put_plot(
            steps_, "convergence.svg", "shots", [](const Step& s) { return double(s.shots); },
            options_.output, files);
        put_plot(
            steps_, "convergence_seconds.svg", "seconds", [](const Step& s) { return s.seconds; },
            options_.output, files);
        files.commit();
        const Step& last = steps_.back();
        const radiosity::Model& model = solver_.model();
        print(fmt::format("{} figures, {} pixmaps, {} texels, {} patches\n", model.figures.size(),
                          model.pixmaps.size(), model.texel_count(), model.patches.size()));
        print(fmt::format(
            "{} shots, {} hemicubes, {:.1f} s: absorbed {:.4f}, unshot {:.4f}, escaped {:.4f} of what is "
            "emitted; books off by {:.1e}\n{}",
            last.shots, last.hemicubes, last.seconds, last.absorbed, last.unshot, last.escaped,
            last.imbalance, text));
    }

    const RadiosityOptions& options_;
    Progress& progress_;
    RadiosityPictures pictures_;
    radiosity::Solver solver_;
    std::vector<Step> steps_;
    int hemicubes_ = 0;
    Clock::time_point begin_ = Clock::now(), saved_at_ = begin_;
};

int compute(RadiosityOptions options) {
    check(options);
    Progress progress("reading", options.picture.quiet);
    const scene::Scene scene = load_scene(options.picture);
    options.solver.form_factors.threads = options.picture.threads;
    radiosity::Model model = radiosity::make_model(scene, options.model);
    if (!options.form_factor.empty()) return print_form_factor(options, model, progress);
    return Run(options, scene, std::move(model), progress).run();
}

}  // namespace

Command add_radiosity(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("radiosity", "Light that is reflected diffusely, solved in pixmaps");
    const auto options = std::make_shared<RadiosityOptions>();
    add_radiosity_options(*command, *options);
    command->footer(
        "Example:\n  build/release/bin/gw radiosity scenes/radiosity/cornell.toml -o box --shots 60 --gamma "
        "2.2");
    return {command, [options] { return compute(*options); }};
}

}  // namespace gw::apps
