// Hierarchical Z. N. Greene, M. Kass, G. Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993.
// The scene's polygons are in an octree, walked near to far. The depths drawn so far are in a
// pyramid: each cell has the farthest of the four below. A polygon, or a cube with all its polygons,
// is hidden if the pyramid is nearer everywhere in its bounding rectangle. Mostly one comparison
// decides, with the smallest cell around the rectangle. The other polygons are drawn as in a
// Z-buffer.
//
// Does not claim: to gain anything if little is hidden.
//
// Left out: the list of cubes that were visible in the previous picture (temporal coherence).
//
// Ours: rectangle and nearest depth of a cube instead of its faces; polygons across a cube's middle
// planes stay in the cube.
#include "hiddensurface/interface/algorithm.h"
#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/structures/depth_pyramid.h"
#include "hiddensurface/structures/octree.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

WindowBox box_of(const Polygon& polygon, int s, const Rect& window) {
    const GridPoint& first = polygon.triangles[0].corners[0];
    GridPoint low = first, high = first;
    for (const WindowTriangle& t : polygon.triangles)
        for (const GridPoint& p : t.corners) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
        }
    const int x0 = std::max(int(low.x >> s), 0), y0 = std::max(int(low.y >> s), 0);
    const int x1 = std::min(int(high.x >> s) + 1, window.width),
              y1 = std::min(int(high.y >> s) + 1, window.height);
    return {{x0, y0, x1 - x0, y1 - y0}, low.z - 1};  // depths inside may be rounded down
}

class HierarchicalZ {
public:
    HierarchicalZ(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "hierarchical Z")},
          pyramid_(input.view.width, input.view.height,
                   (std::int64_t{1} << input.profile.depth_bits) - 1),
          first_(std::size_t(input.view.width) * std::size_t(input.view.height)) {
        log.watch(watched(output_.counts));
    }

    Output run() {
        const std::unique_ptr<Cube> root = build_octree(input_.polygons);
        if (root) draw(*root);
        output_.counts.peak_bytes = pyramid_.bytes() + first_.size() * sizeof(std::size_t) +
                                    output_.counts.nodes * sizeof(Cube);
        return std::move(output_);
    }

private:
    void draw(const Cube& cube) {
        output_.counts.nodes += 1;
        if (hidden(window_box(cube.low, cube.high, input_.view, input_.profile), {},
                   "pyramid-cube"))
            return;
        for (const std::size_t i : cube.polygons) draw(i);
        for (const std::size_t part : near_to_far(cube, eye_of(input_.view)))
            if (cube.parts[part]) draw(*cube.parts[part]);
    }

    bool hidden(const WindowBox& box, const std::vector<std::string>& names, const char* what) {
        const bool inside = box.rect.width > 0 && box.rect.height > 0;
        DepthPyramid::Answer answer{.hidden = true};
        if (inside) answer = pyramid_.ask(box.rect, box.nearest);
        output_.counts.depths += answer.read;
        output_.counts.rejected += answer.hidden ? 1 : 0;
        if (log_.on() && !inside)
            log_.add({.test = what, .result = "outside", .pieces = names, .decisive = true});
        if (log_.on() && inside) log_answer(box, names, what, answer);
        return answer.hidden;
    }

    /// The cell that decided, or the farthest of several; or the pixel that says no.
    void log_answer(const WindowBox& box, const std::vector<std::string>& names, const char* what,
                    const DepthPyramid::Answer& answer) {
        Step step{.test = what,
                  .result = !answer.hidden      ? "may-be-seen"
                            : answer.cells == 1 ? "hidden"
                                                : "hidden-by-cells",
                  .pieces = names,
                  .values = {{"nearest", box.nearest},
                             {"pyramid", answer.farthest},
                             {"level", std::int64_t(answer.level)}},
                  .decisive = answer.hidden,
                  .window = box.rect};
        if (answer.hidden) step.values.emplace_back("cells", std::int64_t(answer.cells));
        if (!answer.hidden) {
            step.values.emplace_back("x", std::int64_t(answer.x));
            step.values.emplace_back("y", std::int64_t(input_.view.height - 1 - answer.y));
        }
        log_.add(std::move(step));
    }

    void draw(std::size_t index) {
        const Polygon& polygon = input_.polygons[index];
        const int s = input_.subpixel_bits();
        if (hidden(box_of(polygon, s, input_.window()), {name_of(polygon)}, "pyramid-polygon"))
            return;
        std::vector<Painted> painted;
        for (const WindowTriangle& t : polygon.triangles)
            for (const Run& run : scan_convert(t.corners, s, input_.window()))
                draw(run, t.depth, index, painted);
        if (painted.empty()) return;
        output_.counts.spans += painted.size();
        add_painted(output_.list, painted);
        if (log_.on())
            log_.add({.action = Action::Draw,
                      .test = "draw",
                      .result = "nearer",
                      .pieces = {name_of(polygon)},
                      .values = {{"pixels", size_of(painted)}},
                      .painted = std::move(painted)});
    }

    /// Of equal depths the scene's first is seen, as if polygons came in the scene's order.
    void draw(const Run& run, const DepthPlane& depth, std::size_t index,
              std::vector<Painted>& painted) {
        DepthWalk walk(depth, run.x0, run.y);
        for (int x = run.x0; x < run.x1; ++x, walk.right()) {
            std::size_t& first = first_[input_.view.index(x, run.y)];
            const std::int64_t z = walk.z(), stored = pyramid_.at(x, run.y);
            output_.counts.depths += 1;
            if (z > stored || (z == stored && index >= first)) continue;
            first = index;
            if (z < stored) pyramid_.set(x, run.y, z);
            add_run(painted, {run.y, x, x + 1}, input_.polygons[index].id);
        }
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    DepthPyramid pyramid_;
    std::vector<std::size_t> first_;  ///< index of the polygon at each pixel; 0: none yet, or 0
};

}  // namespace

Algorithm hierarchical_z() {
    return {
        .name = "hierarchical-z",
        .title = "Hierarchical Z: octree and pyramid of depths (1993)",
        .claim = Claim::Always,
        .run = [](const Input& input, StepLog& log) { return HierarchicalZ(input, log).run(); }};
}

}  // namespace gw::hiddensurface
