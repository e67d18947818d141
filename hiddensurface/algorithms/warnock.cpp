// Warnock's area subdivision. J. E. Warnock: A Hidden Surface Algorithm for Computer Generated
// Halftone Pictures, University of Utah TR 4-15, 1969. A window in which the picture is simple is
// drawn; any other is cut into four, down to the pixel. A window is simple if it is empty, has one
// face, or has a face around all of it that is nearer than all others at its four corners. Windows
// are made of pixels' centres, so the last one, the pixel, is decided at its centre. Faces that
// pierce each other need no special case: their windows are cut to pixels.
//
// Does not claim: to find edges finer than a pixel (Warnock's line drawings went on below), or few
// windows if coplanar faces overlap or faces pierce: along those lines all windows are pixels.
// Work grows with the length of the visible edges, not with the square of the faces.
#include "hiddensurface/faces/face.h"

#include <algorithm>
#include <functional>

namespace gw::hiddensurface {
namespace {

using FaceList = std::vector<const Face*>;

class Warnock {
public:
    Warnock(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Warnock")},
          faces_(faces_of(input)) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        FaceList all;
        for (const Face& face : faces_) all.push_back(&face);
        look(input_.window(), {}, all);
        output_.counts.spans = painted_.size();
        add_painted(output_.list, painted_);
        return std::move(output_);
    }

private:
    /// Warnock's looker. `around`: faces that surround the window that this one was cut from, and so
    /// surround this one. `others`: faces that reached into that window.
    void look(const Rect& window, FaceList around, const FaceList& others) {
        output_.counts.nodes += 1;
        FaceList inside;
        for (const Face* face : others) {
            output_.counts.overlaps += 1;
            const Cover cover = cover_of(*face, window);
            if (cover == Cover::Surrounds) around.push_back(face);
            if (cover == Cover::Intersects) inside.push_back(face);
        }
        drop_hidden(window, around, inside);
        listed_ += around.size() + inside.size();
        output_.counts.peak_bytes =
            std::max<std::uint64_t>(output_.counts.peak_bytes, listed_ * sizeof(Face*));
        think(window, around, inside);
        listed_ -= around.size() + inside.size();
    }

    /// The thinker: draws, or asks for four looks. A window of one pixel is simple: a face covers its
    /// centre or not, and only the nearest is left.
    void think(const Rect& w, const FaceList& around, const FaceList& inside) {
        if (around.empty() && inside.empty()) return log(w, {}, {}, "empty");
        if (around.size() == 1 && inside.empty()) return fill(w, *around[0], "surrounded");
        if (around.empty() && inside.size() == 1) return fill(w, *inside[0], "one-face");
        log(w, around, inside, "divided");
        const int width = (w.width + 1) / 2, height = (w.height + 1) / 2;
        for (const int y : {height, 0})
            for (const int x : {0, width}) {
                const Rect quarter{w.x + x, w.y + y, x ? w.width - width : width,
                                   y ? w.height - height : height};
                if (quarter.width > 0 && quarter.height > 0) look(quarter, around, inside);
            }
    }

    /// Drops all faces behind a face that surrounds the window.
    void drop_hidden(const Rect& window, FaceList& around, FaceList& inside) {
        if (around.empty()) return;
        FaceList dropped;  // for the log
        const Face* first = around[0];
        for (const Face* face : around) {
            output_.counts.depths += 1;
            if (is_nearer(*face, *first, window.x, window.y)) first = face;
        }
        const auto hidden = [&](const Face* face) {
            return face != first && is_nearer(*first, *face, window, output_.counts.depths);
        };
        for (FaceList* list : {&around, &inside}) {
            const auto seen =
                std::stable_partition(list->begin(), list->end(), std::not_fn(hidden));
            dropped.insert(dropped.end(), seen, list->end());
            list->erase(seen, list->end());
        }
        if (log_.on() && !dropped.empty()) log_hidden(window, *first, dropped);
    }

    void fill(const Rect& w, const Face& face, const char* why) {
        const std::uint32_t id = input_.polygons[face.polygon].id;
        std::vector<Painted> painted;
        for (int y = w.y + w.height - 1; y >= w.y; --y)
            if (const Run run = run_of(face, y, w.x, w.x + w.width); run.x0 < run.x1)
                painted.push_back({run, id});
        if (painted.empty()) return;
        painted_.insert(painted_.end(), painted.begin(), painted.end());
        if (!log_.on()) return;
        log_.add({.action = Action::Draw,
                  .test = "window",
                  .result = why,
                  .pieces = {face.name},
                  .values = {{"pixels", size_of(painted)}},
                  .window = w,
                  .painted = std::move(painted)});
    }

    static std::vector<std::string> names(const FaceList& faces) {
        std::vector<std::string> found;
        for (const Face* face : faces) found.push_back(face->name);
        return found;
    }

    void log(const Rect& w, const FaceList& around, const FaceList& inside, const char* result) {
        if (!log_.on()) return;
        Step step{.action = Action::Decide,
                  .test = "window",
                  .result = result,
                  .pieces = names(around),
                  .values = {{"surrounding", std::int64_t(around.size())},
                             {"inside", std::int64_t(inside.size())}},
                  .decisive = !around.empty() || !inside.empty(),
                  .window = w};
        for (const Face* face : inside) step.pieces.push_back(face->name);
        log_.add(std::move(step));
    }

    /// The depths of a face at the window's corner pixels: lower left, lower right, upper left,
    /// upper right.
    static std::vector<double> depths_at_corners(const Face& face, const Rect& w) {
        std::vector<double> z;
        for (const int y : {w.y, w.y + w.height - 1})
            for (const int x : {w.x, w.x + w.width - 1}) z.push_back(depth_at(face, x, y));
        return z;
    }

    void log_hidden(const Rect& w, const Face& nearest, const FaceList& hidden) {
        std::vector<double> z;
        for (const Face* face : hidden)
            for (const double depth : depths_at_corners(*face, w)) z.push_back(depth);
        Step step{.action = Action::Decide,
                  .test = "window",
                  .result = "hidden",
                  .pieces = {nearest.name},
                  .values = {{"hidden", names(hidden)},
                             {"z", depths_at_corners(nearest, w)},
                             {"z_hidden", z}},
                  .decisive = true,
                  .window = w};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Face> faces_;
    std::vector<Painted> painted_;
    std::size_t listed_ = 0;  ///< faces in the lists of all open windows
};

}  // namespace

Algorithm warnock() {
    return {.name = "warnock",
            .title = "Warnock's area subdivision (1969)",
            .claim = Claim::Always,
            .run = [](const Input& input, StepLog& log) { return Warnock(input, log).run(); }};
}

}  // namespace gw::hiddensurface
