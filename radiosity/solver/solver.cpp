#include "radiosity/solver/solver.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

void add_to(dvec3& stored, const dvec3& more) {
    for (int c = 0; c < 3; ++c) stored[c] = storable(stored[c] + more[c]);
}

}  // namespace

Solver::Solver(PixmapModel model, const SolverOptions& options)
    : model_(std::make_unique<PixmapModel>(std::move(model))),
      options_(options),
      form_factors_(std::make_unique<FormFactors>(*model_, options.form_factors)),
      solution_(initial_solution(*model_)),
      incoming_(model_->texel_count(), dvec3(0)) {
    check_emission(*model_);
}

void Solver::resume(Solution solution) {
    if (solution.H.size() != model_->texel_count() ||
        solution.unshot.size() != model_->texel_count())
        throw Error(fmt::format("a solution of {} texels; expected {}", solution.H.size(),
                                model_->texel_count()));
    solution_ = std::move(solution);
    parts_.clear();
}

void Solver::follow(std::vector<Solution> parts) {
    for (const Solution& part : parts)
        if (part.H.size() != model_->texel_count() || part.unshot.size() != model_->texel_count())
            throw Error(fmt::format("a part of {} texels; expected {}", part.H.size(),
                                    model_->texel_count()));
    parts_ = std::move(parts);
}

dvec3 Solver::unshot_flux(const Patch& patch, const Solution& solution) const {
    dvec3 flux(0);
    for_each_texel(*model_, patch,
                   [&](std::size_t t) { flux += model_->area[t] * solution.unshot[t]; });
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
        const dvec3 flux = unshot_flux(model_->patches[p], solution_);
        if (magnitude(flux) > magnitude(best.second)) best = {p, flux};
    }
    return best;
}

std::optional<Shot> Solver::shoot() {
    const auto [patch, flux] = brightest();
    if (flux == dvec3(0)) return std::nullopt;
    Shot shot{patch, flux, 0};
    const PatchRows& rows = rows_of(patch, &shot.hemicubes);
    send(patch, flux, rows, solution_);
    for (Solution& part : parts_)
        send(patch, unshot_flux(model_->patches[patch], part), rows, part);
    return shot;
}

void Solver::send(std::size_t patch, const dvec3& flux, const PatchRows& rows, Solution& solution) {
    ++solution.shots;
    if (flux == dvec3(0)) return;
    const std::vector<dvec3> light =
        rows.size() == 1 ? std::vector{flux} : light_of_quarters(patch, solution);
    for_each_texel(*model_, model_->patches[patch],
                   [&](std::size_t t) { solution.unshot[t] = dvec3(0); });
    add_light(rows, light, solution);
    receive(solution);
}

namespace {

/// The part of a texel's light that the quarter on one side sends; `at` from the patch's middle, in
/// halves of its side. It goes to the quarters' middles so that its centre stays where it is.
double part_of(double at, bool high) { return 0.5 + (high ? 1 : -1) * std::clamp(at, -0.5, 0.5); }

}  // namespace

std::vector<dvec3> Solver::light_of_quarters(std::size_t number, const Solution& solution) const {
    const Patch& patch = model_->patches[number];
    const Pixmap& pixmap = model_->pixmaps[patch.pixmap];
    std::vector<dvec3> light(4, dvec3(0));
    for (int y = 0; y < patch.height; ++y)
        for (int x = 0; x < patch.width; ++x) {
            const std::size_t t = pixmap.texel(patch.x + x, patch.y + y);
            const double u = (2 * x + 1.0) / patch.width - 1, v = (2 * y + 1.0) / patch.height - 1;
            for (std::size_t q = 0; q < light.size(); ++q)
                light[q] +=
                    part_of(u, q & 1) * part_of(v, q & 2) * (model_->area[t] * solution.unshot[t]);
        }
    return light;
}

// Rows depend on the patch alone, so that a shot has the same bits whether they were kept or not.
const PatchRows& Solver::rows_of(std::size_t patch, int* drawn) {
    if (const PatchRows* kept = rows_.find(patch)) return *kept;
    if (exchange_ && !rows_.expects(patch)) draw_together(patch);
    DrawnRows now = rows_.expects(patch) ? rows_.take(patch) : draw(patch);
    *drawn += now.hemicubes;
    drawn_ = std::move(now.rows);
    rows_.keep(patch, drawn_, options_.row_memory);
    return drawn_;
}

DrawnRows Solver::draw(std::size_t patch) {
    const std::vector<Row> rows = form_factors_->from_quarters(patch);
    DrawnRows drawn{compact(rows), 0};
    for (const Row& row : rows) drawn.hemicubes += row.hemicubes;
    return drawn;
}

// Each process draws another patch: this one, and the next ones by their unshot light, which will
// probably shoot soon. All processes find the same patches, because they have the same light.
void Solver::draw_together(std::size_t patch) {
    std::vector<std::pair<double, std::size_t>> waiting;
    for (std::size_t p = 0; p < model_->patches.size(); ++p)
        if (p != patch && !rows_.find(p) && !rows_.expects(p))
            waiting.emplace_back(-magnitude(unshot_flux(model_->patches[p], solution_)), p);
    const std::size_t others = std::min(exchange_->processes() - 1, waiting.size());
    std::partial_sort(waiting.begin(), waiting.begin() + std::ptrdiff_t(others), waiting.end());
    std::vector<std::size_t> patches{patch};
    for (std::size_t i = 0; i < others; ++i) patches.push_back(waiting[i].second);
    const std::size_t mine = exchange_->rank();
    const std::vector<std::string> all =
        exchange_->exchange(mine < patches.size() ? to_bytes(draw(patches[mine])) : std::string());
    for (std::size_t i = patches.size(); i-- > 0;)
        rows_.expect(patches[i], rows_from(all.at(i)), options_.row_memory);
}

/// Adds the light of a patch's quarters to the incoming light. One quarter's form factors may add up
/// to a little less or more than 1; the rest is sent from all quarters, so that no light is lost.
void Solver::add_light(const PatchRows& rows, const std::vector<dvec3>& light, Solution& solution) {
    dvec3 rest(0);
    for (std::size_t q = 0; q < rows.size(); ++q) rest += (1 - rows[q].sum()) * light[q];
    for (std::size_t q = 0; q < rows.size(); ++q) {
        const dvec3 flux = light[q] + rest / double(rows.size());
        rows[q].for_each([&](std::uint32_t t, double factor) { incoming_[t] += factor * flux; });
        solution.backs += rows[q].backs() * flux;
        solution.escaped += rows[q].escaped() * flux;
    }
}

void Solver::receive(Solution& solution) {
    for (std::size_t element = 0; element < incoming_.size(); ++element) {
        if (incoming_[element] == dvec3(0)) continue;
        const dvec3 density = incoming_[element] / model_->element_area[element];
        incoming_[element] = dvec3(0);
        for (auto t = std::uint32_t(element); t != no_texel; t = model_->next_of_element[t]) {
            const dvec3 before = solution.H[t];
            add_to(solution.H[t], density);
            add_to(solution.unshot[t], model_->rho[t] * (solution.H[t] - before));
        }
    }
}

}  // namespace gw::radiosity
