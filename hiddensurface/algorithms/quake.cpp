// Sorted spans, as in Quake. M. Abrash: Graphics Programming Black Book, 1997, chapters 66 and 67,
// after J. Carmack. The BSP tree gives every surface a key: its place near to far. The edges of all
// surfaces are in one table, by their first lines. Those that cross the line are sorted in x:
// exchanges of neighbours mend the order of the line above. From left to right a leading edge puts
// its surface on a stack sorted by key, and a trailing edge takes it off. When the top changes, a
// span of the old top ends. No pixel is drawn twice, and no depth is ever compared.
//
// Does not claim: an order without the tree. So the tree cuts surfaces that pierce each other, and
// surfaces that the snap turns over keep the scene's order.
//
// Left out: edges shared by two surfaces, keys by 1/z for moving models. The stack is a sorted
// list, so work grows with the surfaces open at once.
//
// Ours: both ends of a surface on every line are computed ahead, since cuts lie between pixels.
#include "hiddensurface/faces/active_faces.h"
#include "hiddensurface/faces/world_piece.h"

#include <algorithm>
#include <numeric>

namespace gw::hiddensurface {
namespace {

/// A surface's pixels x0 .. x1 - 1 on consecutive lines down from the first.
struct Surface {
    std::size_t key = 0;  ///< smaller is nearer
    std::string name;
    std::uint32_t id = 0;
    int top = 0;
    std::vector<std::pair<int, int>> lines;

    std::pair<int, int> on(int y) const { return lines[std::size_t(top - y)]; }
    bool ends_above(int y) const { return top - y >= int(lines.size()); }
};

/// A surface without its name, which only a log needs.
constexpr std::size_t surface_bytes = sizeof(Surface) - sizeof(std::string);

struct Edge {
    const Surface* of = nullptr;
    bool leading = false;
    int x(int y) const { return leading ? of->on(y).first : of->on(y).second; }
};

/// The surfaces of one facet. A facet has one, whose runs touch each other on every line; one that
/// the snap has bent inwards has more.
std::vector<Surface> surfaces_of(std::vector<Run> runs, std::size_t key, const std::string& name,
                                 std::uint32_t id) {
    std::stable_sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
        return a.y != b.y ? a.y > b.y : a.x0 < b.x0;
    });
    std::vector<Surface> surfaces;
    for (const Run& run : runs) {
        const auto at = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& s) {
            return s.ends_above(run.y) || s.on(run.y).second == run.x0;
        });
        Surface& s =
            at != surfaces.end() ? *at : surfaces.emplace_back(Surface{key, name, id, run.y, {}});
        if (!s.ends_above(run.y)) {
            s.lines.back().second = run.x1;
            continue;
        }
        s.lines.resize(std::size_t(s.top - run.y), {0, 0});
        s.lines.emplace_back(run.x0, run.x1);
    }
    return surfaces;
}

class SortedSpans {
public:
    SortedSpans(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "sorted spans")},
          table_(std::size_t(input.view.height)) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        add_surfaces();
        for (int y = input_.view.height - 1; y >= 0; --y) {
            update_edges(y);
            line(y);
            output_.counts.spans += painted_.size();
            draw_line(input_, y, std::move(painted_), output_, log_);
            painted_ = {};
        }
        return std::move(output_);
    }

private:
    void add_surfaces() {
        std::vector<std::size_t> order(input_.polygons.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const Tree tree = build_tree(input_.polygons, order, splitters_tried,
                                     tree_log(input_, output_.counts, log_));
        output_.counts.planes = tree.plane_tests;
        output_.counts.nodes = tree.nodes.size();
        output_.counts.splits = tree.splits;
        std::size_t key = tree.pieces;
        const auto add = [&](const TreePiece& piece) { add_surface(piece, --key); };
        output_.counts.facings = far_to_near(tree, eye_of(input_.view), add, eye_log(input_, log_));
    }

    void add_surface(const TreePiece& piece, std::size_t key) {
        Piece drawn = window_piece(input_, piece);
        const Polygon& polygon = input_.polygons[drawn.polygon];
        for (Surface& s :
             surfaces_of(runs_of(drawn, polygon, input_.subpixel_bits(), input_.window()), key,
                         drawn.name, polygon.id)) {
            output_.counts.peak_bytes += surface_bytes + s.lines.size() * sizeof(s.lines[0]);
            const int top = s.top;
            table_[std::size_t(top)].push_back(std::move(s));
        }
        if (drawn.count == 0) return;
        if (log_.on())
            log_.add({.action = Action::Decide,
                      .test = "key",
                      .result = "given",
                      .pieces = {drawn.name},
                      .values = {{"key", std::int64_t(key)}}});
        output_.pieces.push_back(std::move(drawn));
    }

    void update_edges(int y) {
        std::erase_if(edges_, [y](const Edge& edge) { return edge.of->ends_above(y); });
        for (const Surface& begun : table_[std::size_t(y)])
            for (const bool leading : {true, false}) edges_.push_back({&begun, leading});
        sort_again(edges_, 2 * table_[std::size_t(y)].size(), output_.counts,
                   [y](const Edge& a, const Edge& b) { return a.x(y) < b.x(y); });
    }

    void line(int y) {
        stack_.clear();
        if (log_.wants(Level::Line) && !edges_.empty()) log_edges(y);
        int from = 0;  // the first pixel of the stack's top
        for (const Edge& edge : edges_) {
            const auto [x0, x1] = edge.of->on(y);
            if (x0 >= x1) continue;
            const Surface* top = stack_.empty() ? nullptr : stack_.front();
            if (edge.leading)
                put_on(edge.of);
            else
                std::erase(stack_, edge.of);
            if (!stack_.empty() && stack_.front() == top) continue;
            const int x = edge.x(y);
            if (top && from < x) add_run(painted_, {y, from, x}, top->id);
            from = x;
            if (log_.wants(Level::Span)) log_stack(x, y);
        }
    }

    void put_on(const Surface* surface) {
        auto place = stack_.begin();
        for (; place != stack_.end(); ++place) {
            output_.counts.keys += 1;
            if (surface->key < (*place)->key) break;
        }
        stack_.insert(place, surface);
    }

    void log_edges(int y) {
        Step step{.level = Level::Line,
                  .test = "active-edges",
                  .result = "sorted",
                  .window = line_of(input_, y)};
        std::vector<std::int64_t> x;
        for (const Edge& edge : edges_) {
            const auto [x0, x1] = edge.of->on(y);
            if (x0 >= x1) continue;
            step.pieces.push_back(edge.of->name);
            x.push_back(edge.x(y));
        }
        if (x.empty()) return;
        step.values = {{"x", x}};
        log_.add(std::move(step));
    }

    void log_stack(int x, int y) {
        Step step{.level = Level::Span,
                  .action = Action::Decide,
                  .test = "surface-stack",
                  .result = stack_.empty() ? "empty" : "top",
                  .decisive = true,
                  .window = {x, y, x < input_.view.width ? 1 : 0, 1}};
        std::vector<std::int64_t> keys;
        for (const Surface* surface : stack_) {
            step.pieces.push_back(surface->name);
            keys.push_back(std::int64_t(surface->key));
        }
        step.values = {{"x", std::int64_t(x)}, {"keys", keys}};
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<std::vector<Surface>> table_;  ///< by the first line
    std::vector<Edge> edges_;                  ///< sorted in x, kept from line to line
    std::vector<const Surface*> stack_;        ///< nearest first
    std::vector<Painted> painted_;
};

}  // namespace

Algorithm quake() {
    return {.name = "quake",
            .title = "Quake's sorted spans: keys from the BSP tree (1996)",
            .claim = Claim::Always,
            .in_world = true,
            .growth = {GrowthLaw::Superlinear, 10},
            .run = [](const Input& input, StepLog& log) { return SortedSpans(input, log).run(); }};
}

}  // namespace gw::hiddensurface
