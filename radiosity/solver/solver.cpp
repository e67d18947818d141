#include "radiosity/solver/solver.h"

#include "gw/error.h"

#include <fmt/format.h>

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
    const Row row = row_of(patch, &shot.hemicubes);
    for_each_texel(*model_, model_->patches[patch],
                   [&](std::size_t t) { solution_.unshot[t] = dvec3(0); });
    receive(row, flux);
    ++solution_.shots;
    return shot;
}

// A row depends on the patch alone, so that a shot has the same bits whether the row was kept or
// not.
Row Solver::row_of(std::size_t patch, int* drawn) {
    if (const Row* kept = rows_.find(patch)) return *kept;
    Row row = form_factors_->from_patch(patch);
    *drawn += row.hemicubes;
    rows_.keep(patch, row, options_.row_memory);
    return row;
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
