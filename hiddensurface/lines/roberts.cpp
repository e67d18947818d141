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
#include "hiddensurface/interface/line_algorithm.h"
#include "hiddensurface/lines/world_lines.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/piece.h"
#include "hiddensurface/structures/bsp_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace gw::hiddensurface {
namespace {

/// A side of a polygon in the world.
struct WorldSide {
    dvec3 p, q;
    std::uint32_t id = 0;
    std::size_t solid = 0;  ///< 1 + the number of its solid; 0: none
    bool back = false;      ///< both faces of the solid look away
};

/// Hides all points on the positive side of all its planes. `planes`: those of faces that look at
/// the eye (behind them), and those through the eye and the contour (inside it); normals of length
/// 1.
struct Body {
    std::vector<dvec4> planes;
    std::size_t solid = 0;  ///< as WorldSide::solid
};

/// The bodies with which lines are compared. A closed convex solid is one body; every other plane
/// convex piece of a polygon is a (flat) body by itself.
struct Bodies {
    std::vector<Body> bodies;
    std::vector<WorldSide> sides;
    double tolerance = 0;  ///< points nearer than this to a plane are on it
};

using Key = std::tuple<double, double, double>;
using SideKey = std::pair<Key, Key>;

Key key_of(const dvec3& p) { return {p.x, p.y, p.z}; }
SideKey key_of(const dvec3& p, const dvec3& q) { return std::minmax(key_of(p), key_of(q)); }

dvec4 unit(const dvec4& plane) {
    const double length = std::sqrt(dot3(dvec3(plane), dvec3(plane)));
    return length > 0 ? plane / length : dvec4(0);
}

dvec3 middle_of(const Loop& loop) {
    dvec3 sum(0);
    for (const dvec3& p : loop) sum += p;
    return sum / double(loop.size());
}

/// The test whether a solid is convex takes time with the square of its facets. Larger solids are
/// taken piece by piece.
constexpr std::size_t most_facets = 4096;

/// A plane piece of a polygon that belongs to a figure.
struct Facet3 {
    const Loop* loop = nullptr;
    dvec4 plane{0};
    bool front = false;  ///< faces the eye
};

/// Polygons connected by common corners.
struct Figure {
    std::vector<Facet3> facets;
    bool all_convex = true;                                 ///< every facet is one convex loop
    std::map<SideKey, std::vector<std::size_t>> facets_of;  ///< sides: facets
};

class Maker {
public:
    Maker(const Input& input, LineCounts& counts)
        : input_(input),
          counts_(counts),
          eye_(eye_of(input.view)),
          near_(unit(near_plane_of(input.view))) {
        out_.tolerance = world_tolerance(input.polygons);
        for (const std::vector<std::size_t>& figure : figures()) add(figure);
    }
    Bodies take() { return std::move(out_); }

private:
    /// Groups of polygons of one object that are connected by common corners.
    std::vector<std::vector<std::size_t>> figures() const {
        std::vector<std::size_t> parent(input_.polygons.size());
        std::iota(parent.begin(), parent.end(), std::size_t{0});
        const auto root = [&](std::size_t i) {
            while (parent[i] != i) i = parent[i] = parent[parent[i]];
            return i;
        };
        std::map<std::pair<std::size_t, Key>, std::size_t> first;
        for (std::size_t i = 0; i < parent.size(); ++i)
            for (const dvec3& p : input_.polygons[i].world) {
                const auto [found, is_new] =
                    first.try_emplace({input_.polygons[i].object, key_of(p)}, i);
                parent[std::max(root(i), root(found->second))] =
                    std::min(root(i), root(found->second));
            }
        std::vector<std::vector<std::size_t>> found(parent.size());
        for (std::size_t i = 0; i < parent.size(); ++i) found[root(i)].push_back(i);
        std::erase_if(found, [](const auto& figure) { return figure.empty(); });
        return found;
    }

    void add(const std::vector<std::size_t>& polygons) {
        Figure figure;
        for (const std::size_t i : polygons)
            for (const WorldFacet& facet : input_.polygons[i].world_facets) {
                if (!has_area(facet)) continue;
                const dvec4 plane = unit_plane(facet);
                figure.all_convex = figure.all_convex && facet.parts.size() == 1;
                for (const Loop& part : facet.parts) {
                    for (std::size_t k = 0; k < part.size(); ++k)
                        figure.facets_of[key_of(part[k], part[(k + 1) % part.size()])].push_back(
                            figure.facets.size());
                    figure.facets.push_back({&part, plane});
                }
            }
        const bool solid = make_solid(figure);
        if (!solid)
            for (const Facet3& facet : figure.facets) add_flat(*facet.loop, facet.plane);
        add_sides(polygons, figure, solid);
    }

    /// Adds the figure as a solid if it is closed, convex, beyond the near plane and seen from
    /// outside.
    bool make_solid(Figure& figure) {
        if (figure.facets.size() < 4 || figure.facets.size() > most_facets || !figure.all_convex)
            return false;
        for (const auto& [side, facets] : figure.facets_of)
            if (facets.size() != 2) return false;
        if (!turn_outwards(figure)) return false;
        bool outside = false;
        for (Facet3& facet : figure.facets) {
            for (const dvec3& p : *facet.loop)
                if (side(near_, p) <= 0) return false;
            counts_.facings += 1;
            facet.front = dot4(facet.plane, eye_) > out_.tolerance;
            outside = outside || facet.front;
        }
        if (!outside) return false;
        add_solid(figure);
        return true;
    }

    /// Turns all planes outwards. False: a corner lies outside a plane, so the figure is not convex.
    bool turn_outwards(Figure& figure) const {
        const dvec3 middle = middle_of(*figure.facets[0].loop);
        double least = 0;
        for (const Facet3& facet : figure.facets)
            least = std::min(least, side(facet.plane, middle));
        for (Facet3& facet : figure.facets) {
            if (least >= -out_.tolerance) facet.plane = -facet.plane;
            for (const Facet3& other : figure.facets)
                for (const dvec3& p : *other.loop)
                    if (side(facet.plane, p) > out_.tolerance) return false;
        }
        return true;
    }

    void add_solid(const Figure& figure) {
        Body body{{}, ++solids_};
        dvec3 middle(0);
        for (const Facet3& facet : figure.facets) {
            middle += middle_of(*facet.loop) / double(figure.facets.size());
            if (facet.front) body.planes.push_back(-facet.plane);
        }
        for (const auto& [ends, facets] : figure.facets_of)
            if (figure.facets[facets[0]].front != figure.facets[facets[1]].front)
                add_contour(point(ends.first), point(ends.second), middle, body);
        out_.bodies.push_back(std::move(body));
    }

    static dvec3 point(const Key& key) {
        return {std::get<0>(key), std::get<1>(key), std::get<2>(key)};
    }

    /// The plane through the eye and p -> q, `inside` on its positive side.
    void add_contour(const dvec3& p, const dvec3& q, const dvec3& inside, Body& body) const {
        const dvec4 plane = unit(plane_of(cross3(q - p, dvec3(eye_) - eye_.w * p), p));
        if (plane != dvec4(0)) body.planes.push_back(side(plane, inside) > 0 ? plane : -plane);
    }

    /// Adds the part of the loop beyond the near plane as a flat body.
    void add_flat(const Loop& loop, const dvec4& plane) {
        counts_.facings += 1;
        const double towards = dot4(plane, eye_);
        if (std::abs(towards) <= out_.tolerance) return;  // edge-on: hides nothing
        for (const Loop& part : divide({loop}, near_).second) {
            Body body{{towards > 0 ? -plane : plane}, 0};
            for (std::size_t k = 0; k < part.size(); ++k)
                add_contour(part[k], part[(k + 1) % part.size()], middle_of(part), body);
            out_.bodies.push_back(std::move(body));
        }
    }

    void add_sides(const std::vector<std::size_t>& polygons, const Figure& figure, bool solid) {
        for (const std::size_t i : polygons) {
            const Loop& loop = input_.polygons[i].world;
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const dvec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
                const SideKey key = key_of(p, q);
                if (p == q || !done_.insert({{input_.polygons[i].object, key}, true}).second)
                    continue;
                WorldSide side{p, q, input_.polygons[i].id, solid ? solids_ : 0};
                const auto facets = figure.facets_of.find(key);
                side.back = solid && facets != figure.facets_of.end() &&
                            !figure.facets[facets->second[0]].front &&
                            !figure.facets[facets->second[1]].front;
                out_.sides.push_back(side);
            }
        }
    }

    const Input& input_;
    LineCounts& counts_;
    dvec4 eye_, near_;
    Bodies out_;
    std::size_t solids_ = 0;
    std::map<std::pair<std::size_t, SideKey>, bool> done_;
};

/// Counts facings.
Bodies bodies_of(const Input& input, LineCounts& counts) { return Maker(input, counts).take(); }

/// The part of p -> q that lies on the positive side of all the body's planes. An end that is nearer
/// to a plane than the tolerance is on it; between the ends no tolerance shortens the part, or the
/// line would be seen between two bodies that touch.
std::optional<Part> hidden_by(const Body& body, const WorldSide& line, double tolerance,
                              LineCounts& counts) {
    Part part{0, 1};
    for (const dvec4& plane : body.planes) {
        counts.planes += 1;
        const auto at = [&](const dvec3& end) {
            const double d = side(plane, end);
            return std::abs(d) > tolerance ? d : 0;
        };
        const double a = at(line.p), b = at(line.q);
        if (a <= 0 && b <= 0) return std::nullopt;
        if (a < 0) part.first = std::max(part.first, a / (a - b));
        if (b < 0) part.second = std::min(part.second, a / (a - b));
        if (part.first >= part.second) return std::nullopt;
    }
    return part;
}

/// The step has the places on the line as drawn, as the line's own step has.
void log_hidden(const WorldSide& line, const WorldLines& window, std::size_t body, const Body& by,
                const Part& part, StepLog& log) {
    if (!log.wants(Level::Span)) return;
    const auto drawn = window.to_window(line.id, line.p, line.q, {part});
    if (!drawn || drawn->visible.empty()) return;
    const auto [from, to] = drawn->visible.front();
    log.add({.level = Level::Span,
             .test = "body",
             .result = "hides",
             .pieces = {std::to_string(line.id)},
             .values = {{"body", std::int64_t(body)},
                        {"planes", std::int64_t(by.planes.size())},
                        {"hidden", std::vector{from, to}}},
             .decisive = true});
}

std::vector<Part> visible_parts(const Bodies& scene, const WorldSide& line,
                                const WorldLines& window, LineCounts& counts, StepLog& log) {
    if (line.back) return {};
    counts.starts += 1;
    std::vector<Part> hidden;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        // a solid's front lines are before it
        if (body.solid != 0 && body.solid == line.solid) continue;
        const auto part = hidden_by(body, line, scene.tolerance, counts);
        if (!part) continue;
        hidden.push_back(*part);
        log_hidden(line, window, i, body, *part, log);
    }
    return rest_of(std::move(hidden));
}

LineOutput run(const Input& input, StepLog& log) {
    LineOutput output;
    log.watch(watched(output.counts));
    const Bodies scene = bodies_of(input, output.counts);
    const WorldLines window(input);
    output.counts.faces = scene.bodies.size();
    for (const Body& body : scene.bodies)
        output.counts.peak_bytes += sizeof(Body) + body.planes.size() * sizeof(dvec4);
    output.counts.peak_bytes += scene.sides.size() * sizeof(WorldSide);
    for (const WorldSide& side : scene.sides) {
        const auto line = window.to_window(side.id, side.p, side.q,
                                           visible_parts(scene, side, window, output.counts, log));
        if (!line) continue;
        output.counts.lines += 1;
        output.counts.parts += line->visible.size();
        log_line(*line, "bodies", {{"back", side.back}}, log);
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
        .growth = {GrowthLaw::Superlinear, 3, Sampling::Joined},
        .run = run};
}

}  // namespace gw::hiddensurface
