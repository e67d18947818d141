#include "hiddensurface/faces/visible_spans.h"

#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/structures/merge_sort.h"

#include <algorithm>
#include <optional>

namespace gw::hiddensurface {
namespace {

/// A triangle of a facet: its three edges, walked down [L7].
struct Slice {
    std::size_t triangle = 0;
    std::size_t order = 0;  ///< in which the machine would draw it
    const DepthPlane* depth = nullptr;
    std::vector<EdgeWalk> edges;
};

/// A plane polygon, or a plane part of one, between its first and last row.
struct Active {
    std::size_t polygon = 0;
    std::string name;  ///< in step logs
    std::vector<Slice> parts;
};

/// Without its name, which only a log needs.
constexpr std::size_t active_bytes = sizeof(Active) - sizeof(std::string);

/// The pixels of a row between two edges of a triangle.
struct Stretch {
    int x0 = 0, x1 = 0;
    const Slice* part = nullptr;
};

/// The pixels of a row between two edges of a plane polygon: stretches that touch.
struct Segment {
    int x0 = 0, x1 = 0;
    const Active* of = nullptr;
    std::vector<Stretch> stretches;

    const Slice& at(int x) const {
        return *std::find_if(stretches.begin(), stretches.end(), [x](const Stretch& s) {
                    return x < s.x1;
                })->part;
    }
};

bool in_order(const Segment& a, const Segment& b, int x) { return a.at(x).order < b.at(x).order; }

/// Walks a segment's depths to the right, by increments in a stretch.
class SegmentWalk {
public:
    SegmentWalk(const Segment& segment, const Run& run)
        : segment_(&segment), x_(run.x0), y_(run.y) {
        begin();
    }
    std::int64_t z() const { return walk_->z(); }
    void right() {
        x_ += 1;
        if (x_ >= segment_->x1) return;
        if (&segment_->at(x_) == part_)
            walk_->right();
        else
            begin();
    }

private:
    void begin() {
        part_ = &segment_->at(x_);
        walk_.emplace(*part_->depth, x_, y_);
    }

    const Segment* segment_;
    const Slice* part_ = nullptr;
    int x_ = 0, y_ = 0;
    std::optional<DepthWalk> walk_;
};

class ScanLine {
public:
    ScanLine(const Input& input, Counts& counts, StepLog& log)
        : input_(input), counts_(counts), log_(log), rows_(std::size_t(input.view.height)) {
        for (std::size_t p = 0; p < input.polygons.size(); ++p) begin(p);
        if (log_.wants(Level::Line)) log_edge_table();
    }

    void run(const SpanSink& sink) {
        for (int y = input_.view.height - 1; y >= 0; --y) {
            for (Active& a : rows_[std::size_t(y)]) active_.push_back(std::move(a));
            rows_[std::size_t(y)] = {};
            const std::vector<Segment> segments = cut(y);
            if (log_.wants(Level::Line) && !segments.empty()) log_segments(y, segments);
            if (!segments.empty()) sink(spans(y, segments));
        }
    }

private:
    /// The edge table: the polygon's plane parts by their top rows.
    void begin(std::size_t index) {
        const Polygon& polygon = input_.polygons[index];
        const std::size_t facets = polygon.world_facets.size();
        for (std::size_t k = 0; k < facets; ++k) {
            const WorldFacet& facet = polygon.world_facets[k];
            Active a{.polygon = index, .name = name_of(polygon, k, facets), .parts = {}};
            int top = -1;
            for (std::size_t t = 0; t < polygon.triangles.size(); ++t)
                if (polygon.triangles[t].source - facet.first < facet.count)
                    top = std::max(top, begin(a, polygon.triangles[t], t));
            if (top >= 0) rows_[std::size_t(top)].push_back(std::move(a));
        }
        order_ += polygon.triangles.size();
    }

    /// Adds a triangle's edges to a facet; returns their top row, -1 if none crosses a row.
    int begin(Active& a, const WindowTriangle& t, std::size_t index) const {
        Slice part{index, order_ + index, &t.depth, {}};
        int top = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const GridPoint &p = t.corners[i], &q = t.corners[(i + 1) % 3];
            if (p.y == q.y) continue;
            const EdgeWalk edge(p, q, input_.subpixel_bits(), input_.view.height - 1);
            if (edge.done()) continue;
            part.edges.push_back(edge);
            top = std::max(top, edge.row());
        }
        if (top >= 0) a.parts.push_back(std::move(part));
        return top;
    }

    /// The segments of row y; every edge takes one step down.
    std::vector<Segment> cut(int y) {
        const auto is_done = [](const EdgeWalk& e) { return e.done(); };
        std::erase_if(active_, [&](const Active& a) {
            return std::all_of(a.parts.begin(), a.parts.end(), [&](const Slice& part) {
                return std::all_of(part.edges.begin(), part.edges.end(), is_done);
            });
        });
        std::vector<Segment> segments;
        std::size_t stretches = 0, parts = 0;
        for (Active& a : active_) {
            const std::vector<Stretch> found = stretches_of(a, y);
            for (const Stretch& s : found) {
                const bool joins =
                    !segments.empty() && segments.back().of == &a && segments.back().x1 == s.x0;
                if (!joins) segments.push_back({s.x0, s.x1, &a, {}});
                segments.back().x1 = s.x1;
                segments.back().stretches.push_back(s);
            }
            stretches += found.size();
            parts += a.parts.size();
        }
        counts_.peak_bytes = std::max<std::uint64_t>(
            counts_.peak_bytes, active_.size() * active_bytes +
                                    parts * (sizeof(Slice) + 3 * sizeof(EdgeWalk)) +
                                    segments.size() * (sizeof(Segment) + 2 * sizeof(int)) +
                                    stretches * sizeof(Stretch));
        return segments;
    }

    /// Left to right.
    std::vector<Stretch> stretches_of(Active& a, int y) const {
        std::vector<Stretch> stretches;
        for (Slice& part : a.parts) {
            std::vector<int> x;
            for (EdgeWalk& edge : part.edges)
                if (edge.row() == y && !edge.done()) {
                    x.push_back(edge.x());
                    edge.down();
                }
            if (x.size() < 2) continue;
            const int x0 = std::max(std::min(x[0], x[1]), 0);
            const int x1 = std::min(std::max(x[0], x[1]), input_.view.width);
            if (x0 < x1) stretches.push_back({x0, x1, &part});
        }
        std::stable_sort(stretches.begin(), stretches.end(),
                         [](const Stretch& s, const Stretch& t) { return s.x0 < t.x0; });
        return stretches;
    }

    /// Sample spans lie between neighbouring ends.
    std::vector<VisibleSpan> spans(int y, const std::vector<Segment>& segments) {
        std::vector<int> ends;
        for (const Segment& s : segments) ends.insert(ends.end(), {s.x0, s.x1});
        counts_.sorts += 1;
        merge_sort(ends.begin(), ends.end(), [this](int a, int b) {
            counts_.crossings += 1;
            return a < b;
        });
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        std::vector<const Segment*> by_start;
        for (const Segment& s : segments) by_start.push_back(&s);
        std::stable_sort(by_start.begin(), by_start.end(),
                         [](const Segment* a, const Segment* b) { return a->x0 < b->x0; });
        std::vector<const Segment*> over;
        std::vector<VisibleSpan> line;
        std::size_t next = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            std::erase_if(over, [&](const Segment* s) { return s->x1 <= ends[i]; });
            while (next < by_start.size() && by_start[next]->x0 <= ends[i])
                over.push_back(by_start[next++]);
            if (!over.empty()) resolve({y, ends[i], ends[i + 1]}, over, line);
        }
        return line;
    }

    /// A segment that is nearest at both ends by more than rounding, or tied only with later ones, is
    /// nearest in between, because depths are linear. Otherwise segments cross here, and z is
    /// compared at every pixel, by increments.
    void resolve(const Run& run, const std::vector<const Segment*>& over,
                 std::vector<VisibleSpan>& line) {
        counts_.spans += 1;
        std::vector<SegmentWalk> walks;
        for (const Segment* s : over) walks.emplace_back(*s, run);
        const Segment* first = nearest(over, walks, run.x0);
        const bool whole = std::all_of(over.begin(), over.end(), [&](const Segment* other) {
            return other == first || stays_before(run, *first, *other);
        });
        if (log_.wants(Level::Span)) log_span(run, over, *first, whole);
        if (whole) return add(run, *first, line);
        for (int x = run.x0; x < run.x1; ++x) {
            add({run.y, x, x + 1}, *nearest(over, walks, x), line);
            for (SegmentWalk& walk : walks) walk.right();
        }
    }

    /// `walks`: the depths of the segments at pixel x.
    const Segment* nearest(const std::vector<const Segment*>& over,
                           const std::vector<SegmentWalk>& walks, int x) {
        const Segment* best = over.front();
        std::int64_t z_best = walks.front().z();
        for (std::size_t i = 1; i < over.size(); ++i) {
            const std::int64_t z = walks[i].z();
            counts_.depths += 1;
            if (z < z_best || (z == z_best && in_order(*over[i], *best, x))) {
                best = over[i];
                z_best = z;
            }
        }
        return best;
    }

    /// Compares at the ends of the run and of stretches in it: the snap may bend a polygon there.
    bool stays_before(const Run& run, const Segment& a, const Segment& b) {
        for (int x0 = run.x0, x1 = 0; x0 < run.x1; x0 = x1) {
            x1 = std::min({run.x1, end_of_stretch(a, x0), end_of_stretch(b, x0)});
            if (!is_before_at(x0, run.y, a, b) || !is_before_at(x1 - 1, run.y, a, b)) return false;
        }
        return true;
    }

    static int end_of_stretch(const Segment& s, int x) {
        return std::find_if(s.stretches.begin(), s.stretches.end(),
                            [x](const Stretch& stretch) { return x < stretch.x1; })
            ->x1;
    }

    bool is_before_at(int x, int y, const Segment& a, const Segment& b) {
        counts_.depths += 1;
        const DepthPlane& plane = *a.at(x).depth;
        const int128 margin = in_order(a, b, x) ? 0 : 65536;
        const int128 za = plane.value(x, y), zb = b.at(x).depth->value(x, y);
        const int128 top = (int128{plane.largest} + 1) * 65536;
        return zb - za >= margin && za >= 0 && zb >= 0 && za < top && zb < top;
    }

    static void add(const Run& run, const Segment& s, std::vector<VisibleSpan>& line) {
        for (int x0 = run.x0, x1 = 0; x0 < run.x1; x0 = x1) {
            x1 = std::min(run.x1, end_of_stretch(s, x0));
            add({{run.y, x0, x1}, s.of->polygon, s.at(x0).triangle}, line);
        }
    }

    static void add(const VisibleSpan& span, std::vector<VisibleSpan>& line) {
        if (!line.empty() && line.back().run.x1 == span.run.x0 &&
            line.back().polygon == span.polygon && line.back().triangle == span.triangle) {
            line.back().run.x1 = span.run.x1;
        } else {
            line.push_back(span);
        }
    }

    /// The polygons by their top rows, the highest first.
    void log_edge_table() {
        Step step{.level = Level::Line,
                  .action = Action::Decide,
                  .test = "edge-table",
                  .result = "filled"};
        std::vector<std::int64_t> rows;
        for (std::size_t y = rows_.size(); y-- > 0;)
            for (const Active& a : rows_[y]) {
                step.pieces.push_back(a.name);
                rows.push_back(std::int64_t(rows_.size() - 1 - y));
            }
        step.values = {{"rows", rows}};
        log_.add(std::move(step));
    }

    void log_segments(int y, const std::vector<Segment>& segments) {
        Step step{.level = Level::Line,
                  .test = "active-edges",
                  .result = "segments",
                  .window = line_of(input_, y)};
        std::vector<std::int64_t> x0, x1;
        for (const Segment& s : segments) {
            step.pieces.push_back(s.of->name);
            x0.push_back(s.x0);
            x1.push_back(s.x1 - 1);
        }
        step.values = {{"x0", x0}, {"x1", x1}};
        log_.add(std::move(step));
    }

    /// `whole`: `nearest` is so in the whole span.
    void log_span(const Run& run, const std::vector<const Segment*>& over, const Segment& nearest,
                  bool whole) {
        Step step{.level = Level::Span,
                  .test = "span",
                  .result = !whole             ? "they-cross"
                            : over.size() == 1 ? "one"
                                               : "one-nearest",
                  .decisive = over.size() > 1,
                  .window = pixels_of(run)};
        std::vector<std::int64_t> left, right;
        for (const Segment* s : over) {
            step.pieces.push_back(s->of->name);
            left.push_back(s->at(run.x0).depth->at(run.x0, run.y));
            right.push_back(s->at(run.x1 - 1).depth->at(run.x1 - 1, run.y));
        }
        step.values = {{"nearest", nearest.of->name}, {"z_left", left}, {"z_right", right}};
        log_.add(std::move(step));
    }

    const Input& input_;
    Counts& counts_;
    StepLog& log_;
    std::vector<std::vector<Active>> rows_;
    std::vector<Active> active_;
    std::size_t order_ = 0;  ///< triangles before those of the polygon
};

}  // namespace

void for_visible_spans(const Input& input, Counts& counts, StepLog& log, const SpanSink& sink) {
    ScanLine(input, counts, log).run(sink);
}

}  // namespace gw::hiddensurface
