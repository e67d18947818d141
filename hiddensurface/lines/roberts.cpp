// Roberts' algorithm: L. G. Roberts, "Machine perception of three-dimensional solids", MIT Lincoln
// Laboratory TR 315, 1963. The first hidden-line algorithm: in object space, every line is compared
// with every body.
//
// A convex body is the points with u.V >= 0 for all columns of its volume matrix V: its planes.
// Lines between two faces that look away are dropped. A point s + t d of a line is hidden if some
// point s + t d + alpha g on its way to the eye (g, alpha > 0) is inside a body. Roberts finds the
// least and greatest t among the corners of the region of (t, alpha) in which all columns agree.
// Here alpha is eliminated first. One inequality in t is left for each face that looks at the eye
// (the point is behind it) and for each side of the contour (the point is inside it). A point is
// hidden if all hold, so a body hides at most one part of a line.
//
// Claims: right for any polygons. Roberts has convex solids and figures put together from them.
// Here, all polygons but those of closed convex solids beyond the near plane are taken piece by
// piece: each plane convex piece is a body without thickness. Solids may pierce each other: the
// hidden parts are right, but the lines in which they pierce are not drawn (Petty and Mach added
// them in 1977).
// Decides in the world, before the snap.
#include "hiddensurface/lines/bodies.h"
#include "hiddensurface/lines/world_lines.h"
#include "hiddensurface/model/normal.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

/// The part of p -> q that lies on the positive side of all the body's planes by more than the
/// tolerance.
std::optional<Part> hidden_by(const Body& body, const WorldSide& line, double tolerance,
                              LineCounts& counts) {
    Part part{0, 1};
    for (const dvec4& plane : body.planes) {
        counts.planes += 1;
        const double a = side(plane, line.p) - tolerance, b = side(plane, line.q) - tolerance;
        if (a <= 0 && b <= 0) return std::nullopt;
        if (a < 0) part.first = std::max(part.first, a / (a - b));
        if (b < 0) part.second = std::min(part.second, a / (a - b));
        if (part.first >= part.second) return std::nullopt;
    }
    return part;
}

std::vector<Part> visible_parts(const Bodies& scene, const WorldSide& line, LineCounts& counts) {
    if (line.back) return {};
    counts.starts += 1;
    std::vector<Part> hidden;
    for (const Body& body : scene.bodies) {
        // a solid's front lines are before it
        if (body.solid != 0 && body.solid == line.solid) continue;
        if (const auto part = hidden_by(body, line, scene.tolerance, counts))
            hidden.push_back(*part);
    }
    return rest_of(std::move(hidden));
}

LineOutput run(const Input& input, StepLog& log) {
    LineOutput output;
    const Bodies scene = bodies_of(input, output.counts);
    const WorldLines window(input);
    output.counts.faces = scene.bodies.size();
    for (const Body& body : scene.bodies)
        output.counts.peak_bytes += sizeof(Body) + body.planes.size() * sizeof(dvec4);
    output.counts.peak_bytes += scene.sides.size() * sizeof(WorldSide);
    for (const WorldSide& side : scene.sides) {
        const auto line =
            window.to_window(side.id, side.p, side.q, visible_parts(scene, side, output.counts));
        if (!line) continue;
        output.counts.lines += 1;
        output.counts.parts += line->visible.size();
        log_line(*line, log);
        output.lines.push_back(*line);
    }
    return output;
}

}  // namespace

LineAlgorithm roberts() {
    return {
        .name = "roberts",
        .title = "Roberts 1963: every line against every convex body",
        .claim =
            "right for any polygons, best for convex solids; does not draw the lines in which solids go "
            "through each other",
        .growth = {GrowthLaw::Superlinear, 3},
        .run = run};
}

}  // namespace gw::hiddensurface
