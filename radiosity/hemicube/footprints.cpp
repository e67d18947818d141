// No fused or approximate operation: every target gives the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/hemicube/footprints.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/hemicube/footprints.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using I = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;

inline V all(double v) { return hn::Set(D(), v); }
inline V larger(V a, V b) { return hn::Max(hn::Abs(a), hn::Abs(b)); }

void find_pixels(const std::uint32_t* row, int first, int end, std::uint32_t pixel,
                 FacetPixels& found) {
    const hn::ScalableTag<std::int32_t> d;
    const int lanes = int(hn::Lanes(d));
    const auto wanted = hn::Set(d, std::int32_t(pixel));
    std::int32_t* const x = found.x.data();
    std::size_t count = 0;
    int i = first;
    for (; i + lanes <= end; i += lanes) {
        const auto ids = hn::LoadU(d, reinterpret_cast<const std::int32_t*>(row) + i);
        const auto chosen = hn::Eq(ids, wanted);
        // CompressStore does the same, and takes a hundred cycles on Zen 4.
        hn::StoreU(hn::Compress(hn::Iota(d, i), chosen), d, x + count);
        count += hn::CountTrue(d, chosen);
    }
    for (; i < end; ++i)
        if (row[i] == pixel) x[count++] = i;
    found.count = count;
}

/// Positions of a face on the facet.
struct OnFacet {
    V u, v, over_w;

    OnFacet(const Homography& map, V x, V y) {
        const auto of = [&](int c) {
            const V part_x = hn::Mul(x, all(map.along_x[c])),
                    part_y = hn::Mul(y, all(map.along_y[c]));
            return hn::Add(all(map.at_zero[c]), hn::Add(part_x, part_y));
        };
        // A part of a pixel may reach over the plane's horizon: the texel is then far away.
        const V w = of(2), nearest = all(-1e-30);
        over_w = hn::Div(all(1), hn::IfThenElse(hn::Lt(w, nearest), w, nearest));
        u = hn::Mul(of(0), over_w);
        v = hn::Mul(of(1), over_w);
    }
};

/// The part of the pixmap that one pixel covers along x or y: the derivative of the homography.
struct Side {
    V u, v;
    Side(const OnFacet& at, const dvec3& along)
        : u(hn::Mul(hn::Sub(all(along.x), hn::Mul(at.u, all(along.z))), at.over_w)),
          v(hn::Mul(hn::Sub(all(along.y), hn::Mul(at.v, all(along.z))), at.over_w)) {}
};

/// So many that a part covers at most a texel, and the box of two such sides two.
inline V parts(V texels, double most) {
    const V more =
        hn::IfThenElse(hn::Lt(texels, all(most)), hn::Add(hn::Trunc(texels), all(1)), all(most));
    return hn::IfThenElse(hn::Le(texels, all(1)), all(1), more);
}

inline void store_int(V v, std::int32_t* to) { hn::StoreU(hn::DemoteTo(I(), v), I(), to); }

bool find_footprints(const FacetMap& map, int y, const double* deltas, FacetPixels& pixels,
                     Boxes& boxes) {
    const D d;
    const Homography& h = map.texel_from_pixel;
    const bool points = map.most_parts == 1;  // Fig. 3a
    auto longer = hn::FirstN(d, 0);
    for (std::size_t i = 0; i < pixels.count; i += hn::Lanes(d)) {
        const auto x = hn::LoadU(I(), pixels.x.data() + i);
        const OnFacet at(h, hn::Add(hn::PromoteTo(d, x), all(0.5)), all(y + 0.5));
        const Side a(at, h.along_x), b(at, h.along_y);
        const V long_a = larger(a.u, a.v), long_b = larger(b.u, b.v);
        const V nx = parts(long_a, map.most_parts), ny = parts(long_b, map.most_parts);
        const auto small = hn::Le(points ? hn::Zero(d) : hn::Max(long_a, long_b), all(0.5));
        const auto among = hn::FirstN(d, pixels.count - i);
        longer = hn::Or(longer, hn::And(among, hn::Not(small)));
        // division by 1 is none
        const bool whole = hn::AllTrue(d, hn::Eq(hn::Max(nx, ny), all(1)));
        const auto box = [&](V along_x, V along_y) {
            if (points) return hn::Zero(d);
            if (!whole) along_x = hn::Div(along_x, nx), along_y = hn::Div(along_y, ny);
            return hn::Add(hn::Abs(along_x), hn::Abs(along_y));
        };
        hn::StoreU(at.u, d, boxes.u.data() + i);
        hn::StoreU(at.v, d, boxes.v.data() + i);
        hn::StoreU(box(a.u, b.u), d, boxes.width.data() + i);
        hn::StoreU(box(a.v, b.v), d, boxes.height.data() + i);
        store_int(hn::IfThenElse(small, all(2), all(3)), boxes.texels_across.data() + i);
        store_int(nx, pixels.nx.data() + i);
        store_int(ny, pixels.ny.data() + i);
    }
    for (std::size_t i = 0; i < pixels.count; ++i) boxes.value[i] = deltas[pixels.x[i]];
    boxes.count = pixels.count;
    return !hn::AllFalse(d, longer);
}

void find_parts(const FacetMap& map, Parts& parts) {
    const D d;
    const auto holds = [](const FacetMap::Axis& axis, V at) {
        return hn::And(hn::Ge(at, all(axis.low)), hn::Le(at, all(axis.high)));
    };
    for (std::size_t i = 0; i < parts.count; i += hn::Lanes(d)) {
        const OnFacet at(map.texel_from_pixel, hn::LoadU(d, parts.x.data() + i),
                         hn::LoadU(d, parts.y.data() + i));
        const auto inside = hn::And(holds(map.u, at.u), holds(map.v, at.v));
        hn::StoreU(at.u, d, parts.u.data() + i);
        hn::StoreU(at.v, d, parts.v.data() + i);
        store_int(hn::IfThenElseZero(inside, all(1)), parts.inside.data() + i);
    }
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace gw::radiosity {

HWY_EXPORT(find_pixels);
HWY_EXPORT(find_footprints);
HWY_EXPORT(find_parts);

void FacetPixels::reserve(std::size_t row) {
    if (row + longest_vector <= x.size()) return;
    for (auto* values : {&x, &nx, &ny}) values->resize(row + longest_vector);
}

void Parts::reserve(std::size_t more) {
    const std::size_t size = count + more + longest_vector;
    if (size <= x.size()) return;
    for (auto* values : {&x, &y, &u, &v}) values->resize(2 * size);
    inside.resize(2 * size);
}

void find_pixels(const std::uint32_t* row, int first, int end, std::uint32_t pixel,
                 FacetPixels& found) noexcept {
    HWY_DYNAMIC_DISPATCH(find_pixels)(row, first, end, pixel, found);
}

bool find_footprints(const FacetMap& map, int y, const double* deltas, FacetPixels& pixels,
                     Boxes& boxes) noexcept {
    return HWY_DYNAMIC_DISPATCH(find_footprints)(map, y, deltas, pixels, boxes);
}

void find_parts(const FacetMap& map, Parts& parts) noexcept {
    HWY_DYNAMIC_DISPATCH(find_parts)(map, parts);
}

}  // namespace gw::radiosity

#endif  // HWY_ONCE
