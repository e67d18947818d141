#include "hiddensurface/faces/region.h"

#include "hiddensurface/model/floor_div.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gw::hiddensurface {
namespace {

std::size_t before(const Contour& contour, std::size_t k) {
    return contour[k == 0 ? contour.size() - 1 : k - 1];
}
std::size_t after(const Contour& contour, std::size_t k) {
    return contour[k + 1 == contour.size() ? 0 : k + 1];
}

}  // namespace

std::size_t Lines::add(const LineEquation& line) {
    lines_.push_back(line);
    return lines_.size() - 1;
}

Contour Lines::add_contour(const std::vector<GridPoint>& p) {
    Contour contour;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const GridPoint &from = p[i], &to = p[(i + 1) % p.size()];
        const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
        contour.push_back(add({-dy, dx, dy * from.x - dx * from.y}));
    }
    return contour;
}

Contour Lines::add_half_plane(const LineEquation& line) {
    constexpr std::int64_t far = std::int64_t{1} << 53;
    const LineEquation second{-line.a - 2 * line.b, -line.b + 2 * line.a, far};
    const LineEquation third{-line.a + 2 * line.b, -line.b - 2 * line.a, far};
    return {add(line), add(second), add(third)};
}

std::int64_t Lines::cross(std::size_t i, std::size_t j) const {
    return lines_[i].a * lines_[j].b - lines_[j].a * lines_[i].b;
}

int128 Lines::determinant(std::size_t i, std::size_t j, std::size_t k) const {
    return int128{lines_[i].c} * cross(j, k) + int128{lines_[j].c} * cross(k, i) +
           int128{lines_[k].c} * cross(i, j);
}

int Lines::side(std::size_t i, std::size_t j, std::size_t k) const {
    if (k == i || k == j) return 0;
    const int w = sign(cross(i, j));
    if (const int128 d = determinant(i, j, k); d != 0) return sign(d) * w;
    // The line of the smallest index is moved most. Its c has a cross product as its factor in the
    // determinant.
    std::array<std::pair<std::size_t, std::int64_t>, 3> moved{
        {{i, cross(j, k)}, {j, cross(k, i)}, {k, cross(i, j)}}};
    std::sort(moved.begin(), moved.end());
    for (const auto& [line, factor] : moved)
        if (factor != 0) return sign(factor) * w;
    return 0;
}

dvec2 Lines::corner(std::size_t i, std::size_t j) const {
    const LineEquation &p = lines_[i], &q = lines_[j];
    const auto w = double(cross(i, j));
    return {double(int128{p.b} * q.c - int128{q.b} * p.c) / w,
            double(int128{p.c} * q.a - int128{q.c} * p.a) / w};
}

std::vector<dvec2> Lines::corners(const Contour& contour) const {
    std::vector<dvec2> points;
    for (std::size_t k = 0; k < contour.size(); ++k)
        points.push_back(corner(contour[k], after(contour, k)));
    return points;
}

bool Lines::separates(const Contour& clip, const Region& region) const {
    return std::any_of(clip.begin(), clip.end(), [&](std::size_t line) {
        for (const Contour& contour : region)
            for (std::size_t k = 0; k < contour.size(); ++k) {
                const std::size_t i = contour[k], j = after(contour, k);
                if (sign(determinant(i, j, line)) * sign(cross(i, j)) > 0) return false;
            }
        return true;
    });
}

bool Lines::is_flat(const Contour& contour) const {
    return std::any_of(contour.begin(), contour.end(), [&](std::size_t line) {
        for (std::size_t k = 0; k < contour.size(); ++k)
            if (determinant(contour[k], after(contour, k), line) != 0) return false;
        return true;
    });
}

/// Counts crossings from the corner along line j, to the side of i > 0.
bool Lines::is_inside(std::size_t i, std::size_t j, const Region& region) const {
    bool inside = false;
    for (const Contour& contour : region)
        for (std::size_t k = 0; k < contour.size(); ++k) {
            const std::size_t line = contour[k];
            const bool crosses =
                side(before(contour, k), line, j) != side(line, after(contour, k), j);
            if (crosses && side(line, j, i) > 0) inside = !inside;
        }
    return inside;
}

/// Weiler and Atherton's tracing. The contours' crossings are in order along both. The inside follows
/// the region from where it enters the clip polygon, and the clip polygon forwards from where the
/// region leaves. The outside does the reverse, with the clip polygon backwards.
class Clipper {
public:
    Clipper(const Lines& lines, const Region& region, const Contour& clip)
        : lines_(lines), region_(region), clip_(clip), on_clip_(clip.size()) {
        for (const Contour& contour : region_) on_region_.emplace_back(contour.size());
        for (std::size_t u = 0; u < region_.size(); ++u)
            for (std::size_t k = 0; k < region_[u].size(); ++k)
                for (std::size_t j = 0; j < clip_.size(); ++j) meet(u, k, j);
        for (std::size_t u = 0; u < region_.size(); ++u)
            for (std::size_t k = 0; k < region_[u].size(); ++k)
                order(on_region_[u][k], region_[u], k,
                      [this](const Crossing& c) { return clip_[c.clip_side]; });
        for (std::size_t j = 0; j < clip_.size(); ++j)
            order(on_clip_[j], clip_, j,
                  [this](const Crossing& c) { return region_[c.contour][c.side]; });
    }

    std::pair<Region, Region> run() {
        std::pair<Region, Region> parts;
        add_uncrossed(parts);
        for (const bool entering : {true, false})
            for (std::size_t c = 0; c < crossings_.size(); ++c)
                if (crossings_[c].entering == entering && !crossings_[c].traced)
                    add(trace(c), entering ? parts.first : parts.second);
        return parts;
    }

private:
    struct Crossing {
        std::size_t contour = 0, side = 0, clip_side = 0;
        bool entering = false, traced = false;
    };
    using OnSides = std::vector<std::vector<std::size_t>>;  ///< crossings of every side, in order

    void meet(std::size_t u, std::size_t k, std::size_t j) {
        const std::size_t s = region_[u][k], c = clip_[j];
        const int from = lines_.side(before(region_[u], k), s, c),
                  to = lines_.side(s, after(region_[u], k), c);
        if (from == to) return;
        if (lines_.side(before(clip_, j), c, s) == lines_.side(c, after(clip_, j), s)) return;
        on_region_[u][k].push_back(crossings_.size());
        on_clip_[j].push_back(crossings_.size());
        crossings_.push_back({u, k, j, to > 0});
    }

    /// a is before b if b is on the same side of a's line as the end of the side.
    template <class Other>
    void order(std::vector<std::size_t>& list, const Contour& contour, std::size_t k,
               const Other& other) {
        const std::size_t line = contour[k];
        std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
            const std::size_t of_a = other(crossings_[a]), of_b = other(crossings_[b]);
            return of_a != of_b &&
                   lines_.side(line, of_b, of_a) == lines_.side(line, after(contour, k), of_a);
        });
    }

    void add_uncrossed(std::pair<Region, Region>& parts) const {
        for (std::size_t u = 0; u < region_.size(); ++u) {
            if (std::any_of(on_region_[u].begin(), on_region_[u].end(),
                            [](const auto& c) { return !c.empty(); }))
                continue;
            const Contour& contour = region_[u];
            const bool inside = std::all_of(clip_.begin(), clip_.end(), [&](std::size_t c) {
                return lines_.side(contour[0], contour[1], c) > 0;
            });
            add(contour, inside ? parts.first : parts.second);
        }
        if (!crossings_.empty() || !lines_.is_inside(clip_[0], clip_[1], region_)) return;
        add(clip_, parts.first);
        add(Contour(clip_.rbegin(), clip_.rend()), parts.second);
    }

    Contour trace(std::size_t first) {
        Contour contour;
        std::size_t at = first;
        do {
            crossings_[at].traced = true;
            const bool inside = crossings_[at].entering;
            at = follow_region(at, contour);
            at = follow_clip(at, inside, contour);
        } while (at != first && contour.size() < limit());
        return contour;
    }

    std::size_t follow_region(std::size_t from, Contour& contour) const {
        const Crossing& c = crossings_[from];
        const OnSides& sides = on_region_[c.contour];
        std::size_t k = c.side;
        contour.push_back(region_[c.contour][k]);
        auto next = std::find(sides[k].begin(), sides[k].end(), from) + 1;
        while (next == sides[k].end()) {
            k = (k + 1) % sides.size();
            contour.push_back(region_[c.contour][k]);
            next = sides[k].begin();
        }
        return *next;
    }

    std::size_t follow_clip(std::size_t from, bool forwards, Contour& contour) const {
        const std::size_t n = clip_.size();
        std::size_t j = crossings_[from].clip_side;
        contour.push_back(clip_[j]);
        auto at = std::find(on_clip_[j].begin(), on_clip_[j].end(), from);
        if (forwards ? at + 1 != on_clip_[j].end() : at != on_clip_[j].begin())
            return forwards ? at[1] : at[-1];
        do {
            j = forwards ? (j + 1) % n : (j + n - 1) % n;
            contour.push_back(clip_[j]);
        } while (on_clip_[j].empty());
        return forwards ? on_clip_[j].front() : on_clip_[j].back();
    }

    void add(Contour contour, Region& region) const {
        if (!lines_.is_flat(contour)) region.push_back(std::move(contour));
    }

    /// An upper bound of a contour's length: all sides, each once for each crossing.
    std::size_t limit() const {
        return 4 * (crossings_.size() + 1) *
               (crossings_.size() + clip_.size() + region_.size() + 64);
    }

    const Lines& lines_;
    const Region& region_;
    const Contour& clip_;
    std::vector<Crossing> crossings_;
    std::vector<OnSides> on_region_;
    OnSides on_clip_;
};

std::pair<Region, Region> Lines::clip(const Region& region, const Contour& clip) const {
    return Clipper(*this, region, clip).run();
}

std::vector<Run> Lines::runs(const Region& region, int s, const Rect& window) const {
    struct Height {
        int128 y = 0, w = 1;  ///< y / w, w > 0
        bool is_above(std::int64_t row) const { return y >= row * w; }
    };
    const auto height = [this](std::size_t i, std::size_t j) {
        const int128 w = cross(i, j);
        const int128 y = int128{lines_[i].c} * lines_[j].a - int128{lines_[j].c} * lines_[i].a;
        return w > 0 ? Height{y, w} : Height{-y, -w};
    };
    const std::int64_t one = std::int64_t{1} << s, half = one / 2;
    std::vector<std::vector<int>> rows(std::size_t(window.height));
    for (const Contour& contour : region)
        for (std::size_t k = 0; k < contour.size(); ++k) {
            Height from = height(before(contour, k), contour[k]),
                   to = height(contour[k], after(contour, k));
            const LineEquation& l = lines_[contour[k]];
            const std::int64_t a = l.a < 0 ? -l.a : l.a, turned = l.a < 0 ? -1 : 1;
            const auto row_of = [&](const Height& h) {
                return std::clamp<int128>(floor_div(h.y, h.w * one), -1, window.height);
            };
            const int low = int(std::max<int128>(std::min(row_of(from), row_of(to)) - 1, 0));
            const int high =
                int(std::min<int128>(std::max(row_of(from), row_of(to)) + 1, window.height - 1));
            for (int row = low; row <= high; ++row) {
                const std::int64_t y = row * one + half;
                if (from.is_above(y) == to.is_above(y)) continue;
                const int128 x = -(int128{l.b} * y + l.c) * turned;  // a times x
                const int128 pixel = -floor_div(-(x - int128{a} * half), int128{a} * one);
                rows[std::size_t(row)].push_back(
                    int(std::clamp<int128>(pixel, window.x, window.x + window.width)));
            }
        }
    std::vector<Run> runs;
    for (int row = window.height - 1; row >= 0; --row) {
        std::vector<int>& ends = rows[std::size_t(row)];
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
            if (ends[i] < ends[i + 1]) runs.push_back({row, ends[i], ends[i + 1]});
    }
    return runs;
}

}  // namespace gw::hiddensurface
