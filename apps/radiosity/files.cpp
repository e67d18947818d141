#include "apps/radiosity/files.h"

#include "gw/error.h"
#include "image/layers.h"
#include "radiosity/solver/saved.h"
#include "study/plot/plot.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

image::Layers layers_of(const radiosity::Saved& saved) {
    image::Layers layers{saved.facts, {}};
    for (const radiosity::SavedPixmap& p : saved.pixmaps)
        layers.layers.push_back({fmt::format("{:05} {}", layers.layers.size(), p.name), p.width,
                                 p.height, radiosity::saved_channels(), p.values});
    return layers;
}

std::string report(const std::vector<Step>& steps) {
    std::string text = "shots,seconds,hemicubes,unshot,absorbed,escaped,imbalance\n";
    for (const Step& s : steps)
        text += fmt::format("{},{:.3f},{},{:.9g},{:.9g},{:.9g},{:.3g}\n", s.shots, s.seconds,
                            s.hemicubes, s.unshot, s.absorbed, s.escaped, s.imbalance);
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

}  // namespace

void put_solution(image::OutputSet& files, const std::filesystem::path& file,
                  const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                  const radiosity::Solution& solution) {
    image::put_layers(files.add(file), layers_of(radiosity::save(model, options, solution)));
}

radiosity::Solution load_solution(const std::filesystem::path& file,
                                  const radiosity::PixmapModel& model,
                                  const radiosity::FormFactorOptions& options) {
    // A pipe may never end.
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        throw Error(file.string(), 0, "is not a regular file; expected one that --save wrote");
    // A file of another scene is reported before damaged values.
    radiosity::check_saved({image::read_layer_facts(file).facts, {}}, model, options,
                           file.string());
    radiosity::Saved saved;
    image::Layers layers = image::read_layers(file);
    saved.facts = std::move(layers.facts);
    for (image::Layer& layer : layers.layers)
        saved.pixmaps.push_back({layer.name, layer.width, layer.height, std::move(layer.values)});
    return radiosity::load(saved, model, options, file.string());
}

Step step_of(const radiosity::Solver& solver, double seconds, int hemicubes) {
    const radiosity::Books b = radiosity::books(solver.model(), solver.solution());
    const auto share = [&](const dvec3& v) {
        return ((v.x + v.y) + v.z) / ((b.emitted.x + b.emitted.y) + b.emitted.z);
    };
    return {solver.solution().shots, seconds,       b.unshot_share(), share(b.absorbed),
            share(b.escaped),        b.imbalance(), hemicubes};
}

void put_report(const std::vector<Step>& steps, const std::filesystem::path& folder,
                image::OutputSet& files) {
    files.add(folder / "convergence.csv").write_text(report(steps));
    put_plot(
        steps, "convergence.svg", "shots", [](const Step& s) { return double(s.shots); }, folder,
        files);
    put_plot(
        steps, "convergence_seconds.svg", "seconds", [](const Step& s) { return s.seconds; },
        folder, files);
}

}  // namespace gw::apps
