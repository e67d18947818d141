// Changes of a solved scene [F4]: shoot the difference.
#include "radiosity/solver/solver.h"

#include "gw/error.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

bool same_pixmaps(const PixmapModel& a, const PixmapModel& b) {
    return std::equal(a.pixmaps.begin(), a.pixmaps.end(), b.pixmaps.begin(), b.pixmaps.end(),
                      [](const Pixmap& p, const Pixmap& q) {
                          return p.width == q.width && p.height == q.height;
                      }) &&
           a.facets.size() == b.facets.size();
}

double area_of(const PixmapModel& model, const Pixmap& pixmap) {
    double sum = 0;
    for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t) sum += model.area[t];
    return sum;
}

/// Moved, not resized; positions are float32.
bool same_areas(const PixmapModel& a, const PixmapModel& b) {
    return std::equal(a.pixmaps.begin(), a.pixmaps.end(), b.pixmaps.begin(), b.pixmaps.end(),
                      [&](const Pixmap& p, const Pixmap& q) {
                          const double area = area_of(a, p);
                          return std::abs(area - area_of(b, q)) <= 1e-4 * area;
                      });
}

bool same_place(const Facet& a, const Facet& b) {
    return a.origin == b.origin && a.du == b.du && a.dv == b.dv;
}

/// At most so much of a patch's light goes to a sphere: the form factor of a disc that hides it.
double most_to_sphere(const dvec3& from, const dvec3& center, double radius) {
    const dvec3 to = center - from;
    const double d2 = dot3(to, to);
    return d2 > radius * radius ? radius * radius / d2 : 1;
}

/// The facets that are elsewhere now, in both models.
std::vector<const Facet*> moved_facets(const PixmapModel& a, const PixmapModel& b) {
    std::vector<const Facet*> moved;
    for (std::size_t i = 0; i < a.facets.size(); ++i)
        if (!same_place(a.facets[i], b.facets[i]))
            moved.insert(moved.end(), {&a.facets[i], &b.facets[i]});
    return moved;
}

/// A difference that takes more hemicubes than this part of all is not sent: other patches shoot
/// after it, and then it would take more than a solution from the beginning.
constexpr double most_of_anew = 0.9;
/// Differences of materials that are not sent either if form factors have to be drawn: in parts of
/// the emitted light, and of the hemicubes for all light.
constexpr double most_difference = 0.5, most_of_spread = 0.8;
/// Sums of float32 pairs: a patch that never shot seems to have sent less than this part of all.
constexpr double rounding = 1e-9;

dvec3 middle(const PixmapModel& model, const Patch& patch) {
    const Facet& facet = model.facets[model.pixmaps[patch.pixmap].facets.front()];
    return facet.at({patch.x + patch.width / 2.0, patch.y + patch.height / 2.0});
}

}  // namespace

Update Solver::update(PixmapModel to, double tolerance) {
    if (!same_pixmaps(*model_, to) || !same_areas(*model_, to))
        throw Error(
            "the changed scene has other figures or pixmaps; expected the same, moved or of "
            "other materials");
    check_emission(to);
    const double left = magnitude(books(*model_, solution_).unshot_size);
    parts_.clear();
    change_materials(to);
    if (!moved_facets(*model_, to).empty()) return move(std::move(to), tolerance);
    // Form factors stay; only values that depend on materials are new.
    for (std::size_t p = 0; p < to.patches.size(); ++p) {
        if (model_->patches[p].emits != to.patches[p].emits) rows_.drop(p);
        model_->patches[p].emits = to.patches[p].emits;
    }
    if (!is_less_to_begin_again(left)) return {};
    const std::uint64_t shots = solution_.shots;
    solution_ = initial_solution(*model_);
    solution_.shots = shots;
    return {.anew = true};
}

// B = E + rho H: its change has not been sent.
void Solver::change_materials(const PixmapModel& to) {
    for (const DirectLight& light : to.direct) solution_.escaped += light.escaped;
    for (const DirectLight& light : model_->direct) solution_.escaped -= light.escaped;
    for (std::size_t t = 0; t < to.texel_count(); ++t) {
        const dvec3 before = radiosity_at(*model_, solution_, t);
        dvec3 direct(0);
        for (const DirectLight& light : to.direct) direct += light.H[t];
        for (const DirectLight& light : model_->direct) direct -= light.H[t];
        for (int c = 0; c < 3; ++c) solution_.H[t][c] = storable(solution_.H[t][c] + direct[c]);
        model_->E[t] = to.E[t];
        model_->rho[t] = to.rho[t];
        const dvec3 more = radiosity_at(*model_, solution_, t) - before;
        for (int c = 0; c < 3; ++c)
            solution_.unshot[t][c] = storable(solution_.unshot[t][c] + more[c]);
    }
    model_->figures = to.figures;
    model_->direct = to.direct;
}

namespace {

/// Light that a patch has to send, and the hemicubes for it.
struct ToSend {
    double flux = 0;
    std::size_t hemicubes = 0;
};

/// Largest first, until the rest is `least`.
std::size_t hemicubes_until(std::vector<ToSend> list, double least) {
    double left = 0;
    for (const ToSend& send : list) left += send.flux;
    std::stable_sort(list.begin(), list.end(),
                     [](const ToSend& a, const ToSend& b) { return a.flux > b.flux; });
    std::size_t sum = 0;
    for (std::size_t i = 0; i < list.size() && left > least; left -= list[i++].flux)
        sum += list[i].hemicubes;
    return sum;
}

}  // namespace

// Compares hemicubes. If most form factors are kept, the difference needs next to none. Else light
// that is sent twice counts: that of the difference, and after it that of its reflections. A
// difference that is large, or spread over as many patches as all light, saves nothing.
bool Solver::is_less_to_begin_again(double least) const {
    std::vector<ToSend> difference, all;
    std::size_t lit = 0, unknown = 0;
    for (std::size_t p = 0; p < model_->patches.size(); ++p) {
        dvec3 unshot(0), sent(0);
        for_each_texel(*model_, model_->patches[p], [&](std::size_t t) {
            unshot += model_->area[t] * solution_.unshot[t];
            sent += model_->area[t] * radiosity_at(*model_, solution_, t);
        });
        const std::size_t hemicubes = hemicubes_of(*model_, p),
                          more = rows_.find(p) ? 0 : hemicubes;
        lit += hemicubes;
        unknown += more;
        difference.push_back({magnitude(unshot), more});
        all.push_back({magnitude(sent), more});
    }
    if (2 * unknown <= lit) return false;
    const Books now = books(*model_, solution_);
    if (magnitude(now.unshot_size) - least > most_difference * magnitude(now.emitted)) return true;
    return double(hemicubes_until(difference, least)) >
           most_of_spread * double(hemicubes_until(all, least));
}

/// A patch whose light may go elsewhere after a move.
struct Solver::Affected {
    std::size_t patch;
    double most;  ///< flux, all channels, that may go elsewhere
    dvec3 flux;   ///< all flux that it has sent
};

std::vector<Solver::Affected> Solver::affected_by(const PixmapModel& to) const {
    const std::vector<const Facet*> moved = moved_facets(*model_, to);
    std::vector<Affected> affected;
    for (std::size_t p = 0; p < model_->patches.size(); ++p) {
        const Patch& patch = model_->patches[p];
        const dvec3 flux = shot_flux(patch);
        if (flux == dvec3(0)) continue;
        const bool moves = !same_place(model_->facets[model_->pixmaps[patch.pixmap].facets.front()],
                                       to.facets[to.pixmaps[patch.pixmap].facets.front()]);
        double part = moves ? 1 : 0;
        for (const Facet* facet : moved)
            part += most_to_sphere(middle(*model_, patch), facet->center, facet->radius);
        affected.push_back({p, magnitude(flux) * std::min(part, 1.0), flux});
    }
    return affected;
}

// Largest first, until the rest sends less than `least` elsewhere.
void Solver::keep_largest(std::vector<Affected>& affected, double least) {
    double left = 0;
    for (const Affected& a : affected) left += a.most;
    std::stable_sort(affected.begin(), affected.end(),
                     [](const Affected& a, const Affected& b) { return a.most > b.most; });
    std::size_t count = 0;
    while (count < affected.size() && left > least) left -= affected[count++].most;
    affected.resize(count);
}

std::size_t Solver::hemicubes_of(const PixmapModel& model, std::size_t patch) const {
    return points_of(model, model.patches[patch], point_options(options_.form_factors)).size();
}

std::size_t Solver::hemicubes_to_send(const std::vector<Affected>& affected,
                                      const PixmapModel& to) const {
    std::size_t sum = 0;
    for (const Affected& a : affected)
        sum +=
            (rows_.find(a.patch) ? 0 : hemicubes_of(*model_, a.patch)) + hemicubes_of(to, a.patch);
    return sum;
}

Update Solver::begin_again(PixmapModel to) {
    auto next = std::make_unique<PixmapModel>(std::move(to));
    auto next_factors = std::make_unique<FormFactors>(*next, options_.form_factors);
    Solution next_solution = initial_solution(*next);
    next_solution.shots = solution_.shots;
    model_ = std::move(next);
    form_factors_ = std::move(next_factors);
    solution_ = std::move(next_solution);
    rows_ = Rows();
    return {.anew = true};
}

namespace {

/// A patch's quarters have sent different light, but only its sum is known.
std::vector<dvec3> evenly(const dvec3& flux, std::size_t rows) {
    return std::vector(rows, flux / double(rows));
}

}  // namespace

// Takes a patch's light back with its old form factors and sends it with the new ones in one step:
// the books balance even if this is canceled.
void Solver::send_anew(const std::vector<Affected>& affected, FormFactors& next, Rows& kept,
                       Update& done) {
    for (const Affected& a : affected) {
        const std::vector<Row> drawn = next.from_quarters(a.patch);
        const PatchRows now = compact(drawn);
        const PatchRows& before = rows_of(a.patch, &done.hemicubes);
        add_light(before, evenly(-a.flux, before.size()), solution_);
        add_light(now, evenly(a.flux, now.size()), solution_);
        receive(solution_);
        for (const Row& row : drawn) done.hemicubes += row.hemicubes;
        ++done.patches;
        rows_.drop(a.patch);
        kept.keep(a.patch, now, options_.row_memory - std::min(options_.row_memory, rows_.bytes()));
    }
}

Update Solver::move(PixmapModel to, double tolerance) {
    const double emitted = magnitude(books(*model_, solution_).emitted);
    // Figures may stand on other patches now. Light that is taken back and sent needs the same ones.
    std::vector<Patch> patches = same_patches(to, model_->patches);
    std::swap(to.patches, patches);
    std::vector<Affected> affected = affected_by(to);
    std::size_t anew = 0;
    for (const Affected& a : affected)
        if (magnitude(a.flux) > rounding * emitted) anew += hemicubes_of(to, a.patch);
    keep_largest(affected, tolerance * emitted);
    if (double(hemicubes_to_send(affected, to)) > most_of_anew * double(anew)) {
        to.patches = std::move(patches);
        return begin_again(std::move(to));
    }
    auto next = std::make_unique<PixmapModel>(std::move(to));
    auto next_factors = std::make_unique<FormFactors>(*next, options_.form_factors);
    Rows kept;
    const auto change_over = [&] {
        model_ = std::move(next);
        form_factors_ = std::move(next_factors);
        rows_ = std::move(kept);
    };
    Update done;
    try {
        send_anew(affected, *next_factors, kept, done);
    } catch (...) {
        change_over();
        throw;
    }
    change_over();
    return done;
}

}  // namespace gw::radiosity
