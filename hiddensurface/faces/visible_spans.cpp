#include "hiddensurface/faces/visible_spans.h"

#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/structures/merge_sort.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

/// A triangle between its first and last row: its three edges, walked down [L7].
struct Active {
    std::size_t order = 0;  ///< in which the machine would draw it
    std::size_t polygon = 0, triangle = 0;
    const DepthPlane* depth = nullptr;
    std::vector<EdgeWalk> edges;
};

/// The pixels of a row between two edges of a triangle.
struct Segment {
    int x0 = 0, x1 = 0;
    const Active* of = nullptr;
};

bool in_order(const Segment* a, const Segment* b) { return a->of->order < b->of->order; }

class ScanLine {
public:
    ScanLine(const Input& input, Counts& counts, StepLog& log)
        : input_(input), counts_(counts), log_(log), rows_(std::size_t(input.view.height)) {
        std::size_t order = 0;
        for (std::size_t p = 0; p < input.polygons.size(); ++p)
            for (std::size_t t = 0; t < input.polygons[p].triangles.size(); ++t)
                begin(p, t, order++);
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
    /// The edge table: triangles by their top row.
    void begin(std::size_t polygon, std::size_t triangle, std::size_t order) {
        const WindowTriangle& t = input_.polygons[polygon].triangles[triangle];
        Active a{order, polygon, triangle, &t.depth, {}};
        int top = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const GridPoint &p = t.corners[i], &q = t.corners[(i + 1) % 3];
            if (p.y == q.y) continue;
            const EdgeWalk edge(p, q, input_.subpixel_bits(), input_.view.height - 1);
            if (edge.done()) continue;
            a.edges.push_back(edge);
            top = std::max(top, edge.row());
        }
        if (top >= 0) rows_[std::size_t(top)].push_back(std::move(a));
    }

    /// The segments of row y; every edge takes one step down.
    std::vector<Segment> cut(int y) {
        std::erase_if(active_, [](const Active& a) {
            return std::all_of(a.edges.begin(), a.edges.end(),
                               [](const EdgeWalk& e) { return e.done(); });
        });
        std::vector<Segment> segments;
        for (Active& a : active_) {
            std::vector<int> x;
            for (EdgeWalk& edge : a.edges)
                if (edge.row() == y && !edge.done()) {
                    x.push_back(edge.x());
                    edge.down();
                }
            if (x.size() < 2) continue;
            const int x0 = std::max(std::min(x[0], x[1]), 0);
            const int x1 = std::min(std::max(x[0], x[1]), input_.view.width);
            if (x0 < x1) segments.push_back({x0, x1, &a});
        }
        counts_.peak_bytes = std::max<std::uint64_t>(
            counts_.peak_bytes, active_.size() * (sizeof(Active) + 3 * sizeof(EdgeWalk)) +
                                    segments.size() * (sizeof(Segment) + 2 * sizeof(int)));
        return segments;
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
        std::vector<DepthWalk> walks;
        for (const Segment* s : over) walks.emplace_back(*s->of->depth, run.x0, run.y);
        const Segment* first = nearest(over, walks);
        const bool whole = std::all_of(over.begin(), over.end(), [&](const Segment* other) {
            return other == first || stays_before(run, *first, *other);
        });
        if (log_.wants(Level::Span)) log_span(run, over, *first, whole);
        if (whole) return add(run, *first, line);
        for (int x = run.x0; x < run.x1; ++x) {
            add({run.y, x, x + 1}, *nearest(over, walks), line);
            for (DepthWalk& walk : walks) walk.right();
        }
    }

    /// `walks`: the depths of the segments at one pixel.
    const Segment* nearest(const std::vector<const Segment*>& over,
                           const std::vector<DepthWalk>& walks) {
        const Segment* best = over.front();
        std::int64_t z_best = walks.front().z();
        for (std::size_t i = 1; i < over.size(); ++i) {
            const std::int64_t z = walks[i].z();
            counts_.depths += 1;
            if (z < z_best || (z == z_best && in_order(over[i], best))) {
                best = over[i];
                z_best = z;
            }
        }
        return best;
    }

    bool stays_before(const Run& run, const Segment& a, const Segment& b) {
        const int128 margin = in_order(&a, &b) ? 0 : 65536;
        for (const int x : {run.x0, run.x1 - 1}) {
            counts_.depths += 1;
            const int128 za = a.of->depth->value(x, run.y), zb = b.of->depth->value(x, run.y);
            const int128 top = (int128{a.of->depth->largest} + 1) * 65536;
            if (zb - za < margin || za < 0 || zb < 0 || za >= top || zb >= top) return false;
        }
        return true;
    }

    static void add(const Run& run, const Segment& s, std::vector<VisibleSpan>& line) {
        VisibleSpan span{run, s.of->polygon, s.of->triangle};
        if (!line.empty() && line.back().run.x1 == run.x0 && line.back().polygon == span.polygon &&
            line.back().triangle == span.triangle) {
            line.back().run.x1 = run.x1;
        } else {
            line.push_back(span);
        }
    }

    std::string name(const Active& a) const { return name_of(input_.polygons[a.polygon]); }

    /// The polygons by their top rows, the highest first.
    void log_edge_table() {
        Step step{.level = Level::Line,
                  .action = Action::Decide,
                  .test = "edge-table",
                  .result = "filled"};
        std::vector<std::int64_t> rows;
        for (std::size_t y = rows_.size(); y-- > 0;)
            for (const Active& a : rows_[y]) {
                step.pieces.push_back(name(a));
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
            step.pieces.push_back(name(*s.of));
            x0.push_back(s.x0);
            x1.push_back(s.x1);
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
            step.pieces.push_back(name(*s->of));
            left.push_back(s->of->depth->at(run.x0, run.y));
            right.push_back(s->of->depth->at(run.x1 - 1, run.y));
        }
        step.values = {{"nearest", name(*nearest.of)}, {"z_left", left}, {"z_right", right}};
        log_.add(std::move(step));
    }

    const Input& input_;
    Counts& counts_;
    StepLog& log_;
    std::vector<std::vector<Active>> rows_;
    std::vector<Active> active_;
};

}  // namespace

void for_visible_spans(const Input& input, Counts& counts, StepLog& log, const SpanSink& sink) {
    ScanLine(input, counts, log).run(sink);
}

}  // namespace gw::hiddensurface
