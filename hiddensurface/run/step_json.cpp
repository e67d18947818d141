#include "hiddensurface/run/step_json.h"

#include "hiddensurface/faces/face.h"
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/faces/world_piece.h"
#include "hiddensurface/run/step_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;

/// Turns y over.
dvec3 turned(const dvec3& p, const PictureGrid& grid) {
    return {p.x, double(grid.height) * grid.unit - p.y, p.z};
}
int turned_row(int y, const PictureGrid& grid) { return grid.height - 1 - y; }
Rect turned(const Rect& w, const PictureGrid& grid) {
    return {w.x, grid.height - w.y - w.height, w.width, w.height};
}

Json json_of(const dvec3& p) { return {p.x, p.y, p.z}; }
Json json_of(const dvec4& p) { return {p.x, p.y, p.z, p.w}; }
Json json_of(const Loop& loop) {
    Json points = Json::array();
    for (const dvec3& p : loop) points.push_back(json_of(p));
    return points;
}
Json json_of(const std::vector<Loop>& loops, const PictureGrid& grid) {
    Json out = Json::array();
    for (Loop loop : loops) {
        for (dvec3& p : loop) p = turned(p, grid);
        out.push_back(json_of(loop));
    }
    return out;
}
Json json_of(const Value& value) {
    return std::visit([](const auto& v) { return Json(v); }, value);
}

Json json_of(const DrawnLine& line, const PictureGrid& grid) {
    Json visible = Json::array();
    for (const auto& [from, to] : line.visible) visible.push_back({from, to});
    return {{"from", json_of(turned(line.a, grid))},
            {"to", json_of(turned(line.b, grid))},
            {"visible", visible}};
}

/// The plane on the grid as (x, y, z, d), z = 1, y downwards: a x + b y + z + d is the distance
/// behind it in units of the depth plane. None: it is seen from the edge.
Json json_of_plane(const dvec4& p, const PictureGrid& grid) {
    if (p.z == 0) return nullptr;
    const dvec4 plane = p / p.z;
    return json_of(dvec4(plane.x, -plane.y, 1, plane.w + plane.y * grid.height * grid.unit));
}

Json piece_json(const std::string& name, const std::vector<Loop>& outline, const dvec4& plane,
                const PictureGrid& grid) {
    return {
        {"name", name}, {"outline", json_of(outline, grid)}, {"plane", json_of_plane(plane, grid)}};
}

/// From pixels' centres to the grid.
dvec4 plane_of(const Face& face, const PictureGrid& grid) {
    const ExactPlane& p = face.plane;
    const double n = double(p.n), unit = double(grid.unit);
    const double x = double(p.x) / n / unit, y = double(p.y) / n / unit;
    return {-x, -y, 1, 0.5 * unit * (x + y) - double(p.c) / n};
}

/// Through the snapped corners if they are in one plane; else the scene's plane.
dvec4 plane_on_grid(const Input& input, const TreePiece& piece) {
    const std::vector<Facet>& facets = input.polygons[piece.of.polygon].facets;
    return facets.size() == 1
               ? facets.front().plane
               : to_window(unit_plane(facet_of(input, piece.of)), input.view, input.profile);
}

/// What the algorithm sorts: the polygon, or its plane parts. `faces`: the polygon's.
Json pieces_json(const Input& input, std::size_t i, bool in_world, std::span<const Face> faces) {
    const PictureGrid grid = grid_of(input);
    Json pieces = Json::array();
    if (in_world)
        for (const TreePiece& piece : pieces_of(input.polygons, {i}))
            pieces.push_back(piece_json(name_of(input.polygons, piece),
                                        window_piece(input, piece).parts,
                                        plane_on_grid(input, piece), grid));
    else
        for (const Face& face : faces) {
            Loop outline;
            for (const GridPoint& p : face.corners) outline.push_back(to_dvec3(p));
            pieces.push_back(piece_json(face.name, {outline}, plane_of(face, grid), grid));
        }
    return pieces;
}

Json polygon_json(const Input& input, std::size_t i, bool in_world, std::span<const Face> faces,
                  const std::map<std::uint32_t, std::string>& colors) {
    const Polygon& polygon = input.polygons[i];
    const scene::Object& object = input.scene.objects[polygon.object];
    const auto color = colors.find(polygon.id);
    return {{"id", polygon.id},
            {"part", object.name},
            {"color", color != colors.end() ? color->second : "#808080"},
            {"world", json_of(polygon.world)},
            {"nearest", polygon.nearest},
            {"farthest", polygon.farthest},
            {"centroid", polygon.centroid},
            {"outline", json_of(whole(i, polygon).parts, grid_of(input))},
            {"pieces", pieces_json(input, i, in_world, faces)}};
}

Json view_json(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    return {{"eye", json_of(dvec3(camera.eye))},
            {"at", json_of(dvec3(camera.at))},
            {"up", json_of(dvec3(camera.up))},
            {"fov", camera.fov},
            {"ortho_height", camera.ortho_height},
            {"near", camera.near_plane},
            {"far", camera.far_plane}};
}

template <class AnyCounts, class Names>
Json end_of(std::size_t steps, const AnyCounts& counts, const Names& names) {
    Json json{{"end", steps}, {"counts", Json::object()}};
    for (const auto& [name, count] : names) json["counts"][name] = counts.*count;
    return json;
}

}  // namespace

std::string to_json(const Step& step, std::size_t number, const PictureGrid& grid) {
    Json json{{"step", number},
              {"level", name_of(step.level)},
              {"kind", name_of(step.action)},
              {"test", step.test},
              {"result", step.result}};
    if (!step.pieces.empty()) json["pieces"] = step.pieces;
    if (step.decisive) json["decisive"] = true;
    if (step.window.width > 0) {
        const Rect w = turned(step.window, grid);
        json["window"] = {w.x, w.y, w.width, w.height};
    }
    for (const auto& [name, value] : step.values) json["values"][name] = json_of(value);
    for (const auto& [run, id] : step.painted)
        json["painted"].push_back({turned_row(run.y, grid), run.x0, run.x1, id});
    for (const NamedOutline& piece : step.made)
        json["made"].push_back({{"name", piece.name}, {"outline", json_of(piece.outline, grid)}});
    if (step.line) json["line"] = json_of(*step.line, grid);
    for (const auto& [name, count] : step.counts) json["counts"][name] = count;
    return json.dump();
}

std::string log_header(const Input& input, const LogSubject& subject,
                       const std::map<std::uint32_t, std::string>& colors) {
    const auto background = colors.find(0);
    Json json{{"log", log_name},
              {"version", log_version},
              {"algorithm", subject.algorithm},
              {"title", subject.title},
              {"draws", subject.lines ? "lines" : "surfaces"},
              {"decides", subject.in_world ? "world" : "window"},
              {"level", name_of(subject.level)},
              {"scene", input.scene.name},
              {"size", {input.view.width, input.view.height}},
              {"unit", 1 << input.subpixel_bits()},
              {"depth", (std::int64_t{1} << input.profile.depth_bits) - 1},
              {"view", view_json(input.view)},
              {"background", background != colors.end() ? background->second : "#000000"},
              {"words", Json::parse(step_words())},
              {"polygons", Json::array()}};
    const std::vector<Face> faces = faces_of(input);
    std::span<const Face> rest = faces;
    for (std::size_t i = 0; i < input.polygons.size(); ++i) {
        const auto last = std::find_if(rest.begin(), rest.end(),
                                       [i](const Face& face) { return face.polygon != i; });
        const auto count = std::size_t(last - rest.begin());
        json["polygons"].push_back(
            polygon_json(input, i, subject.in_world, rest.first(count), colors));
        rest = rest.subspan(count);
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string log_end(std::size_t steps, const Counts& counts, const PictureGrid& grid,
                    const std::vector<Blame>& blame) {
    Json json = end_of(steps, counts, count_names());
    for (const Blame& b : blame)
        json["blame"].push_back({{"step", b.step},
                                 {"polygon", b.id},
                                 {"over", b.over},
                                 {"expected", b.expected},
                                 {"pixels", b.pixels},
                                 {"first", {b.x, turned_row(b.y, grid)}}});
    return json.dump();
}
std::string log_end(std::size_t steps, const LineCounts& counts) {
    return end_of(steps, counts, line_count_names()).dump();
}

std::string log_text(const Input& input, const LogSubject& subject, const std::vector<Step>& steps,
                     const std::string& end) {
    const PictureGrid grid = grid_of(input);
    std::string text = log_header(input, subject, hex_colors(input)) + "\n";
    for (std::size_t i = 0; i < steps.size(); ++i) text += to_json(steps[i], i + 1, grid) + "\n";
    return text + end + "\n";
}

}  // namespace gw::hiddensurface
