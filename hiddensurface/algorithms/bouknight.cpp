// Bouknight's scan-line algorithm. W. J. Bouknight: A Procedure for Generation of Three-Dimensional
// Half-Toned Computer Graphics Presentations, CACM 13(9), 1970. The edges that cross the line are
// sorted in x: exchanges of neighbours mend the order of the line above. From left to right an edge
// switches its face on or off. Between two edges, the nearest of the faces switched on is found at
// both ends. If it is one face, that face is seen. If there are two, they pierce each other: the
// implied edge is found, and the span divided there.
//
// Does not claim: to use the line above for anything but the order. Every edge, hidden or not, ends
// a span, and every face switched on is compared in every span. So work grows with faces times depth
// complexity.
//
// Ours: pixels instead of points of the line; the implied edge by halving.
#include "hiddensurface/faces/active_faces.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

struct Crossing {
    const ActiveFace* of = nullptr;
    bool begins = false;
    int x() const { return begins ? of->x0 : std::max(of->x0, of->x1); }
};

class Bouknight {
public:
    Bouknight(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Bouknight")},
          faces_(faces_of(input)),
          active_(faces_, input) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        for (int y = input_.view.height - 1; y >= 0; --y) {
            active_.next_line();
            update_crossings();
            line(y);
            output_.counts.peak_bytes = std::max<std::uint64_t>(
                output_.counts.peak_bytes, active_.bytes() + crossings_.size() * sizeof(Crossing));
            draw_line(input_, y, std::move(painted_), output_, log_);
            painted_ = {};
        }
        return std::move(output_);
    }

private:
    void update_crossings() {
        std::erase_if(crossings_, [](const Crossing& c) { return c.of->done; });
        for (const ActiveFace* begun : active_.begun())
            for (const bool begins : {true, false}) crossings_.push_back({begun, begins});
        sort_again(crossings_, 2 * active_.begun().size(), output_.counts,
                   [](const Crossing& a, const Crossing& b) { return a.x() < b.x(); });
    }

    void line(int y) {
        on_.clear();
        if (log_.wants(Level::Line) && !crossings_.empty()) log_edges(y);
        for (std::size_t i = 0; i < crossings_.size(); ++i) {
            const Crossing& c = crossings_[i];
            if (!c.begins)
                std::erase(on_, c.of->face);
            else if (c.of->x0 < c.of->x1)
                on_.push_back(c.of->face);
            const int x = c.x(), next = i + 1 < crossings_.size() ? crossings_[i + 1].x() : x;
            if (x < next && !on_.empty()) span({y, x, next});
        }
    }

    void span(const Run& run) {
        output_.counts.spans += 1;
        const Face *left = nearest(run.x0, run.y), *right = nearest(run.x1 - 1, run.y);
        if (log_.wants(Level::Span)) log_span(run, *left, *right);
        if (left == right) return add_run(painted_, run, input_.polygons[left->polygon].id);
        const int x = implied_edge(run, *left, *right);
        if (log_.wants(Level::Span))
            log_.add({.level = Level::Span,
                      .action = Action::Decide,
                      .test = "implied-edge",
                      .result = "found",
                      .pieces = {left->name, right->name},
                      .values = {{"x", std::int64_t(x)}},
                      .decisive = true,
                      .window = pixels_of(run)});
        span({run.y, run.x0, x});
        span({run.y, x, run.x1});
    }

    const Face* nearest(int x, int y) {
        const Face* best = on_.front();
        for (const Face* face : on_) {
            if (face == best) continue;
            output_.counts.depths += 1;
            if (is_nearer(*face, *best, x, y)) best = face;
        }
        return best;
    }

    /// `left` is nearer at the run's first pixel, `right` at its last. Returns the first pixel at
    /// which `right` is.
    int implied_edge(const Run& run, const Face& left, const Face& right) {
        return first_nearer(right, left, run, output_.counts.depths);
    }

    void log_edges(int y) {
        Step step{.level = Level::Line,
                  .test = "active-edges",
                  .result = "sorted",
                  .window = line_of(input_, y)};
        std::vector<std::int64_t> x;
        for (const Crossing& c : crossings_) {
            step.pieces.push_back(c.of->face->name);
            x.push_back(c.x());
        }
        step.values = {{"x", x}};
        log_.add(std::move(step));
    }

    void log_span(const Run& run, const Face& left, const Face& right) {
        Step step{.level = Level::Span,
                  .test = "span",
                  .result = &left != &right   ? "pierce"
                            : on_.size() == 1 ? "one"
                                              : "one-nearest",
                  .decisive = on_.size() > 1,
                  .window = pixels_of(run)};
        std::vector<double> z_left, z_right;
        for (const Face* face : on_) {
            step.pieces.push_back(face->name);
            z_left.push_back(depth_at(*face, run.x0, run.y));
            z_right.push_back(depth_at(*face, run.x1 - 1, run.y));
        }
        step.values = {{"nearest", left.name}, {"z_left", z_left}, {"z_right", z_right}};
        if (&left != &right) step.values.emplace_back("nearest_right", right.name);
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Face> faces_;
    ActiveFaces active_;
    std::vector<Crossing> crossings_;  ///< sorted in x, kept from line to line
    std::vector<const Face*> on_;
    std::vector<Painted> painted_;
};

}  // namespace

Algorithm bouknight() {
    return {.name = "bouknight",
            .title = "Bouknight's scan line: edges switch faces on and off (1970)",
            .claim = Claim::Always,
            .run = [](const Input& input, StepLog& log) { return Bouknight(input, log).run(); }};
}

}  // namespace gw::hiddensurface
