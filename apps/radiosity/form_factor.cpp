#include "apps/radiosity/options.h"

#include "apps/command/terminal.h"
#include "gw/error.h"
#include "gw/escape_controls.h"

#include <fmt/format.h>

#include <set>

namespace gw::apps {
namespace {

/// The form factor from one figure to another, the mean over the first one's patches, and the first
/// one's area.
std::pair<double, double> form_factor(const radiosity::PixmapModel& model,
                                      radiosity::FormFactors& factors, const std::string& from,
                                      const std::string& to, Progress& progress) {
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

void check_figure(const radiosity::PixmapModel& model, const std::string& name) {
    std::set<std::string> names;
    for (const radiosity::Figure& figure : model.figures) names.insert(figure.name);
    if (names.contains(name)) return;
    std::string known;
    for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
    throw Error(fmt::format("--form-factor: no figure '{}'; expected one of {}", name, known));
}

}  // namespace

void print_form_factor(const RadiosityOptions& options, const radiosity::PixmapModel& model,
                       Progress& progress) {
    const std::string &a = options.form_factor[0], &b = options.form_factor[1];
    check_figure(model, a);
    check_figure(model, b);
    radiosity::FormFactors factors(model, options.solver.form_factors);
    const auto [ab, area_a] = form_factor(model, factors, a, b, progress);
    const auto [ba, area_b] = form_factor(model, factors, b, a, progress);
    const auto line = [](const std::string& from, const std::string& to, double factor,
                         double area) {
        return fmt::format("F({} -> {}) = {:.9f}   area {:.9g}\n", escape_controls(from),
                           escape_controls(to), factor, area);
    };
    print(line(a, b, ab, area_a) + line(b, a, ba, area_b));
    if (ab > 0 && ba > 0)
        print(fmt::format("reciprocity: A F / (A F) = {:.6f}\n", area_a * ab / (area_b * ba)));
}

}  // namespace gw::apps
