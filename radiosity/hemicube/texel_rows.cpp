// No fused or approximate operation, and each texel by itself: every target gives the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/hemicube/texel_rows.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/hemicube/texel_rows.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
// Seven digits are enough: float32 works on twice as many texels.
using D = hn::ScalableTag<float>;
using I = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;

inline V all(double v) { return hn::Set(D(), static_cast<float>(v)); }
inline V madd(V a, V b, V c) { return hn::Add(hn::Mul(a, b), c); }

/// Positions on the figure, from the point.
struct Positions {
    V x, y, z;

    Positions(const FigureView& view, V u, V v)
        : x(of(view, 0, u, v)), y(of(view, 1, u, v)), z(of(view, 2, u, v)) {}

    static V of(const FigureView& view, int c, V u, V v) {
        return hn::Add(all(view.origin[c]),
                       hn::Add(hn::Mul(u, all(view.du[c])), hn::Mul(v, all(view.dv[c]))));
    }
    V distance2() const { return madd(x, x, madd(y, y, hn::Mul(z, z))); }
    V height() const { return hn::Max(z, hn::Zero(D())); }
};

/// The integrand of a form factor but for FigureView::flux.
inline V integrand(const Positions& p) {
    const V r2 = p.distance2();
    return hn::Div(p.height(), hn::Mul(r2, r2));
}

/// Which pixels of SeenIds positions fall on.
struct InFaces {
    V along;  ///< distance_in_face
    hn::Mask<D> top;
    V column, row;     ///< at distance 1
    hn::Vec<I> first;  ///< the face's first pixel

    InFaces(const Positions& p, int size)
        : along(all(0)),
          top(hn::FirstN(D(), 0)),
          column(all(0)),
          row(all(0)),
          first(hn::Zero(I())) {
        const V ax = hn::Abs(p.x), ay = hn::Abs(p.y), side = hn::Max(ax, ay);
        top = hn::Ge(p.z, side);
        along = hn::Max(p.z, side);
        const auto by_x = hn::Ge(ax, ay);
        const V zero = hn::Zero(D());
        const auto x_low = hn::Lt(p.x, zero), y_low = hn::Lt(p.y, zero);
        const V on_x = hn::IfThenElse(x_low, hn::Neg(p.y), p.y),
                on_y = hn::IfThenElse(y_low, p.x, hn::Neg(p.x));
        column = hn::IfThenElse(top, p.x, hn::IfThenElse(by_x, on_x, on_y));
        row = hn::IfThenElse(top, p.y, p.z);
        const auto face = [&](int number) {
            return hn::Set(I(), number == 0 ? 0 : size * size + (number - 1) * (size * size / 2));
        };
        const auto of = [](hn::Mask<D> mask) { return hn::RebindMask(I(), mask); };
        first = hn::IfThenElse(of(top), face(0),
                               hn::IfThenElse(of(by_x), hn::IfThenElse(of(x_low), face(1), face(2)),
                                              hn::IfThenElse(of(y_low), face(3), face(4))));
    }
};

/// Pixels' columns and rows, with fractions.
struct Places {
    V x, y, last_row;
    hn::Vec<I> first;
    int size;

    /// over: half the size by `along`
    Places(const InFaces& in, V over, int pixels)
        : x(madd(in.column, over, all(pixels * 0.5))),
          y(madd(in.row, over, hn::IfThenElseZero(in.top, all(pixels * 0.5)))),
          last_row(hn::IfThenElse(in.top, all(pixels - 1), all(pixels / 2 - 1))),
          first(in.first),
          size(pixels) {}

    /// The values of SeenIds in these columns and rows, or the nearest of the face.
    hn::Vec<I> look(const SeenIds& seen, V column, V row) const {
        const V zero = hn::Zero(D()), c = hn::Min(hn::Max(column, zero), all(size - 1)),
                r = hn::Min(hn::Max(row, zero), last_row);
        const auto in_face =
            hn::Add(hn::Mul(hn::ConvertTo(I(), r), hn::Set(I(), size)), hn::ConvertTo(I(), c));
        return hn::GatherIndex(I(), reinterpret_cast<const std::int32_t*>(seen.pixels.data()),
                               hn::Add(first, in_face));
    }
};

inline hn::Mask<D> is_id(hn::Vec<I> pixels, std::uint32_t id) {
    return hn::RebindMask(D(), hn::Eq(hn::And(pixels, hn::Set(I(), std::int32_t(id_bits))),
                                      hn::Set(I(), std::int32_t(id))));
}
inline V alone_of(hn::Vec<I> pixels) { return hn::ConvertTo(D(), hn::ShiftRight<24>(pixels)); }

void find_corners(const FigureView& view, const TexelRow& row, float* corners) {
    const D d;
    for (int i = 0; i <= row.count; i += int(hn::Lanes(d)))
        hn::StoreU(integrand(Positions(view, hn::Iota(d, float(row.first + i)), all(row.v))), d,
                   corners + i);
}

/// What is the same for all texels of a figure.
struct Figure {
    const FigureView& view;
    double half;   ///< a texel reaches so far from its middle, along an axis of a face ...
    double above;  ///< ... and so high
    double near2;

    explicit Figure(const FigureView& v) : view(v), half(0), above(0), near2(0) {
        for (int c = 0; c < 3; ++c)
            half = HWY_MAX(half, 0.5 * (std::abs(v.du[c]) + std::abs(v.dv[c])));
        above = 0.5 * (std::abs(v.du.z) + std::abs(v.dv.z));
        const double longest = HWY_MAX(dot3(v.du, v.du), dot3(v.dv, v.dv));
        near2 = near_sides * near_sides * longest;
    }

    /// Whether a border of the figure may run among pixels about the texels.
    hn::Mask<D> beside_border(V u, double v, V along, int size) const {
        const double reach = reach_of_border(size);
        auto beside = hn::FirstN(D(), 0);
        for (std::size_t k = 0; k < view.side_count; ++k) {
            const dvec3& side = view.sides[k];
            const double least =
                side.x + v * side.z - 0.5 * (std::abs(side.y) + std::abs(side.z)) - reach * half;
            const V distance = madd(u, all(side.y), all(least));
            beside = hn::Or(beside, hn::Lt(distance, hn::Mul(along, all(reach))));
        }
        return beside;
    }
};

/// The number of the first of sample_counts that is not below the texel's pixels.
inline V count_number(V pixels) {
    V number = hn::Zero(D());
    for (std::size_t i = 0; i + 1 < sample_counts.size(); ++i)
        number = hn::Add(
            number,
            hn::IfThenElseZero(hn::Gt(pixels, all(pixels_per_sample * sample_counts[i])), all(1)));
    return number;
}

void find_row(const TexelSight& sight, const TexelRow& row, const float* low, const float* high,
              float* factors, TexelKind* kinds) {
    const D d;
    const FigureView& view = sight.view;
    const Figure figure(view);
    const int size = sight.seen.size;
    const double middle_v = row.v + 0.5, half_size = size * 0.5;
    for (int first = 0; first < row.count; first += int(hn::Lanes(d))) {
        const V u = hn::Add(hn::Iota(d, float(row.first + first)), all(0.5));
        const Positions p(view, u, all(middle_v));
        const V r2 = p.distance2();
        const auto load = [&](const float* corner) { return hn::LoadU(d, corner + first); };
        const V corners =
            hn::Add(hn::Add(load(low), load(low + 1)), hn::Add(load(high), load(high + 1)));
        const InFaces in(p, size);
        const V r4 = hn::Mul(r2, r2), over = hn::Div(all(1), hn::Mul(in.along, r4));
        const V middle = hn::Mul(p.height(), hn::Mul(over, in.along));
        // exact for cubic integrands
        const V whole =
            hn::Mul(all(view.flux / 3), madd(middle, all(2), hn::Mul(corners, all(0.25))));
        const V by_along = hn::Mul(over, r4);
        const Places places(in, hn::Mul(by_along, all(half_size)), size);
        const auto pixel = places.look(sight.seen, places.x, places.y);
        const auto is_shown = is_id(pixel, sight.id);
        const auto alone = hn::Ge(hn::Mul(alone_of(pixel), hn::Sub(in.along, all(figure.half))),
                                  all(size * figure.half));
        const auto below = hn::Le(hn::Add(p.z, all(figure.above)), hn::Zero(d));
        const auto dark = hn::Or(below, hn::AndNot(is_shown, alone));
        hn::StoreU(hn::IfThenZeroElse(dark, whole), d, factors + first);
        const auto is_near = hn::Lt(r2, all(figure.near2));
        if (hn::AllTrue(d, hn::Or(dark, hn::AndNot(is_near, alone)))) {
            hn::StoreU(hn::Zero(I()), I(), kinds + first);
            continue;
        }

        const V pixels = hn::Mul(hn::Mul(by_along, hn::Mul(by_along, by_along)),
                                 all(view.depth * half_size * half_size));
        const V border =
            hn::IfThenElseZero(figure.beside_border(u, middle_v, in.along, size), all(at_border));
        V kind = hn::Add(hn::Add(count_number(pixels), all(1)), border);
        kind = hn::IfThenZeroElse(alone, kind);
        kind = hn::IfThenElse(
            hn::Or(is_near, hn::AndNot(alone, hn::Gt(pixels, all(pixels_per_sample *
                                                                 sample_counts.back())))),
            all(near_point), kind);
        hn::StoreU(hn::ConvertTo(I(), hn::IfThenZeroElse(dark, kind)), I(), kinds + first);
    }
}

/// The light of samples, and what of it is shown.
struct Light {
    V all, shown;
};

struct Sampler {
    const TexelSight& sight;
    bool border;

    void add(V u, V v, bool is_inside, Light& light) const {
        const SeenIds& seen = sight.seen;
        const Positions p(sight.view, u, v);
        const V r2 = p.distance2(), r4 = hn::Mul(r2, r2);
        const InFaces in(p, seen.size);
        const V over = hn::Div(HWY_NAMESPACE::all(1), hn::Mul(in.along, r4));
        V value = hn::Mul(p.height(), hn::Mul(over, in.along));
        const Places places(in, hn::Mul(hn::Mul(over, r4), HWY_NAMESPACE::all(seen.size * 0.5)),
                            seen.size);
        auto shown = is_id(places.look(seen, places.x, places.y), sight.id);
        if (border) {
            const V inward = distance_from_border(u, v);
            if (!is_inside) value = hn::IfThenElseZero(hn::Ge(inward, hn::Zero(D())), value);
            const auto beside =
                hn::Lt(inward, hn::Mul(in.along, HWY_NAMESPACE::all(reach_of_border(seen.size))));
            const auto open = hn::AndNot(shown, beside);
            if (!hn::AllFalse(D(), open))
                shown = hn::Or(shown, hn::And(open, is_shown_near(places)));
        }
        light.all = hn::Add(light.all, value);
        light.shown = hn::Add(light.shown, hn::IfThenElseZero(shown, value));
    }

    V distance_from_border(V u, V v) const {
        const auto from = [&](const dvec3& side) {
            return hn::Add(HWY_NAMESPACE::all(side.x),
                           hn::Add(hn::Mul(u, HWY_NAMESPACE::all(side.y)),
                                   hn::Mul(v, HWY_NAMESPACE::all(side.z))));
        };
        V least = from(sight.view.sides[0]);
        for (std::size_t k = 1; k < sight.view.side_count; ++k)
            least = hn::Min(least, from(sight.view.sides[k]));
        return least;
    }

    /// Of the four pixels whose middles surround a position.
    hn::Mask<D> is_shown_near(const Places& places) const {
        const V half = HWY_NAMESPACE::all(0.5), one = HWY_NAMESPACE::all(1);
        const V x = hn::Add(places.x, half), y = hn::Add(places.y, half), left = hn::Sub(x, one),
                low = hn::Sub(y, one);
        const auto at = [&](V column, V row) {
            return is_id(places.look(sight.seen, column, row), sight.id);
        };
        return hn::Or(hn::Or(at(left, low), at(x, low)), hn::Or(at(left, y), at(x, y)));
    }
};

void find_shares(const TexelSight& sight, TexelKind kind, TexelList& list) {
    const D d;
    const bool border = kind > at_border;
    const auto number = std::size_t(kind - 1 - (border ? at_border : 0));
    const std::span<const Sample> samples = samples_of(number);
    const Sampler sampler{sight, border};
    for (std::size_t i = 0; i < list.count; i += hn::Lanes(d)) {
        const auto load = [&](const std::vector<float>& from) {
            return hn::LoadU(d, from.data() + i);
        };
        const V u = load(list.u), v = load(list.v);
        Light light{hn::Zero(d), hn::Zero(d)};
        if (border) sampler.add(load(list.inside_u), load(list.inside_v), true, light);
        for (const Sample& sample : samples)
            sampler.add(hn::Add(u, hn::Set(d, sample.u)), hn::Add(v, hn::Set(d, sample.v)), false,
                        light);
        const auto lit = hn::Gt(light.all, hn::Zero(d));
        hn::StoreU(
            hn::IfThenElseZero(lit, hn::Div(light.shown, hn::IfThenElse(lit, light.all, all(1)))),
            d, list.shares.data() + i);
    }
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(find_corners);
HWY_EXPORT(find_row);
HWY_EXPORT(find_shares);

void find_corners(const FigureView& view, const TexelRow& row, float* corners) noexcept {
    HWY_DYNAMIC_DISPATCH(find_corners)(view, row, corners);
}

void find_row(const TexelSight& sight, const TexelRow& row, const float* low, const float* high,
              float* factors, TexelKind* kinds) noexcept {
    HWY_DYNAMIC_DISPATCH(find_row)(sight, row, low, high, factors, kinds);
}

void TexelList::add(const dvec2& middle, const dvec2& inside, std::size_t number) {
    constexpr std::size_t vector = 64;
    if (count + vector > u.size()) {
        for (auto* values : {&u, &v, &inside_u, &inside_v, &shares})
            values->resize(2 * count + 2 * vector);
        texel.resize(2 * count + 2 * vector);
    }
    u[count] = static_cast<float>(middle.x);
    v[count] = static_cast<float>(middle.y);
    inside_u[count] = static_cast<float>(inside.x);
    inside_v[count] = static_cast<float>(inside.y);
    texel[count++] = static_cast<std::uint32_t>(number);
}

void find_shares(const TexelSight& sight, TexelKind kind, TexelList& list) noexcept {
    HWY_DYNAMIC_DISPATCH(find_shares)(sight, kind, list);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
