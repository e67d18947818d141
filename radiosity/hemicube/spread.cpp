// No fused or approximate operation, and sums in the order of the boxes: every target gives the
// same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/hemicube/spread.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/hemicube/footprints.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using I = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;

constexpr int most_cells = 3;

inline V all(double v) { return hn::Set(D(), v); }

/// Intervals, as parts of each in up to three texels, one after the other.
struct Cells {
    V first;  ///< texel
    V part[most_cells];
    V length;

    /// two: those in two texels at most, the others in three.
    Cells(V middle, V size, const FacetMap::Axis& axis, hn::Mask<D> two) {
        const V whole = all(axis.high - axis.low), cut = hn::Min(size, whole);
        const V wanted = hn::Sub(middle, hn::Mul(cut, all(0.5))),
                end = hn::Sub(all(axis.high), cut);
        const V begin = hn::Max(hn::Min(wanted, end), all(axis.low));  // not below 0
        first = hn::Min(hn::Trunc(begin), all(axis.count - 1));
        part[0] = hn::Min(cut, hn::Sub(hn::Add(first, all(1)), begin));
        const V left = hn::Sub(cut, part[0]);
        part[1] = hn::IfThenElse(two, left, hn::Min(left, all(1)));
        part[2] = hn::Sub(left, part[1]);
        length = hn::Add(hn::Add(part[0], part[1]), part[2]);
    }
};

/// A vector of boxes, ready to be added.
struct Shares {
    HWY_ALIGN double value[most_cells * most_cells][HWY_LANES(double)];  ///< by rows of texels
    std::int32_t u[HWY_LANES(double)], v[HWY_LANES(double)];             ///< the first texel
    std::int32_t corner[HWY_LANES(double)];                              ///< v * width + u
    /// Boxes::texels_across, or 0 if some are not the pixmap's
    std::int32_t inside[HWY_LANES(double)];
};

inline void share(const FacetMap& map, const Boxes& boxes, std::size_t i, Shares& shares) {
    const D d;
    constexpr double least = 1e-12;  // a point is a box too
    const auto load = [&](const std::vector<double>& values) {
        return hn::LoadU(d, values.data() + i);
    };
    const V cells = hn::PromoteTo(d, hn::LoadU(I(), boxes.texels_across.data() + i));
    const auto two = hn::Eq(cells, all(2));
    const Cells u(load(boxes.u), hn::Add(load(boxes.width), all(least)), map.u, two),
        v(load(boxes.v), hn::Add(load(boxes.height), all(least)), map.v, two);
    const V density = hn::Div(load(boxes.value), hn::Mul(u.length, v.length));
    for (int y = 0; y < most_cells; ++y) {
        const V in_row = hn::Mul(density, v.part[y]);
        for (int x = 0; x < most_cells; ++x)
            hn::Store(hn::Mul(in_row, u.part[x]), d, shares.value[y * most_cells + x]);
    }
    const auto store = [](V values, std::int32_t* to) {
        hn::StoreU(hn::DemoteTo(I(), values), I(), to);
    };
    const auto fits = [&](V first, int count) { return hn::Le(hn::Add(first, cells), all(count)); };
    store(u.first, shares.u);
    store(v.first, shares.v);
    store(hn::Add(hn::Mul(v.first, all(map.u.count)), u.first), shares.corner);
    store(
        hn::IfThenElseZero(hn::And(fits(u.first, map.u.count), fits(v.first, map.v.count)), cells),
        shares.inside);
}

/// A box whose texels are all the pixmap's.
template <int cells>
inline void add_inside(const Shares& shares, std::size_t lane, std::ptrdiff_t width,
                       const TexelSums& sums) {
    const std::size_t corner = sums.first + std::size_t(shares.corner[lane]);
    double* const at = sums.factors + corner;
    const std::uint32_t* const nearest = sums.nearest ? sums.nearest + corner : nullptr;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            const std::ptrdiff_t i = y * width + x;
            (nearest ? sums.factors[nearest[i]] : at[i]) += shares.value[y * most_cells + x][lane];
        }
}

HWY_NOINLINE void add_anywhere(const Shares& shares, std::size_t lane, int cells,
                               const FacetMap& map, const TexelSums& sums) {
    const auto at = [](int texel, int count) {
        return std::size_t(texel < count ? texel : count - 1);
    };
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            const std::size_t texel =
                sums.first + at(shares.v[lane] + y, map.v.count) * std::size_t(map.u.count) +
                at(shares.u[lane] + x, map.u.count);
            sums.factors[sums.nearest ? sums.nearest[texel] : texel] +=
                shares.value[y * most_cells + x][lane];
        }
}

inline void add(const Shares& shares, std::size_t lane, int cells, const FacetMap& map,
                const TexelSums& sums) {
    if (shares.inside[lane] == 3)
        add_inside<3>(shares, lane, map.u.count, sums);
    else if (shares.inside[lane] == 2)
        add_inside<2>(shares, lane, map.u.count, sums);
    else
        add_anywhere(shares, lane, cells, map, sums);
}

/// Shares first, of some vectors: a division takes as long as many additions, and waits for none of
/// them.
void spread(const FacetMap& map, const Boxes& boxes, const TexelSums& sums) {
    constexpr std::size_t vectors = 8;
    const std::size_t lanes = hn::Lanes(D());
    Shares shares[vectors];
    for (std::size_t first = 0; first < boxes.count; first += vectors * lanes) {
        const std::size_t end = HWY_MIN(boxes.count, first + vectors * lanes);
        for (std::size_t i = first; i < end; i += lanes)
            share(map, boxes, i, shares[(i - first) / lanes]);
        for (std::size_t i = first; i < end; ++i)
            add(shares[(i - first) / lanes], (i - first) % lanes, boxes.texels_across[i], map,
                sums);
    }
}

void append(const Boxes& from, std::size_t first, std::size_t end, Boxes& to) {
    const auto copy = [&](auto d, const auto& source, auto& goal) {
        for (std::size_t i = first; i < end; i += hn::Lanes(d))
            hn::StoreU(hn::LoadU(d, source.data() + i), d, goal.data() + to.count + (i - first));
    };
    copy(D(), from.u, to.u);
    copy(D(), from.v, to.v);
    copy(D(), from.width, to.width);
    copy(D(), from.height, to.height);
    copy(D(), from.value, to.value);
    copy(I(), from.texels_across, to.texels_across);
    to.count += end - first;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace gw::radiosity {

HWY_EXPORT(spread);
HWY_EXPORT(append);

void spread(const FacetMap& map, Boxes& boxes, const TexelSums& sums) noexcept {
    HWY_DYNAMIC_DISPATCH(spread)(map, boxes, sums);
    boxes.count = 0;
}

void append(const Boxes& from, std::size_t first, std::size_t end, Boxes& to) noexcept {
    HWY_DYNAMIC_DISPATCH(append)(from, first, end, to);
}

}  // namespace gw::radiosity

#endif  // HWY_ONCE
