#include "radiosity/solver/solver.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

void add(dvec3& stored, const dvec3& more) {
    for (int c = 0; c < 3; ++c) stored[c] = storable(stored[c] + more[c]);
}

}  // namespace

Solver::Solver(PixmapModel model, const SolverOptions& options)
    : model_(std::make_unique<PixmapModel>(std::move(model))),
      options_(options),
      form_factors_(std::make_unique<FormFactors>(*model_, options.form_factors)),
      solution_(initial_solution(*model_)) {
    check_emission(*model_);
}

void Solver::resume(Solution solution) {
    if (solution.H.size() != model_->texel_count() ||
        solution.unshot.size() != model_->texel_count())
        throw Error(fmt::format("a solution of {} texels; expected {}", solution.H.size(),
                                model_->texel_count()));
    solution_ = std::move(solution);
}

dvec3 Solver::unshot_flux(const Patch& patch) const {
    dvec3 flux(0);
    for_each_texel(*model_, patch,
                   [&](std::size_t t) { flux += model_->area[t] * solution_.unshot[t]; });
    return flux;
}

dvec3 Solver::shot_flux(const Patch& patch) const {
    dvec3 flux(0);
    for_each_texel(*model_, patch, [&](std::size_t t) {
        flux += model_->area[t] * (radiosity_at(*model_, solution_, t) - solution_.unshot[t]);
    });
    return flux;
}

std::pair<std::size_t, dvec3> Solver::brightest() const {
    std::pair<std::size_t, dvec3> best{0, dvec3(0)};
    for (std::size_t p = 0; p < model_->patches.size(); ++p) {
        const dvec3 flux = unshot_flux(model_->patches[p]);
        if (magnitude(flux) > magnitude(best.second)) best = {p, flux};
    }
    return best;
}

std::optional<Shot> Solver::shoot() {
    const auto [patch, flux] = brightest();
    if (flux == dvec3(0)) return std::nullopt;
    Shot shot{patch, flux, 0};
    const std::vector<dvec3> light = light_of_quarters(patch, flux);
    const std::vector<Row> rows = light.empty() ? std::vector{row_of(patch, &shot.hemicubes)}
                                                : quarters_of(patch, &shot.hemicubes);
    for_each_texel(*model_, model_->patches[patch],
                   [&](std::size_t t) { solution_.unshot[t] = dvec3(0); });
    if (rows.size() == 1)
        receive(rows.front(), flux);
    else
        for (std::size_t q = 0; q < rows.size(); ++q) receive(rows[q], light[q] / rows[q].sum());
    ++solution_.shots;
    return shot;
}

namespace {

/// The part of a texel's light that the quarter on one side sends; `at` from the patch's middle, in
/// halves of its side. It goes to the quarters' middles so that its centre stays where it is.
double part_of(double at, bool high) { return 0.5 + (high ? 1 : -1) * std::clamp(at, -0.5, 0.5); }

/// In parts of a quarter's radiosity: less uneven light is sent as its mean.
constexpr double uneven = 0.25;

}  // namespace

/// None if the patch sends the same light everywhere.
std::vector<dvec3> Solver::light_of_quarters(std::size_t number, const dvec3& flux) const {
    const Patch& patch = model_->patches[number];
    const Pixmap& pixmap = model_->pixmaps[patch.pixmap];
    std::vector<dvec3> light(4, dvec3(0));
    dvec3 all(0);
    for (int y = 0; y < patch.height; ++y)
        for (int x = 0; x < patch.width; ++x) {
            const std::size_t t = pixmap.texel(patch.x + x, patch.y + y);
            const double u = (2 * x + 1.0) / patch.width - 1, v = (2 * y + 1.0) / patch.height - 1;
            all += model_->area[t] * radiosity_at(*model_, solution_, t);
            for (std::size_t q = 0; q < light.size(); ++q)
                light[q] +=
                    part_of(u, q & 1) * part_of(v, q & 2) * (model_->area[t] * solution_.unshot[t]);
        }
    const bool is_uneven = std::any_of(light.begin(), light.end(), [&](const dvec3& quarter) {
        return magnitude(4.0 * quarter - flux) > uneven * magnitude(all);
    });
    if (!is_uneven || !form_factors_->has_quarters(number)) light.clear();
    return light;
}

// Rows depend on the patch alone, so that a shot has the same bits whether they were kept or not.
// The quarters' rows, which a later shot may need, are kept while half of the memory is free.
Row Solver::row_of(std::size_t patch, int* drawn) {
    if (const auto* kept = rows_.find(patch)) return form_factors_->combined(*kept);
    std::vector<Row> quarters = form_factors_->from_quarters(patch);
    Row row = form_factors_->combined(quarters);
    *drawn += row.hemicubes;
    rows_.keep(patch, std::move(quarters), options_.row_memory / 2);
    if (!rows_.find(patch)) rows_.keep(patch, {row}, options_.row_memory);
    return row;
}

std::vector<Row> Solver::quarters_of(std::size_t patch, int* drawn) {
    if (const auto* kept = rows_.find(patch); kept && kept->size() > 1) return *kept;
    std::vector<Row> rows = form_factors_->from_quarters(patch);
    for (const Row& row : rows) *drawn += row.hemicubes;
    rows_.keep(patch, rows, options_.row_memory);
    return rows;
}

void Solver::receive(const Row& row, const dvec3& flux) {
    for (std::size_t i = 0; i < row.texels.size(); ++i) {
        const dvec3 density = flux * (row.factors[i] / model_->element_area[row.texels[i]]);
        for (std::uint32_t t = row.texels[i]; t != no_texel; t = model_->next_of_element[t]) {
            const dvec3 before = solution_.H[t];
            add(solution_.H[t], density);
            add(solution_.unshot[t], model_->rho[t] * (solution_.H[t] - before));
        }
    }
    solution_.backs += flux * row.backs;
    solution_.escaped += flux * row.escaped;
}

}  // namespace gw::radiosity
