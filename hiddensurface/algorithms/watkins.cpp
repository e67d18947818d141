// Watkins' scan-line algorithm. G. S. Watkins: A Real Time Visible Surface Algorithm, University of
// Utah UTEC-CSc-70-101, 1970. The line's segments are sorted by their left ends: exchanges of
// neighbours mend the order of the line above. Sample spans are guessed: they probably end at the
// same places as the visible spans of the line above. In a span, the segment nearest at its left end
// is the candidate. Each other segment is behind it, by the ranges of their depths or by depths at
// both ends; or it comes into view, and the span ends there. So only visible edges end spans, and a
// well guessed span takes one look.
//
// Does not claim: anything for pictures whose lines differ much from line to line. In the worst
// case all segments are in every span. Segments may pierce each other: a search finds the pixel.
//
// Ours: pixels. The two ends of a face are one segment, while Watkins joined edges; a guess too
// short is joined to its neighbour. Watkins halves a span that is not simple. Here the span ends at
// the pixel where another segment comes into view; halving finds it.
#include "hiddensurface/faces/active_faces.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

class Watkins {
public:
    Watkins(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Watkins")},
          faces_(faces_of(input)),
          active_(faces_, input) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        for (int y = input_.view.height - 1; y >= 0; --y) {
            active_.next_line();
            update_segments();
            line(y);
            output_.counts.peak_bytes =
                std::max<std::uint64_t>(output_.counts.peak_bytes,
                                        active_.bytes() + segments_.size() * sizeof(ActiveFace*) +
                                            ends_.size() * sizeof(int));
            keep_ends();
            draw_line(input_, y, std::move(painted_), output_, log_);
            painted_ = {};
        }
        return std::move(output_);
    }

private:
    void update_segments() {
        std::erase_if(segments_, [](const ActiveFace* segment) { return segment->done; });
        const auto& begun = active_.begun();
        segments_.insert(segments_.end(), begun.begin(), begun.end());
        sort_again(segments_, begun.size(), output_.counts,
                   [](const ActiveFace* a, const ActiveFace* b) { return a->x0 < b->x0; });
    }

    void line(int y) {
        over_.clear();
        if (log_.wants(Level::Line) && !segments_.empty()) log_segments(y);
        std::size_t next = 0, guess = 0;
        for (int x = 0; x < input_.view.width;) {
            while (guess < ends_.size() && ends_[guess] <= x) ++guess;
            const int end = guess < ends_.size() ? ends_[guess] : input_.view.width;
            std::erase_if(over_, [x](const ActiveFace* s) { return s->x1 <= x; });
            for (; next < segments_.size() && segments_[next]->x0 < end; ++next)
                if (segments_[next]->x0 < segments_[next]->x1) over_.push_back(segments_[next]);
            if (over_.empty() && next == segments_.size()) return;
            x = sample({y, x, end});
        }
    }

    /// Draws the segment that is seen at the span's left end as far as it is seen in the span.
    /// Returns the first pixel beyond.
    int sample(Run run) {
        output_.counts.spans += 1;
        const int guessed = run.x1;
        const ActiveFace* candidate = nearest_at_left(run);
        for (const ActiveFace* other : over_) {
            if (other->x0 >= run.x1 || other == candidate) continue;
            if (!candidate)
                run.x1 = other->x0;
            else
                run.x1 = comes_into_view(run, *candidate, *other);
        }
        if (log_.wants(Level::Span)) log_span(run, guessed, candidate);
        if (candidate) add_run(painted_, run, input_.polygons[candidate->face->polygon].id);
        return run.x1;
    }

    /// Shortens the span to the segment's end.
    const ActiveFace* nearest_at_left(Run& run) {
        const ActiveFace* best = nullptr;
        for (const ActiveFace* segment : over_) {
            if (segment->x0 > run.x0) continue;
            if (best) output_.counts.depths += 1;
            if (!best || is_nearer(*segment->face, *best->face, run.x0, run.y)) best = segment;
        }
        if (best) run.x1 = std::min(run.x1, best->x1);
        return best;
    }

    /// The first pixel of the span at which `other` is nearer; the span's end if there is none.
    int comes_into_view(const Run& run, const ActiveFace& candidate, const ActiveFace& other) {
        output_.counts.extents += 1;
        if (other.face->nearest > candidate.face->farthest) return run.x1;
        const Run common{run.y, std::max(run.x0, other.x0), std::min(run.x1, other.x1)};
        for (const int x : {common.x0, common.x1 - 1}) {
            output_.counts.depths += 1;
            if (!is_nearer(*other.face, *candidate.face, x, run.y)) continue;
            return x == common.x0
                       ? x
                       : first_nearer(*other.face, *candidate.face, common, output_.counts.depths);
        }
        return run.x1;
    }

    /// Remembers the ends of this line's visible spans for the next line.
    void keep_ends() {
        ends_.clear();
        for (const Painted& p : painted_) {
            if (ends_.empty() || ends_.back() < p.run.x0) ends_.push_back(p.run.x0);
            ends_.push_back(p.run.x1);
        }
    }

    void log_segments(int y) {
        Step step{.level = Level::Line,
                  .test = "active-edges",
                  .result = "segments",
                  .window = line_of(input_, y)};
        std::vector<std::int64_t> x0, x1;
        for (const ActiveFace* segment : segments_) {
            if (segment->x0 >= segment->x1) continue;
            step.pieces.push_back(segment->face->name);
            x0.push_back(segment->x0);
            x1.push_back(segment->x1 - 1);
        }
        if (step.pieces.empty()) return;
        step.values = {{"x0", x0}, {"x1", x1}};
        log_.add(std::move(step));
    }

    /// `guessed`: the end of the span by the line above.
    void log_span(const Run& run, int guessed, const ActiveFace* candidate) {
        Step step{.level = Level::Span,
                  .test = "sample-span",
                  .result = !candidate          ? "background"
                            : run.x1 == guessed ? "as-guessed"
                                                : "shorter",
                  .decisive = candidate && run.x1 != guessed,
                  .window = pixels_of(run)};
        std::vector<double> z_left, z_right;
        const auto add = [&](const ActiveFace* segment) {
            step.pieces.push_back(segment->face->name);
            z_left.push_back(depth_at(*segment->face, run.x0, run.y));
            z_right.push_back(depth_at(*segment->face, run.x1 - 1, run.y));
        };
        if (candidate) add(candidate);
        for (const ActiveFace* other : over_)
            if (other != candidate) add(other);
        step.values = {{"guessed", std::int64_t(guessed)},
                       {"end", std::int64_t(run.x1)},
                       {"z_left", z_left},
                       {"z_right", z_right}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Face> faces_;
    ActiveFaces active_;
    /// sorted by their left ends, kept from line to line
    std::vector<const ActiveFace*> segments_;
    std::vector<const ActiveFace*> over_;  ///< those in the span
    std::vector<int> ends_;                ///< of the visible spans of the line above
    std::vector<Painted> painted_;
};

}  // namespace

Algorithm watkins() {
    return {.name = "watkins",
            .title = "Watkins' scan line: spans guessed from the line above (1970)",
            .claim = Claim::Always,
            .run = [](const Input& input, StepLog& log) { return Watkins(input, log).run(); }};
}

}  // namespace gw::hiddensurface
