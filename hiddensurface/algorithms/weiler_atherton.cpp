// Weiler and Atherton's algorithm. K. Weiler, P. Atherton: Hidden Surface Removal Using Polygon
// Area Sorting, SIGGRAPH 1977. In the window, after perspective: the polygon with the nearest
// corner is the clip polygon, and all others are clipped by its whole outline, though parts of it
// may be hidden already.
//
// Parts inside the outline and behind it are hidden. If parts of the inside lie before it, the
// inside is sorted out in the same way first, with one of those as the clip polygon. A polygon that
// was the clip polygon on the way there is not taken again, so that cyclic overlap ends. Then the
// outside is next. The result is polygons of any outline, with holes; each pixel is drawn once.
// Polygons that pierce are cut along the line in which their planes meet.
//
// Does not claim: to be fast. Every clip polygon is compared with all remaining polygons, which is
// quadratic in the visible ones. (For 76,460 polygons of scenes/fig9.toml in 320 x 240: 983 million
// boxes, 435 thousand polygons clipped.) The paper sorts the scene into a coarse raster first; that
// is left out. Clip polygons are convex here: faces.
#include "hiddensurface/faces/region.h"
#include "hiddensurface/structures/merge_sort.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace gw::hiddensurface {
namespace {

struct Fragment {
    std::size_t face = 0;
    std::string name;
    Region region;
    dvec2 low{0}, high{0};  ///< of its corners
};
using FragmentList = std::vector<Fragment*>;
/// A fragment without its name, which only a log needs.
constexpr std::size_t fragment_bytes = sizeof(Fragment) - sizeof(std::string);

class WeilerAtherton {
public:
    WeilerAtherton(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Weiler, Atherton")},
          faces_(faces_of(input)),
          on_the_way_(faces_.size()) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        FragmentList all;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            outlines_.push_back(lines_.add_contour(faces_[i].corners));
            all.push_back(make(i, faces_[i].name, {outlines_[i]}));
        }
        output_.counts.sorts = 1;
        merge_sort(all.begin(), all.end(), [this](const Fragment* a, const Fragment* b) {
            output_.counts.keys += 1;
            return faces_[a->face].nearest < faces_[b->face].nearest;
        });
        log_order(all);
        sort_out(std::move(all));
        output_.counts.peak_bytes =
            fragments_.size() * fragment_bytes + sides_ * sizeof(std::size_t);
        return std::move(output_);
    }

private:
    Fragment* make(std::size_t face, std::string name, Region region) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Fragment fragment{face, std::move(name), std::move(region), dvec2(infinity),
                          dvec2(-infinity)};
        for (const Contour& contour : fragment.region) {
            sides_ += contour.size();
            for (const dvec2& p : lines_.corners(contour))
                for (int axis = 0; axis < 2; ++axis) {
                    fragment.low[axis] = std::min(fragment.low[axis], p[axis]);
                    fragment.high[axis] = std::max(fragment.high[axis], p[axis]);
                }
        }
        fragments_.push_back(std::move(fragment));
        return &fragments_.back();
    }

    /// Fragments that are all inside the clip polygons on the way here, nearest first; `clip` is the
    /// last of these.
    struct Nested {
        FragmentList list;
        std::size_t clip = no_clip;
    };
    static constexpr std::size_t no_clip = std::size_t(-1);

    /// A fragment that was clipped by a face never meets it again, because all fragments of the list
    /// are inside then. Levels are a list, since there may be as many as faces.
    void sort_out(FragmentList all) {
        std::vector<Nested> levels;
        levels.push_back({std::move(all)});
        while (!levels.empty()) {
            const std::size_t clip = next_clip(levels.back().list);
            if (clip == no_clip) {
                leave(levels.back());
                levels.pop_back();
                continue;
            }
            FragmentList inside, outside;
            for (Fragment* fragment : levels.back().list) sort_in(*fragment, clip, inside, outside);
            levels.back().list = std::move(outside);
            on_the_way_[clip] = true;
            levels.push_back({std::move(inside), clip});
        }
    }

    /// The nearest face that is not a clip polygon already.
    std::size_t next_clip(const FragmentList& list) const {
        const auto nearest = std::find_if(
            list.begin(), list.end(), [this](const Fragment* f) { return !on_the_way_[f->face]; });
        return nearest == list.end() ? no_clip : (*nearest)->face;
    }

    /// No two of these overlap: if two did, the one behind was removed.
    void leave(const Nested& level) {
        for (const Fragment* fragment : level.list) show(*fragment);
        if (level.clip != no_clip) on_the_way_[level.clip] = false;
    }

    void sort_in(Fragment& fragment, std::size_t clip, FragmentList& inside,
                 FragmentList& outside) {
        if (fragment.face == clip) return inside.push_back(&fragment);
        if (misses(fragment, clip)) return outside.push_back(&fragment);
        output_.counts.overlaps += 1;
        auto [in, out] = lines_.clip(fragment.region, outlines_[clip]);
        if (in.empty()) return outside.push_back(&fragment);
        std::string name = fragment.name;
        if (!out.empty()) {
            log_cut(fragment, clip, in, out);
            outside.push_back(make(fragment.face, fragment.name + "b", std::move(out)));
            name += "a";
        }
        if (Region seen = before(fragment.face, name, std::move(in), clip); !seen.empty())
            inside.push_back(make(fragment.face, name, std::move(seen)));
    }

    /// True if their boxes, or a side between them, keep the two apart.
    bool misses(const Fragment& f, std::size_t clip) {
        const Rect& b = faces_[clip].bounds;
        const double one = double(1 << input_.subpixel_bits());
        output_.counts.extents += 1;
        if (f.low.x >= (b.x + b.width) * one || f.high.x <= b.x * one ||
            f.low.y >= (b.y + b.height) * one || f.high.y <= b.y * one)
            return true;
        return lines_.separates(outlines_[clip], f.region);
    }

    /// The part of a face's region that lies before the clip polygon's plane, and its name. If the
    /// two planes are one, the scene's first face is before.
    Region before(std::size_t face, std::string& name, Region region, std::size_t clip) {
        output_.counts.planes += 1;
        const dvec3 apart = farther(face) - farther(clip);
        double low = 0, high = 0;
        for (const Contour& contour : region)
            for (const dvec2& p : lines_.corners(contour)) {
                const double d = apart.x * p.x + apart.y * p.y + apart.z;
                const double rounding = 0x1p-44 * (std::abs(apart.x * p.x) +
                                                   std::abs(apart.y * p.y) + std::abs(apart.z) + 1);
                if (d < -rounding) low = std::min(low, d);
                if (d > rounding) high = std::max(high, d);
            }
        const bool is_before = low < 0 ? high == 0 : high == 0 && face < clip;
        const bool pierces = low < 0 && high > 0;
        if (log_.on())
            log_.add({.test = "inside",
                      .result = pierces     ? "pierces"
                                : is_before ? "before"
                                            : "hidden",
                      .pieces = {name, faces_[clip].name},
                      .values = {{"nearest", low}, {"farthest", high}},
                      .decisive = true});
        if (!pierces) return is_before ? std::move(region) : Region();
        output_.counts.splits += 1;
        Region seen = lines_.clip(region, lines_.add_half_plane(where_nearer(apart))).first;
        name += "a";
        if (log_.on())
            log_.add({.action = Action::Split,
                      .test = "split",
                      .result = "pierced",
                      .pieces = {name.substr(0, name.size() - 1), faces_[clip].name},
                      .decisive = true,
                      .made = {{name, loops_of(seen, face)}}});
        return seen;
    }

    /// z = x X + y Y + z on the grid.
    dvec3 farther(std::size_t face) const {
        const ExactPlane& p = faces_[face].plane;
        const double one = double(1 << input_.subpixel_bits()), n = double(p.n);
        const double x = double(p.x) / n / one, y = double(p.y) / n / one;
        return {x, y, double(p.c) / n - 0.5 * one * (x + y)};
    }

    /// The line of apart < 0 in integers; its error is below 2^-10 of a grid unit in a window.
    static LineEquation where_nearer(const dvec3& apart) {
        const double scale = 0x1p28 / std::max(std::abs(apart.x), std::abs(apart.y));
        const auto integer = [scale](double v) {
            return -static_cast<std::int64_t>(std::round(v * scale));
        };
        return {integer(apart.x), integer(apart.y), integer(apart.z)};
    }

    void show(const Fragment& fragment) {
        const Polygon& polygon = input_.polygons[faces_[fragment.face].polygon];
        std::vector<Painted> painted;
        for (const Run& run : lines_.runs(fragment.region, input_.subpixel_bits(), input_.window()))
            painted.push_back({run, polygon.id});
        output_.counts.spans += painted.size();
        output_.counts.nodes += 1;
        add_painted(output_.list, painted);
        output_.pieces.push_back({.polygon = faces_[fragment.face].polygon,
                                  .name = fragment.name,
                                  .parts = loops_of(fragment.region, fragment.face)});
        if (log_.on())
            log_.add({.action = Action::Draw,
                      .test = "draw",
                      .result = "unhidden",
                      .pieces = {fragment.name},
                      .values = {{"pixels", size_of(painted)}},
                      .painted = std::move(painted)});
    }

    /// The region with the depths of its face's plane.
    std::vector<Loop> loops_of(const Region& region, std::size_t face) const {
        const dvec3 plane = farther(face);
        std::vector<Loop> loops;
        for (const Contour& contour : region) {
            loops.emplace_back();
            for (const dvec2& p : lines_.corners(contour))
                loops.back().emplace_back(p.x, p.y, plane.x * p.x + plane.y * p.y + plane.z);
        }
        return loops;
    }

    void log_cut(const Fragment& fragment, std::size_t clip, const Region& in, const Region& out) {
        output_.counts.splits += 1;
        if (!log_.on()) return;
        log_.add({.action = Action::Split,
                  .test = "split",
                  .result = "outline",
                  .pieces = {fragment.name, faces_[clip].name},
                  .decisive = true,
                  .made = {{fragment.name + "a", loops_of(in, fragment.face)},
                           {fragment.name + "b", loops_of(out, fragment.face)}}});
    }

    /// The list is near to far; the step is far to near, as all orders.
    void log_order(const FragmentList& all) {
        if (!log_.on()) return;
        Step step{.action = Action::Sort, .test = "nearest-corner", .result = "sorted"};
        std::vector<std::int64_t> z;
        for (std::size_t i = all.size(); i-- > 0;) {
            step.pieces.push_back(all[i]->name);
            z.push_back(faces_[all[i]->face].nearest);
        }
        step.values = {{"z", z}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Face> faces_;
    Lines lines_;
    std::vector<Contour> outlines_;  ///< of the faces
    std::vector<bool> on_the_way_;   ///< faces that are clip polygons of an open level
    std::deque<Fragment> fragments_;
    std::uint64_t sides_ = 0;
};

}  // namespace

Algorithm weiler_atherton() {
    return {
        .name = "weiler-atherton",
        .title = "Weiler and Atherton: polygons clipped by polygons (1977)",
        .claim = Claim::Always,
        .growth = {GrowthLaw::Superlinear, 20},
        .run = [](const Input& input, StepLog& log) { return WeilerAtherton(input, log).run(); }};
}

}  // namespace gw::hiddensurface
