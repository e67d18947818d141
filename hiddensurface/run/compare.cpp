#include "hiddensurface/run/compare.h"

#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/structures/bsp_tree.h"
#include "scene/draw/draw_commands.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gw::hiddensurface {
namespace {

/// The same list, with a stencil that counts the writes of each pixel. Its counters differ.
CommandList counting(CommandList list) {
    for (Command& command : list.commands) {
        if (auto* set = std::get_if<SetState>(&command))
            set->state.edit().stencil = {.test = true, .zpass = StencilOp::Incr};
        if (auto* clear = std::get_if<Clear>(&command))
            clear->planes = PlaneMask(clear->planes | mask_of(Plane::Stencil));
    }
    return list;
}

void add_machine_counts(const std::vector<PassReport>& passes, Counts& counts) {
    for (const PassReport& pass : passes) {
        counts.fragments += pass.counters.fragments;
        counts.passed += pass.counters.written;
    }
}

/// A sub-pixel unit is one unit of the grid.
constexpr double reach = 1;

/// Two faces that are both in a third one's plane may be as far apart, in tolerances.
constexpr double most_apart = 2;

double distance(const CutEdge& edge, const dvec2& p) {
    const dvec2 side = edge.second - edge.first, to = p - edge.first;
    const double length2 = side.x * side.x + side.y * side.y;
    const double t =
        length2 > 0 ? std::clamp((to.x * side.x + to.y * side.y) / length2, 0.0, 1.0) : 0.0;
    const dvec2 away = to - t * side;
    return std::sqrt(away.x * away.x + away.y * away.y);
}

}  // namespace

Result run_on(Machine& machine, const Algorithm& algorithm, const Input& input, StepLog& log) {
    Output output = algorithm.run(input, log);
    log.watch({});
    Result result{.counts = output.counts,
                  .pieces = std::move(output.pieces),
                  .shares = std::move(output.shares)};
    machine.reset_passes();
    machine.execute(output.list);
    add_machine_counts(machine.passes(), result.counts);
    for (const Rgba& color : machine.planes().color) result.ids.push_back(scene::id_of(color));
    for (const Polygon& polygon : input.polygons)
        result.counts.polygons += polygon.visible() ? 1 : 0;
    for (const std::uint32_t id : result.ids) result.counts.pixels += id != 0 ? 1 : 0;
    result.counts.overdraw = result.counts.passed - result.counts.pixels;
    machine.execute(counting(std::move(output.list)));
    result.writes = machine.planes().stencil;
    return result;
}

void compare(Result& result, const std::vector<std::uint32_t>& z_buffer, const Input& input) {
    const Differences differences(input, result.pieces);
    result.difference.assign(result.ids.size(), Difference::None);
    result.expected = z_buffer;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < result.ids.size(); ++i) {
        const int x = int(i) % input.view.width, y = int(i) / input.view.width;
        result.difference[i] = differences.at(result.ids[i], z_buffer[i], x, y);
        switch (result.difference[i]) {
            case Difference::None: break;
            case Difference::Tie: result.counts.ties += 1; break;
            case Difference::Edge: result.counts.edges += 1; break;
            case Difference::Snap: result.counts.snapped += 1; break;
            case Difference::Wrong:
                result.counts.wrong += 1;
                if (!differences.in_one_plane(result.ids[i], z_buffer[i], x, y)) break;
                if (result.one_plane.pixels++ == 0)
                    result.one_plane.first = {result.ids[i], z_buffer[i]};
                pairs.insert(std::minmax(result.ids[i], z_buffer[i]));
                break;
        }
    }
    result.one_plane.pairs = pairs.size();
}

std::string one_plane_warning(const std::string& algorithms, const Input& input,
                              const OnePlane& found) {
    const auto named = [&](std::uint32_t id) {
        const auto polygon = std::ranges::find(input.polygons, id, &Polygon::id);
        return fmt::format("{} of '{}'", id,
                           scene::printable(input.scene.objects[polygon->object].name));
    };
    return fmt::format(
        "{}: polygons {} and {} are so near that their planes count as one, and the first of the "
        "scene is seen: {} wrong, of {}; expected them more than {:.3g} apart, 2 millionths of the "
        "largest coordinate",
        algorithms, named(found.first.first), named(found.first.second),
        found.pixels == 1 ? "1 pixel is" : fmt::format("{} pixels are", found.pixels),
        found.pairs == 1 ? "1 pair" : fmt::format("{} pairs", found.pairs),
        most_apart * world_tolerance(input.polygons));
}

std::vector<std::uint8_t> depth_complexity(const Input& input) {
    std::vector<std::uint8_t> count(std::size_t(input.view.width) * std::size_t(input.view.height));
    for (const Polygon& polygon : input.polygons)
        for (const WindowTriangle& t : polygon.triangles)
            for (const Run& run : scan_convert(t.corners, input.subpixel_bits(), input.window()))
                for (int x = run.x0; x < run.x1; ++x) {
                    std::uint8_t& n = count[input.view.index(x, run.y)];
                    n = static_cast<std::uint8_t>(std::min(n + 1, 255));
                }
    return count;
}

bool depths_tie(const WindowTriangle& shown, const WindowTriangle& other, int x, int y) {
    const std::int64_t apart = shown.depth.at(x, y) - other.depth.at(x, y);
    if (apart == 0) return true;
    return std::abs(apart) == 1 &&
           exact_order(shown.corners, other.corners, x, y, shown.depth.subpixel_bits) <= 0;
}

Differences::Differences(const Input& input, const std::vector<Piece>& pieces)
    : input_(input), tolerance_(world_tolerance(input.polygons)) {
    for (const Polygon& polygon : input.polygons) known_[polygon.id].polygon = &polygon;
    for (const Piece& piece : pieces) {
        std::vector<CutEdge>& made = known_[input.polygons[piece.polygon].id].made;
        const std::vector<CutEdge> more = edges_made(piece);
        made.insert(made.end(), more.begin(), more.end());
    }
}

const WindowTriangle* Differences::covering(std::uint32_t id, int x, int y) const {
    const auto found = known_.find(id);
    if (found == known_.end()) return nullptr;
    for (const WindowTriangle& t : found->second.polygon->triangles)
        if (!scan_convert(t.corners, input_.subpixel_bits(), {x, y, 1, 1}).empty()) return &t;
    return nullptr;
}

bool Differences::near_made_edge(std::uint32_t id, const dvec2& center) const {
    const auto found = known_.find(id);
    if (found == known_.end()) return false;
    const std::vector<CutEdge>& made = found->second.made;
    return std::any_of(made.begin(), made.end(),
                       [&](const CutEdge& edge) { return distance(edge, center) <= reach; });
}

const WorldFacet& Differences::facet_of(std::uint32_t id, const WindowTriangle& t) const {
    const auto& facets = known_.at(id).polygon->world_facets;
    return *std::find_if(facets.begin(), facets.end(), [&](const WorldFacet& facet) {
        return t.source >= facet.first && t.source - facet.first < facet.count;
    });
}

double Differences::scene_depth(const WorldFacet& facet, const dvec2& at,
                                double towards_eye) const {
    dvec4 plane = unit_plane(facet);
    plane.w -= is_before(plane, input_.view) ? towards_eye : -towards_eye;
    const dvec4 window = to_window(plane, input_.view, input_.profile);
    return -(window.x * at.x + window.y * at.y + window.w) / window.z;
}

double Differences::snap_reach(const WorldFacet& facet) const {
    const dvec4 window = to_window(unit_plane(facet), input_.view, input_.profile);
    return 0.5 + 0.5 * (std::abs(window.x) + std::abs(window.y)) / std::abs(window.z);
}

bool Differences::covers_in_scene(const WorldFacet& facet, const dvec2& at) const {
    const dvec4 eye = eye_of(input_.view);
    return std::any_of(facet.parts.begin(), facet.parts.end(), [&](const Loop& part) {
        std::size_t left = 0;
        for (std::size_t i = 0; i < part.size(); ++i) {
            // The plane through the eye and a side is a line in the window.
            const dvec3 &a = part[i], &b = part[(i + 1) % part.size()];
            const dvec4 plane = plane_of(cross3(b - a, dvec3(eye) - eye.w * a), a);
            const dvec4 line = to_window(plane, input_.view, input_.profile);
            left += line.x * at.x + line.y * at.y + line.w > 0 ? 1 : 0;
        }
        return left == 0 || left == part.size();
    });
}

bool Differences::snap_turned(std::uint32_t id, const WindowTriangle& shown, std::uint32_t expected,
                              const WindowTriangle& other, int x, int y) const {
    const WorldFacet &a = facet_of(id, shown), &b = facet_of(expected, other);
    const double apart = double(shown.depth.at(x, y) - other.depth.at(x, y));
    if (apart > snap_reach(a) + snap_reach(b) + 1) return false;
    const dvec2 middle = middle_of(x, y);
    return !covers_in_scene(a, middle) || !covers_in_scene(b, middle) ||
           scene_depth(a, middle, tolerance_) <= scene_depth(b, middle, 0);
}

bool Differences::in_one_plane(std::uint32_t id, std::uint32_t expected, int x, int y) const {
    const WindowTriangle *shown = covering(id, x, y), *other = covering(expected, x, y);
    if (!shown || !other) return false;
    const dvec2 middle = middle_of(x, y);
    return scene_depth(facet_of(id, *shown), middle, most_apart * tolerance_) <=
           scene_depth(facet_of(expected, *other), middle, 0);
}

dvec2 Differences::middle_of(int x, int y) const {
    return {double(center(x, input_.subpixel_bits())), double(center(y, input_.subpixel_bits()))};
}

Difference Differences::at(std::uint32_t id, std::uint32_t expected, int x, int y) const {
    if (id == expected) return Difference::None;
    const WindowTriangle *shown = covering(id, x, y), *other = covering(expected, x, y);
    if (shown && other && depths_tie(*shown, *other, x, y)) return Difference::Tie;
    const dvec2 middle = middle_of(x, y);
    if (near_made_edge(id, middle) || near_made_edge(expected, middle)) return Difference::Edge;
    return shown && other && snap_turned(id, *shown, expected, *other, x, y) ? Difference::Snap
                                                                             : Difference::Wrong;
}

std::vector<std::vector<std::uint32_t>> polygons_over(const Input& input) {
    const auto width = std::size_t(input.view.width);
    std::vector<std::vector<std::uint32_t>> over(width * std::size_t(input.view.height));
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const Polygon& polygon = input.polygons[i];
        for (const Run& run :
             runs_of(whole(i, polygon), polygon, input.subpixel_bits(), input.window()))
            for (int x = run.x0; x < run.x1; ++x)
                over[std::size_t(run.y) * width + std::size_t(x)].push_back(polygon.id);
    }
    return over;
}

}  // namespace gw::hiddensurface
