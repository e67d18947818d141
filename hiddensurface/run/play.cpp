#include "hiddensurface/run/play.h"

#include "gw/error.h"
#include "hiddensurface/faces/world_piece.h"
#include "hiddensurface/run/read_step.h"
#include "hiddensurface/run/step_words.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;

/// More corners and runs of pixels in all drawn outlines need too much memory. An outline that is
/// drawn again counts again, and each with some more.
constexpr std::size_t most_drawn = 10'000'000, drawn_with_each = 16;

/// Twice the area to the left of p -> q -> r.
double turn_of(const dvec3& p, const dvec3& q, const dvec3& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// The line through two points, the same for both directions: neighbours share each pixel's side.
dvec3 line_through(dvec2 a, dvec2 b) {
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    const dvec2 across(b.y - a.y, a.x - b.x);
    return {across.x, across.y, -(across.x * a.x + across.y * a.y)};
}
double side_of(const dvec3& line, const dvec3& p) { return line.x * p.x + line.y * p.y + line.z; }

/// As far off as the rounding of corners that a program computed.
bool is_on_line(const dvec3& line, const dvec3& p) {
    return std::abs(side_of(line, p)) <= 1e-3 * std::sqrt(line.x * line.x + line.y * line.y);
}

/// True but for bends within that rounding.
bool bends_one_way(const Loop& loop) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const dvec3 &a = loop[i], &b = loop[(i + 1) % loop.size()],
                    &c = loop[(i + 2) % loop.size()];
        if (is_on_line(line_through(dvec2(a), dvec2(b)), c)) continue;
        (turn_of(a, b, c) > 0 ? left : right) = true;
    }
    return !(left && right);
}

/// The lines of a polygon's sides in the window: of those that only one of its triangles has.
std::vector<dvec3> outer_lines(const Polygon& polygon) {
    using Corner = std::pair<std::int64_t, std::int64_t>;
    std::map<std::pair<Corner, Corner>, int> users;
    for (const WindowTriangle& t : polygon.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const GridPoint &a = t.corners[i], &b = t.corners[(i + 1) % 3];
            users[std::minmax(Corner(a.x, a.y), Corner(b.x, b.y))] += 1;
        }
    std::vector<dvec3> lines;
    for (const auto& [side, count] : users)
        if (count == 1)
            lines.push_back(
                line_through(dvec2(double(side.first.first), double(side.first.second)),
                             dvec2(double(side.second.first), double(side.second.second))));
    return lines;
}

/// A counter of algorithms. The machine and the comparison have the others.
std::uint64_t Counts::*counter_named(const std::string& name) {
    std::string known;
    for (const auto& [other, count] : count_names()) {
        if (other == std::string("polygons")) continue;
        if (other == std::string("fragments")) break;
        if (other == name) return count;
        known += (known.empty() ? "" : ", ") + std::string(other);
    }
    throw Error("unknown counter '" + scene::printable(name) + "'; expected one of " + known);
}

/// Reads line after line; knows the pieces made so far.
class Player {
public:
    explicit Player(const Input& input) : input_(input) {
        for (std::size_t i = 0; i < input.polygons.size(); ++i) {
            index_of_[input.polygons[i].id] = i;
            for (const TreePiece& part : pieces_of(input.polygons, {i}))
                known_[name_of(input.polygons, part)] = {window_piece(input, part)};
            known_[name_of(input.polygons[i])] = {whole(i, input.polygons[i])};
        }
    }

    /// Adds the line's step to the play, if it has one.
    void read(const std::string& line, Play& play) {
        const Json json = json_of_line(line);
        if (ended_) throw Error("a line after the end; expected none");
        if (json.is_object() && json.contains("log")) return read_header(json);
        if (json.is_object() && json.contains("end")) return read_end(json, play.steps.size());
        if (play.steps.size() == most_steps)
            throw Error("a step too many; expected at most 2,000,000");
        Step step = step_of(json, grid_of(input_));
        check(step);
        if (step.action == Action::Split && (step.pieces.empty() || step.made.empty()))
            throw Error("a split without " +
                        std::string(step.made.empty() ? "outlines" : "pieces") +
                        "; expected the cut piece in 'pieces', and its parts with their outlines "
                        "in 'made'");
        for (const NamedOutline& made : step.made) known_[made.name] = pieces_of_outline(made);
        if (step.action == Action::Draw) draw(step, play);
        try {
            sentence_of(step, grid_of(input_), "en");
        } catch (const Error& error) {
            throw Error(std::string(error.what()) + ", or another test or result");
        }
        play.level = std::max(play.level, step.level);
        play.steps.push_back(std::move(step));
    }

    /// Throws Error if lines must follow.
    void check_end(const Play& play) const {
        if (has_header_ && !ended_)
            throw Error(
                "the log has no end; expected a last line {\"end\": ...}: is the file cut?");
        if (play.steps.empty()) throw Error("no step; expected a line of JSON for each");
    }

private:
    void read_header(const Json& json) {
        if (json["log"] != log_name)
            throw Error(fmt::format("a header of another log; expected '{}'", log_name));
        const auto version = json.find("version");
        if (version == json.end() || *version != log_version)
            throw Error(fmt::format("a log of another version; expected {}", log_version));
        const Json size{input_.view.width, input_.view.height};
        const auto found = json.find("size");
        if (found == json.end() || *found != size)
            throw Error(fmt::format("a log of another size; expected {}x{}, or its --size",
                                    input_.view.width, input_.view.height));
        if (const auto draws = json.find("draws"); draws != json.end() && *draws == "lines")
            throw Error("a log of lines; expected surfaces");
        has_header_ = true;
    }
    void read_end(const Json& json, std::size_t steps) {
        if (json["end"] != steps)
            throw Error(fmt::format("the end tells another number of steps; expected {}", steps));
        ended_ = true;
    }

    const Polygon& polygon_named(const std::string& piece) const {
        const auto found = index_of_.find(polygon_of(piece));
        if (found == index_of_.end())
            throw Error("unknown polygon '" + scene::printable(piece) +
                        "'; expected one of the scene, or a piece of it");
        return input_.polygons[found->second];
    }

    void check(const Step& step) const {
        for (const std::string& piece : step.pieces) {
            polygon_named(piece);
            const bool is_cut = piece.back() == 'a' || piece.back() == 'b';
            if (is_cut && !known_.count(piece))
                throw Error("the piece '" + scene::printable(piece) +
                            "' is not made yet; expected it with its outline in 'made' before");
        }
        for (const NamedOutline& made : step.made) polygon_named(made.name);
        const int width = input_.view.width, height = input_.view.height;
        const Rect& w = step.window;
        if (w.y < 0 || w.width > width - w.x || w.height > height - w.y)
            throw Error(
                fmt::format("'window' reaches outside; expected pixels of {}x{}", width, height));
        for (const auto& [run, id] : step.painted) {
            if (run.y < 0 || run.x0 > run.x1 || run.x1 > width)
                throw Error(
                    fmt::format("'painted' has pixels {} to {} of row {}; expected pixels of "
                                "{}x{}",
                                run.x0, run.x1 - 1, height - 1 - run.y, width, height));
            if (!index_of_.count(id))
                throw Error(fmt::format(
                    "'painted' has the unknown polygon {}; expected one of the scene", id));
        }
        if (step.line) throw Error("a drawn line; expected a piece or 'painted'");
        if (step.action != Action::Draw && !step.painted.empty())
            throw Error("'painted' in a step that does not draw; expected \"kind\": \"draw\"");
        for (const auto& [name, count] : step.counts) counter_named(name);
    }

    /// One for each loop. Sides on the polygon's own are no cuts: its pixels end there anyway.
    std::vector<Piece> pieces_of_outline(const NamedOutline& made) const {
        const Polygon& polygon = polygon_named(made.name);
        const std::vector<dvec3> outer = outer_lines(polygon);
        std::vector<Piece> pieces;
        for (const Loop& loop : made.outline) {
            Piece piece = whole(index_of_.at(polygon.id), polygon);
            piece.name = made.name;
            piece.parts = {loop};
            dvec3 middle(0);
            for (const dvec3& p : loop) middle = middle + p / double(loop.size());
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const dvec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
                const bool own = std::any_of(outer.begin(), outer.end(), [&](const dvec3& line) {
                    return is_on_line(line, a) && is_on_line(line, b);
                });
                const dvec3 line = line_through(dvec2(a), dvec2(b));
                if (!own && (line.x != 0 || line.y != 0))
                    piece.cuts.push_back({line, side_of(line, middle) < 0});
            }
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }

    /// Gives the step its pixels, if the program leaves them to the outline.
    void draw(Step& step, Play& play) {
        if (step.pieces.empty() && step.painted.empty())
            throw Error("draws nothing; expected one piece in 'pieces', or 'painted'");
        const bool by_outline = step.painted.empty();
        if (by_outline && step.pieces.size() != 1)
            throw Error(
                fmt::format("draws {} pieces; expected one, or 'painted'", step.pieces.size()));
        for (const std::string& name : step.pieces) {
            const auto found = known_.find(name);
            if (found == known_.end() && by_outline)
                throw Error("the piece '" + scene::printable(name) +
                            "' has no outline; expected a polygon, a plane part of it, or a piece "
                            "of 'made'");
            if (found == known_.end()) continue;
            for (const Piece& piece : found->second) {
                const std::size_t before = step.painted.size();
                if (by_outline) add_pixels(piece, step.painted);
                drawn_ += drawn_with_each + step.painted.size() - before;
                for (const Loop& loop : piece.parts) drawn_ += loop.size();
                if (drawn_ > most_drawn)
                    throw Error(
                        "the drawn outlines have too many corners and runs of pixels; expected at "
                        "most 10,000,000 in all");
                play.pieces.push_back(piece);
            }
        }
        const auto is_pixels = [](const auto& value) { return value.first == "pixels"; };
        if (std::none_of(step.values.begin(), step.values.end(), is_pixels))
            step.values.emplace_back("pixels", size_of(step.painted));
    }

    void add_pixels(const Piece& piece, std::vector<Painted>& painted) const {
        const Polygon& polygon = input_.polygons[piece.polygon];
        if (!piece.cuts.empty() && !bends_one_way(piece.parts.front()))
            throw Error("the outline of '" + piece.name +
                        "' is not convex; expected convex lists of points, or 'painted'");
        for (const Run& run : runs_of(piece, polygon, input_.subpixel_bits(), input_.window()))
            painted.push_back({run, polygon.id});
    }

    const Input& input_;
    std::map<std::uint32_t, std::size_t> index_of_;    ///< by identifier
    std::map<std::string, std::vector<Piece>> known_;  ///< by name; convex if drawn by outline
    std::size_t drawn_ = 0;
    bool has_header_ = false, ended_ = false;
};

}  // namespace

std::string polygons_json(const Input& input, const std::map<std::uint32_t, std::string>& colors) {
    Json json = Json::parse(log_header(input, {.in_world = true}, colors));
    for (const char* member : {"words", "algorithm", "title", "level", "draws", "decides"})
        json.erase(member);
    json["log"] = "gw hidden polygons";
    const Json polygons = std::move(json["polygons"]);
    json.erase("polygons");
    std::string text = json.dump();
    text.back() = ',';
    text += "\n\"polygons\": [";
    for (const Json& polygon : polygons)
        text += (&polygon == &polygons[0] ? "\n" : ",\n") + polygon.dump();
    return text + "\n]}\n";
}

Play read_play(const Input& input, const std::string& file, const std::string& text) {
    Player player(input);
    Play play;
    std::istringstream lines(text);
    int number = 0;
    try {
        for (std::string line; std::getline(lines, line);) {
            number += 1;
            if (line.find_first_not_of(" \t\r") != line.npos) player.read(line, play);
        }
        player.check_end(play);
    } catch (const Error& error) {
        throw Error(file, number, error.what());
    }
    return play;
}

Algorithm played(Play play) {
    return {.name = "played",
            .title = "Steps of a program",
            .in_world = true,
            .run = [play = std::move(play)](const Input& input, StepLog& log) {
                Output output{.list = begin_picture(input, "played"), .pieces = play.pieces};
                Counts& counts = output.counts;
                log.watch(watched(counts));
                for (Step step : play.steps) {
                    counts.sorts += step.action == Action::Sort ? 1 : 0;
                    counts.splits += step.action == Action::Split ? 1 : 0;
                    counts.spans += step.painted.size();
                    for (const auto& [name, count] : std::exchange(step.counts, {})) {
                        std::uint64_t& counter = counts.*counter_named(name);
                        counter = std::max(counter, count);
                    }
                    add_painted(output.list, step.painted);
                    log.add(std::move(step));
                }
                return output;
            }};
}

std::vector<PolygonGrade> grades_of(const Result& result,
                                    const std::vector<std::uint32_t>& z_buffer) {
    std::map<std::uint32_t, PolygonGrade> by_id;
    for (std::size_t i = 0; i < z_buffer.size(); ++i) {
        PolygonGrade& expected = by_id[z_buffer[i]];
        PolygonGrade& shown = by_id[result.ids[i]];
        expected.expected += 1;
        shown.shown += 1;
        const bool wrong = result.difference[i] == Difference::Wrong;
        expected.missing += wrong ? 1 : 0;
        shown.extra += wrong ? 1 : 0;
    }
    std::vector<PolygonGrade> grades;
    for (auto& [id, grade] : by_id) {
        grade.id = id;
        grades.push_back(grade);
    }
    return grades;
}

}  // namespace gw::hiddensurface
