#include "apps/radiosity/files.h"

#include "gw/error.h"
#include "gw/escape_controls.h"
#include "image/layers.h"
#include "image/plot/plot.h"
#include "radiosity/solver/saved.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <sstream>

namespace gw::apps {
namespace {

image::Layers layers_of(const radiosity::Saved& saved) {
    image::Layers layers{saved.facts, {}};
    for (const radiosity::SavedPixmap& p : saved.pixmaps)
        layers.layers.push_back({fmt::format("{:05} {}", layers.layers.size(), p.name), p.width,
                                 p.height, radiosity::saved_channels(), p.values});
    return layers;
}

constexpr const char* curve_file = "convergence.csv";
constexpr const char* columns = "shots,seconds,hemicubes,unshot,absorbed,escaped,imbalance";

std::string row_of(const Step& s) {
    return fmt::format("{},{:.3f},{},{:.9g},{:.9g},{:.9g},{:.3g}", s.shots, s.seconds, s.hemicubes,
                       s.unshot, s.absorbed, s.escaped, s.imbalance);
}

/// None if row_of did not write it.
std::optional<Step> step_from(const std::string& row) {
    Step s;
    std::istringstream in(row);
    char comma = 0;
    in >> s.shots >> comma >> s.seconds >> comma >> s.hemicubes >> comma >> s.unshot >> comma >>
        s.absorbed >> comma >> s.escaped >> comma >> s.imbalance;
    if (!in || row_of(s) != row) return std::nullopt;
    return s;
}

/// The same state, whenever it was reached.
bool is_same_state(Step a, const Step& b) {
    a.seconds = b.seconds;
    a.hemicubes = b.hemicubes;
    return row_of(a) == row_of(b);
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

namespace {

radiosity::Saved read_saved(const std::filesystem::path& file, const radiosity::PixmapModel& model,
                            const radiosity::FormFactorOptions& options, const char* kind) {
    // A pipe may never end.
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        throw Error(file.string(), 0, "is not a regular file; expected one that --save wrote");
    // A file of another scene is reported before damaged values.
    radiosity::check_saved({image::read_layer_facts(file).facts, {}}, model, options, file.string(),
                           kind);
    radiosity::Saved saved;
    image::Layers layers = image::read_layers(file);
    saved.facts = std::move(layers.facts);
    for (image::Layer& layer : layers.layers)
        saved.pixmaps.push_back({layer.name, layer.width, layer.height, std::move(layer.values)});
    return saved;
}

std::filesystem::path share_file(const std::filesystem::path& folder, std::size_t number) {
    return folder / fmt::format("share_{}.exr", number + 1);
}

}  // namespace

radiosity::Solution load_solution(const std::filesystem::path& file,
                                  const radiosity::PixmapModel& model,
                                  const radiosity::FormFactorOptions& options) {
    return radiosity::load(read_saved(file, model, options, radiosity::whole_kind), model, options,
                           file.string());
}

void put_shares(image::OutputSet& files, const std::filesystem::path& folder,
                const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                const std::vector<radiosity::Share>& shares) {
    for (std::size_t i = 0; i < shares.size(); ++i)
        image::put_layers(
            files.add(share_file(folder, i)),
            layers_of(radiosity::save_share(model, options, shares[i], i + 1, shares.size())));
}

std::string text_of(const std::vector<radiosity::Share>& shares,
                    const radiosity::PixmapModel& model) {
    const auto sum_of = [](const dvec3& v) { return v.x + v.y + v.z; };
    const auto emitted = [&](const radiosity::Share& share) {
        double sum = 0;
        for (std::size_t t = 0; t < share.E.size(); ++t) sum += model.area[t] * sum_of(share.E[t]);
        for (const radiosity::DirectLight& light : model.direct)
            if (light.name == share.lamp) sum += sum_of(light.emitted);
        return sum;
    };
    double all = 0;
    for (const radiosity::Share& share : shares) all += emitted(share);
    std::string text;
    for (std::size_t i = 0; i < shares.size(); ++i)
        text += fmt::format("share_{}.exr: {}, {:.1f} % of the emitted energy\n", i + 1,
                            escape_controls(shares[i].lamp), 100 * emitted(shares[i]) / all);
    return text;
}

std::vector<radiosity::Share> load_shares(const std::filesystem::path& folder,
                                          const radiosity::PixmapModel& model,
                                          const radiosity::FormFactorOptions& options) {
    std::vector<radiosity::Share> shares;
    std::vector<std::string> names;
    for (const std::string& lamp : radiosity::lamps_of(model)) {
        const std::filesystem::path file = share_file(folder, shares.size());
        if (!std::filesystem::exists(file))
            throw Error(file.string(), 0, "does not exist; expected a lamp's light, by --shares");
        const radiosity::Saved saved = read_saved(file, model, options, radiosity::share_kind);
        names.push_back(file.string());
        shares.push_back(radiosity::load_share(saved, model, options, lamp, names.back()));
    }
    if (!shares.empty()) radiosity::check_same_shots(shares, names, shares.front().solution.shots);
    return shares;
}

Step step_of(const radiosity::PixmapModel& model, const radiosity::Solution& solution,
             double seconds, int hemicubes) {
    const radiosity::Books b = radiosity::books(model, solution);
    const auto share = [&](const dvec3& v) {
        return ((v.x + v.y) + v.z) / ((b.emitted.x + b.emitted.y) + b.emitted.z);
    };
    return {solution.shots,   seconds,       b.unshot_share(), share(b.absorbed),
            share(b.escaped), b.imbalance(), hemicubes};
}

std::vector<Step> resumed_curve(const std::filesystem::path& folder, const Step& now) {
    std::ifstream file(folder / curve_file);
    std::string row;
    std::vector<Step> steps;
    if (std::getline(file, row) && row == columns)
        while (std::getline(file, row)) {
            const std::optional<Step> step = step_from(row);
            if (!step) break;
            steps.push_back(*step);
            if (is_same_state(*step, now)) return steps;
        }
    return {now};
}

void put_curve(const std::vector<Step>& steps, const std::filesystem::path& folder,
               image::OutputSet& files) {
    std::string text = std::string(columns) + "\n";
    for (const Step& s : steps) text += row_of(s) + "\n";
    files.add(folder / curve_file).write_text(text);
}

void put_report(const std::vector<Step>& steps, const std::filesystem::path& folder,
                image::OutputSet& files) {
    put_curve(steps, folder, files);
    put_plot(
        steps, "convergence.svg", "shots", [](const Step& s) { return double(s.shots); }, folder,
        files);
    put_plot(
        steps, "convergence_seconds.svg", "seconds", [](const Step& s) { return s.seconds; },
        folder, files);
}

}  // namespace gw::apps
