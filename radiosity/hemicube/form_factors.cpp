#include "radiosity/hemicube/form_factors.h"

#include "gw/base/parallel.h"
#include "gw/error.h"
#include "radiosity/hemicube/near_texels.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::radiosity {
namespace {

constexpr std::size_t slots = 8;  ///< hemicubes at a time; does not depend on the threads

/// The near plane's distance, in parts of the size of the point's part; Gauss' points are a fifth
/// of that from its border.
constexpr double near_part = 1.0 / 64;
/// A surface at distance d is at least d / sqrt(3) deep in the face that sees it.
constexpr double near_of_nearest = 0.5;
constexpr double least_near = 1e-6;  ///< in parts of the scene's extent

static_assert(near_of_nearest * nearest_known >= near_part);

double near_plane_of(const ShootPoint& point, double extent) {
    return std::max(std::min(point.size * near_part, point.nearest * near_of_nearest),
                    extent * least_near);
}

/// SplitMix64: a well-mixed number from (seed, number).
std::uint64_t mixed(std::uint64_t v) {
    v += 0x9e3779b97f4a7c15u;
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

/// Degrees, in steps that a double holds exactly.
double turn_of(std::uint64_t seed, std::uint64_t which, std::uint64_t point) {
    return static_cast<double>(mixed(mixed(mixed(seed) ^ which) ^ point) >> 40) *
           (360.0 / (1 << 24));
}

/// A pixel as such, undivided, belongs to one texel (Fig. 3a).
bool by_texels(const ScanOptions& options) { return options.texels && options.most_parts > 1; }

std::vector<std::uint32_t> joined_texels(const PixmapModel& model, const Pixmap& pixmap) {
    std::vector<std::uint32_t> joined;
    for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t)
        if (model.nearest[t] != t && model.nearest[t] != no_texel)
            joined.push_back(static_cast<std::uint32_t>(t));
    return joined;
}

bool is_present(const IdBuffers& buffers, std::uint32_t facet) {
    return std::any_of(buffers.begin(), buffers.end(),
                       [&](const IdBuffer& buffer) { return buffer.present[facet + 1] != 0; });
}

/// None if no texels of this facet are near.
const NearTexels* texels_of(const NearPart& part, std::uint32_t facet) {
    for (const NearTexels& texels : part.texels)
        if (texels.facet == facet) return &texels;
    return nullptr;
}

}  // namespace

double Row::sum() const { return sum_of(factors) + backs + escaped; }

void check(const FormFactorOptions& options) {
    if (options.hemicube < 8 || options.hemicube > max_window_size || options.hemicube % 2 != 0)
        throw Error(fmt::format("hemicube of {} pixels; expected an even number, 8..{}",
                                options.hemicube, max_window_size));
    if (options.scan.most_parts < 1 || options.scan.most_parts > 1024)
        throw Error(fmt::format("pixels in {} parts; expected 1..1024", options.scan.most_parts));
    if (!(options.points.nearness > 0) || !(options.points.smallest_part > 0) ||
        !(options.points.smallest_of_pixmap > 0) || !(options.points.emitter_part > 0))
        throw Error("options of a patch's points that are not above 0; expected positive numbers");
}

PointOptions point_options(const FormFactorOptions& options) {
    PointOptions points = options.points;
    points.near_parts = points.near_parts && by_texels(options.scan);
    return points;
}

FormFactors::FormFactors(const PixmapModel& model, const FormFactorOptions& options)
    : model_(model), options_(options) {
    check(options);
    delta_ = delta_form_factors(options.hemicube);
    scratch_.resize(std::size_t(options.threads > 0 ? options.threads : hardware_threads()));
    if (by_texels(options.scan)) {
        figures_ = plane_figures(model);
        pieces_ = Pieces(model);
    }
    figures_.resize(model.facets.size());
    for (const Pixmap& pixmap : model.pixmaps) joined_.push_back(joined_texels(model, pixmap));
    slots_.resize(slots);
    for (auto& factors : factors_) factors.resize(model.texel_count());
}

Row FormFactors::from_patch(std::size_t patch) { return combined(from_quarters(patch)); }

std::vector<Row> FormFactors::from_quarters(std::size_t patch) {
    return from(shooting_of(model_, model_.patches[patch], point_options(options_)), patch);
}

Row FormFactors::from_points(const std::vector<ShootPoint>& points, std::uint64_t turns) {
    return from({.points = points, .near_parts = {}}, turns).front();
}

namespace {

void take(const std::vector<double>& factors, Row& row) {
    for (std::size_t t = 0; t < factors.size(); ++t) {
        if (factors[t] == 0) continue;
        row.texels.push_back(static_cast<std::uint32_t>(t));
        row.factors.push_back(factors[t]);
    }
}

std::size_t group_of(const Shooting& shooting, const ShootPoint& point) {
    return shooting.has_quarters ? std::size_t(point.quarter) : 0;
}

}  // namespace

Row FormFactors::combined(const std::vector<Row>& quarters) {
    if (quarters.size() == 1) return quarters.front();
    Row row;
    std::vector<double>& factors = factors_[0];
    std::fill(factors.begin(), factors.end(), 0.0);
    for (const Row& quarter : quarters) {
        for (std::size_t i = 0; i < quarter.texels.size(); ++i)
            factors[quarter.texels[i]] += quarter.factors[i] / 4;
        row.backs += quarter.backs / 4;
        row.escaped += quarter.escaped / 4;
        row.hemicubes += quarter.hemicubes;
    }
    take(factors, row);
    return row;
}

std::vector<Row> FormFactors::from(const Shooting& shooting, std::uint64_t turns) {
    const std::vector<ShootPoint>& points = shooting.points;
    std::vector<Row> rows(shooting.has_quarters ? 4 : 1);
    enclosed_.fill(0);
    for (std::size_t g = 0; g < rows.size(); ++g)
        std::fill(factors_[g].begin(), factors_[g].end(), 0.0);
    for (std::size_t first = 0; first < points.size(); first += slots) {
        const std::size_t count = std::min(slots, points.size() - first);
        draw(shooting, first, count, turns);
        scan(count);
        sum(shooting, first, count, rows);
    }
    std::array<double, 4> grow{};
    for (std::size_t g = 0; g < rows.size(); ++g)
        grow[g] = divide_among_open(rows[g], enclosed_[g], factors_[g]);
    if (!shooting.near_parts.empty()) add_near(shooting, grow, rows);
    for (std::size_t g = 0; g < rows.size(); ++g) take(factors_[g], rows[g]);
    return rows;
}

/// Points that see nothing but backs are inside of something that stands on the patch. No light
/// falls there, so it comes from the other points. Returns by how much their shares grow.
double FormFactors::divide_among_open(Row& row, double enclosed, std::vector<double>& factors) {
    if (enclosed == 0) return 1;
    if (enclosed > 1 - 1e-9) {
        row.backs += enclosed;
        return 1;
    }
    const double grow = 1 / (1 - enclosed);
    for (double& factor : factors) factor *= grow;
    row.escaped *= grow;
    row.backs *= grow;
    return grow;
}

// The points' hemicubes and the near texels see the same light in two ways. All of it goes
// somewhere: the other texels are scaled, as the near ones are exact.
void FormFactors::add_near(const Shooting& shooting, const std::array<double, 4>& grow,
                           std::vector<Row>& rows) {
    struct Texel {
        const NearPart* part;
        const NearTexels* texels;
        int u, v;
        std::size_t group;
        double factor = 0;
    };
    std::vector<Texel> list;
    for (const ShootPoint& point : shooting.points) {
        if (point.near_part == no_part) continue;
        const NearPart& part = shooting.near_parts[point.near_part];
        for (const NearTexels& texels : part.texels)
            for (int v = texels.first.y; v < texels.end.y; ++v)
                for (int u = texels.first.x; u < texels.end.x; ++u)
                    list.push_back({&part, &texels, u, v, group_of(shooting, point)});
    }
    const auto groups = double(rows.size());
    parallel_for(list.size(), options_.threads, [&](std::size_t i, int) {
        Texel& t = list[i];
        t.factor = grow[t.group] * groups * t.part->share *
                   near_factor(model_, *t.part, *t.texels, t.u, t.v);
    });
    double near = 0, far = 0, left = 0;
    for (const Texel& t : list) near += t.factor;
    for (std::size_t g = 0; g < rows.size(); ++g) {
        far += sum_of(factors_[g]);
        left += 1 - rows[g].escaped - rows[g].backs;
    }
    const bool only_far = far > 0 && std::abs((left - near) / far - 1) < 0.5;
    const auto scale = [&](double by) {
        for (std::size_t g = 0; g < rows.size(); ++g)
            for (double& factor : factors_[g]) factor *= by;
    };
    if (only_far) scale((left - near) / far);
    for (const Texel& t : list) {
        const Pixmap& pixmap = model_.pixmaps[model_.facets[t.texels->facet].pixmap];
        const std::uint32_t element = model_.nearest[pixmap.texel(t.u, t.v)];
        if (element != no_texel) factors_[t.group][element] += t.factor;
    }
    if (!only_far) scale(left / (near + far));
}

Hemicube FormFactors::hemicube_on(const std::vector<ShootPoint>& points, std::size_t number,
                                  std::uint64_t turns) const {
    const ShootPoint& point = points.at(number);
    const double near_plane = near_plane_of(point, model_.extent);
    return hemicube_at(point.position, point.normal, turn_of(options_.seed, turns, number),
                       near_plane, std::max(model_.extent, point.farthest) * 1.01 + near_plane,
                       options_.hemicube);
}

// [F4] (1): the ID buffers are drawn in parallel.
void FormFactors::draw(const Shooting& shooting, std::size_t first, std::size_t count,
                       std::uint64_t turns) {
    parallel_for(count, options_.threads, [&](std::size_t i, int worker) {
        if (options_.cancel && *options_.cancel) return;
        Slot& slot = slots_[i];
        slot.hemicube = hemicube_on(shooting.points, first + i, turns);
        const std::uint32_t near = shooting.points[first + i].near_part;
        slot.beside = near < shooting.near_parts.size() ? &shooting.near_parts[near] : nullptr;
        auto& painter = scratch_[std::size_t(worker)].painter;
        if (!painter)
            painter =
                options_.make_machine
                    ? std::make_unique<HemicubePainter>(options_.make_machine(options_.hemicube))
                    : std::make_unique<HemicubePainter>(options_.hemicube);
        painter->draw(model_, slot.hemicube, slot.buffers);
        slot.escaped = escaping(slot.buffers, delta_);
        if (by_texels(options_.scan)) find_seen(slot.buffers, slot.seen);
        slot.factors.resize(model_.texel_count());
        slot.sums.resize(model_.pixmaps.size());
        slot.backs.resize(model_.pixmaps.size());
        slot.left_out.resize(model_.pixmaps.size());
    });
    if (options_.cancel && *options_.cancel) throw Canceled{};
}

// [F4] (2): the pixmaps are computed in parallel.
void FormFactors::scan(std::size_t count) {
    const std::size_t pixmaps = model_.pixmaps.size();
    parallel_for(count * pixmaps, options_.threads, [&](std::size_t i, int worker) {
        scan_pixmap(slots_[i / pixmaps], static_cast<std::uint32_t>(i % pixmaps),
                    scratch_[std::size_t(worker)]);
    });
}

void FormFactors::scan_pixmap(Slot& slot, std::uint32_t number, Scratch& scratch) const {
    const Pixmap& pixmap = model_.pixmaps[number];
    slot.backs[number] = slot.sums[number] = slot.left_out[number] = 0;
    bool is_set = false;
    const auto texels = std::span(slot.factors).subspan(pixmap.first, pixmap.count());
    if (std::none_of(pixmap.facets.begin(), pixmap.facets.end(),
                     [&](std::uint32_t facet) { return is_present(slot.buffers, facet); }))
        return;
    for (const std::uint32_t facet : pixmap.facets) {
        if (pieces_.of(facet).empty() && !is_present(slot.buffers, facet)) continue;
        if (!is_set) std::fill(texels.begin(), texels.end(), 0.0);
        is_set = true;
        const NearTexels* const near = slot.beside ? texels_of(*slot.beside, facet) : nullptr;
        slot.backs[number] += near ? scan_beside(slot, *near, scratch)
                                   : scan_facet(slot, facet, slot.factors, scratch);
    }
    if (!is_set) return;
    for (const std::uint32_t t : joined_[number]) {
        slot.factors[model_.nearest[t]] += slot.factors[t];
        slot.factors[t] = 0;
    }
    slot.sums[number] = sum_of(texels);
}

/// A facet of whose texels some are left out.
double FormFactors::scan_beside(Slot& slot, const NearTexels& texels, Scratch& scratch) const {
    const std::uint32_t number = model_.facets[texels.facet].pixmap;
    const Pixmap& pixmap = model_.pixmaps[number];
    scratch.alone.resize(model_.texel_count());
    const auto alone = std::span(scratch.alone).subspan(pixmap.first, pixmap.count());
    std::fill(alone.begin(), alone.end(), 0.0);
    const double backs = scan_facet(slot, texels.facet, scratch.alone, scratch);
    double* to = &slot.factors[pixmap.first];
    const double* from = alone.data();
    for (int v = 0; v < pixmap.height; ++v)
        for (int u = 0; u < pixmap.width; ++u, ++to, ++from)
            (texels.contains(u, v) ? slot.left_out[number] : *to) += *from;
    return backs;
}

double FormFactors::scan_facet(Slot& slot, std::uint32_t facet, std::span<double> factors,
                               Scratch& scratch) const {
    const auto& figure = figures_[facet];
    const bool is_shown = is_present(slot.buffers, facet);
    if (is_shown && figure && can_scan_texels(model_, *figure, slot.hemicube) &&
        scan_texels(model_, *figure, slot.hemicube, slot.seen, factors, scratch.texels))
        return 0;
    const std::span<const Piece> pieces = pieces_.of(facet);
    if (!pieces.empty() && can_scan_pieces(model_, facet, slot.hemicube)) {
        scan_pieces(model_, facet, pieces, slot.hemicube, slot.seen, factors);
        return 0;
    }
    if (!is_shown) return 0;
    return scan_pixels(model_, facet, slot.hemicube, slot.buffers, delta_, options_.scan, factors,
                       scratch.pixels);
}

/// All light goes somewhere: so much that neither escapes nor falls on backs goes to the texels.
/// Their form factors are exact, but the buffers show borders by whole pixels.
double FormFactors::scale_of(const Slot& slot) const {
    if (!by_texels(options_.scan)) return 1;
    double left = 1 - slot.escaped, texels = 0;
    for (std::size_t i = 0; i < slot.sums.size(); ++i) {
        left -= slot.backs[i];
        texels += slot.sums[i] + slot.left_out[i];
    }
    return texels > 0 ? std::max(left, 0.0) / texels : 0;
}

// Points that see nothing but backs are not added (divide_among_open).
void FormFactors::sum(const Shooting& shooting, std::size_t first, std::size_t count,
                      std::vector<Row>& rows) {
    std::array<double, slots> shares{}, scaled{};
    std::array<std::size_t, slots> groups{};
    for (std::size_t k = 0; k < count; ++k) {
        const ShootPoint& point = shooting.points[first + k];
        groups[k] = group_of(shooting, point);
        shares[k] = point.share * double(rows.size());
        scaled[k] = shares[k] * scale_of(slots_[k]);
    }
    parallel_for(model_.pixmaps.size(), options_.threads, [&](std::size_t i, int) {
        const Pixmap& pixmap = model_.pixmaps[i];
        for (std::size_t k = 0; k < count; ++k) {
            if (slots_[k].sums[i] == 0) continue;
            const double* const from = slots_[k].factors.data();
            double* const to = factors_[groups[k]].data();
            for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t)
                to[t] += scaled[k] * from[t];
        }
    });
    for (std::size_t k = 0; k < count; ++k) {
        Row& row = rows[groups[k]];
        ++row.hemicubes;
        if (is_enclosed(slots_[k])) {
            enclosed_[groups[k]] += shares[k];
            continue;
        }
        row.escaped += shares[k] * slots_[k].escaped;
        for (double backs : slots_[k].backs) row.backs += shares[k] * backs;
    }
}

bool FormFactors::is_enclosed(const Slot& slot) {
    const auto is_dark = [](double sum) { return sum == 0; };
    return slot.escaped == 0 && std::all_of(slot.sums.begin(), slot.sums.end(), is_dark) &&
           std::all_of(slot.left_out.begin(), slot.left_out.end(), is_dark);
}

}  // namespace gw::radiosity
