#include "hiddensurface/quiz/quiz_drawing.h"

#include "gw/base/elementary.h"
#include "gw/machine.h"
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/lines/window_lines.h"
#include "hiddensurface/run/compare.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace gw::hiddensurface {

namespace {

constexpr const char* marked_color = "#c2007a";

/// A question's scene as the machine draws it.
struct DrawnQuestion {
    explicit DrawnQuestion(const Question& question)
        : view(scene::make_view(question.scene, quiz_width, quiz_height)),
          input(make_input(question.scene, view, vgx())) {
        const auto machine = make_fast(vgx(), quiz_width, quiz_height, {.threads = 1});
        StepLog none;
        ids = run_on(*machine, algorithm_named("z-buffer"), input, none).ids;
    }
    DrawnQuestion(const DrawnQuestion&) = delete;
    double unit() const { return double(1 << input.subpixel_bits()); }

    scene::View view;
    Input input;
    std::vector<std::uint32_t> ids;
};

/// Each identifier's pixels as one path of rectangles, row by row.
std::string surfaces(const DrawnQuestion& drawn) {
    std::map<std::uint32_t, std::string> paths;
    for (int y = 0; y < quiz_height; ++y)
        for (int x = 0; x < quiz_width;) {
            const std::uint32_t id = drawn.ids[drawn.view.index(x, y)];
            int end = x;
            while (end < quiz_width && drawn.ids[drawn.view.index(end, y)] == id) ++end;
            if (id != 0)
                paths[id] +=
                    fmt::format("M{} {}h{}v1h-{}z", x, quiz_height - 1 - y, end - x, end - x);
            x = end;
        }
    const auto colors = hex_colors(drawn.input);
    std::string svg = "<g shape-rendering=\"crispEdges\">";
    for (const auto& [id, path] : paths)
        svg +=
            fmt::format("<path fill=\"{}\" fill-opacity=\"0.55\" d=\"{}\"/>", colors.at(id), path);
    return svg + "</g>";
}

/// Every polygon's sides by the faces before them, exactly; `hides`: whether hidden parts are broken.
std::string sides(const DrawnQuestion& drawn, bool hides) {
    const WindowLines lines = window_lines(drawn.input);
    std::string seen, hidden;
    const auto add = [&](std::string& to, const GridPoint& a, const GridPoint& b,
                         const Part& part) {
        const auto at = [&](double t) {
            const double x = double(a.x) + t * double(b.x - a.x),
                         y = double(a.y) + t * double(b.y - a.y);
            return fmt::format("{:.2f} {:.2f}", x / drawn.unit(), quiz_height - y / drawn.unit());
        };
        to += "M" + at(part.first) + "L" + at(part.second);
    };
    for (const WindowSide& side : lines.sides) {
        if (!side.drawn) continue;
        const GridPoint &a = lines.corners[side.a], &b = lines.corners[side.b];
        std::vector<Part> covered;
        if (hides)
            for (const WindowFace& face : lines.faces)
                if (const auto part = hidden_part(lines, face, a, b)) covered.push_back(*part);
        const auto visible = rest_of(covered);
        std::vector<Part> others = visible;
        for (const Part& part : visible) add(seen, a, b, part);
        for (const Part& part : rest_of(others)) add(hidden, a, b, part);
    }
    return fmt::format(
        "<path class=\"hidden\" fill=\"none\" stroke=\"#333\" stroke-width=\"0.7\" "
        "stroke-dasharray=\"3 2.4\" d=\"{}\"/>"
        "<path fill=\"none\" stroke=\"#000\" stroke-width=\"1.1\" stroke-linejoin=\"round\" "
        "d=\"{}\"/>",
        hidden, seen);
}

std::string text_at(double x, double y, double size, const std::string& text,
                    const char* color = "#000") {
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"middle\" "
        "font-family=\"sans-serif\" fill=\"{}\" stroke=\"#fff\" stroke-width=\"2.5\" "
        "paint-order=\"stroke\">{}</text>",
        x, y, size, color, text);
}

/// The distance of each pixel, along its row and column, to another polygon's pixel, the border or
/// the question's mark.
std::vector<int> clearance_of(const std::vector<std::uint32_t>& ids, const Question& question) {
    constexpr int beside_a_mark = 10;
    std::vector<int> clearance(ids.size(), quiz_width);
    const auto is_marked = [&](int x, int y) {
        return (question.row && std::abs(y - *question.row) < beside_a_mark) ||
               (question.point &&
                glm::length(glm::dvec2(x - question.point->x, y - question.point->y)) <
                    1.5 * beside_a_mark);
    };
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        std::vector<int> reach(ids.size());
        for (int k = 0; k < int(ids.size()); ++k) {
            // The neighbour at `behind` comes first.
            const int i = dx + dy > 0 ? k : int(ids.size()) - 1 - k;
            const int x = i % quiz_width - dx, y = i / quiz_width - dy;
            const bool inside = x >= 0 && y >= 0 && x < quiz_width && y < quiz_height;
            const auto at = std::size_t(i), behind = std::size_t(y * quiz_width + x);
            if (inside && ids[behind] == ids[at] && !is_marked(x, y)) reach[at] = reach[behind] + 1;
            clearance[at] = std::min(clearance[at], reach[at]);
        }
    }
    return clearance;
}

/// Each polygon's number at its visible pixel with the largest clearance.
std::string numbers(const DrawnQuestion& drawn, const Question& question,
                    std::vector<dvec2>& taken) {
    const std::vector<int> clearance = clearance_of(drawn.ids, question);
    std::map<std::uint32_t, std::size_t> widest;
    for (std::size_t i = 0; i < drawn.ids.size(); ++i) {
        const auto [at, is_new] = widest.try_emplace(drawn.ids[i], i);
        if (clearance[i] > clearance[at->second]) at->second = i;
    }
    widest.erase(0);
    std::string svg;
    for (const auto& [id, i] : widest) {
        const dvec2 place(double(i % quiz_width) + 0.5, quiz_height - double(i / quiz_width) + 4.5);
        taken.push_back(place - dvec2(0, 2));  // of larger letters
        svg += text_at(place.x, place.y, 15, std::to_string(id));
    }
    return svg;
}

/// Beside a corner, outwards, or turned from there, or farther, until no other label is near.
dvec2 free_place(const dvec2& corner, const dvec2& outwards, const std::vector<dvec2>& taken) {
    constexpr double step = 0.4;
    constexpr int turns = 16;
    const double first = gw::atan2(outwards.y, outwards.x);
    dvec2 place(0);
    for (int k = 0; k < 2 * turns; ++k) {
        const double reach = k < turns ? 9 : 16;
        const int i = k % turns;
        const double angle = first + step * (i % 2 == 0 ? i / 2 : -(i + 1) / 2);
        place = {std::clamp(corner.x + reach * gw::cos(angle), 8.0, quiz_width - 8.0),
                 std::clamp(corner.y + reach * gw::sin(angle) + 3, 9.0, quiz_height - 3.0)};
        const bool is_free = std::ranges::none_of(taken, [&](const dvec2& other) {
            return std::abs(other.x - place.x) < 12 && std::abs(other.y - place.y) < 11;
        });
        if (is_free) break;
    }
    return place;
}

std::string names_of(const std::vector<QuizCorner>& corners, std::vector<dvec2> taken) {
    std::map<std::uint32_t, std::pair<dvec2, int>> middles;
    for (const QuizCorner& corner : corners) {
        auto& [sum, count] = middles[corner.polygon];
        sum += dvec2(corner.x, corner.y);
        count += 1;
    }
    std::string svg;
    for (const QuizCorner& corner : corners) {
        const auto& [sum, count] = middles.at(corner.polygon);
        const dvec2 label = free_place(dvec2(corner.x, corner.y),
                                       dvec2(corner.x, corner.y) - sum / double(count), taken);
        taken.push_back(label);
        svg += text_at(label.x, label.y, 8.5, corner.name, "#444");
    }
    return svg;
}

std::string marks(const Question& question) {
    std::string svg;
    if (question.row)
        svg += fmt::format("<path stroke=\"{}\" stroke-width=\"1.2\" d=\"M0 {:.1f}H{}\"/>",
                           marked_color, quiz_height - *question.row - 0.5, quiz_width);
    if (question.point) {
        const double x = question.point->x, y = quiz_height - question.point->y;
        svg += fmt::format(
            "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"none\" stroke=\"#fff\" "
            "stroke-width=\"4\"/>"
            "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"none\" stroke=\"{2}\" "
            "stroke-width=\"1.6\"/><circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"1.2\" fill=\"{2}\"/>",
            x, y, marked_color);
    }
    return svg;
}

}  // namespace

std::vector<QuizCorner> corners_of(const Question& question) {
    std::vector<QuizCorner> corners;
    if (!question.needs_corners) return corners;
    const scene::View view = scene::make_view(question.scene, quiz_width, quiz_height);
    const Input input = make_input(question.scene, view, vgx());
    const double unit = double(1 << input.subpixel_bits());
    const double farthest = double((std::int64_t{1} << input.profile.depth_bits) - 1);
    // Rounded here, once: all that print them show the same digits.
    const auto tenths = [](double pixels) { return std::round(pixels * 10) / 10; };
    for (const Polygon& polygon : input.polygons) {
        char letter = 'a';
        for (const Facet& facet : polygon.facets)
            for (const Loop& loop : facet.parts)
                for (const dvec3& p : loop)
                    corners.push_back({polygon.id, fmt::format("{}{}", polygon.id, letter++),
                                       tenths(p.x / unit), tenths(quiz_height - p.y / unit),
                                       p.z / farthest});
    }
    return corners;
}

Bilingual drawing_in_words(const Question& question) {
    const std::size_t count = question.scene.objects.size();
    Bilingual words{fmt::format("A drawing of {} polygons.", count),
                    fmt::format("ポリゴン {} 枚の図。", count)};
    if (question.point) {
        const double x = question.point->x, y = quiz_height - question.point->y;
        words.en += fmt::format(" The mark is at x {:.1f}, y {:.1f}.", x, y);
        words.ja += fmt::format("印は x {:.1f}、y {:.1f} にあります。", x, y);
    }
    if (question.row) {
        const int y = quiz_height - 1 - *question.row;
        words.en += fmt::format(" The marked scan line is {}.", y);
        words.ja += fmt::format("印の走査線は {} です。", y);
    }
    return words;
}

std::string drawing_of(const Question& question, const std::string& spoken) {
    const DrawnQuestion drawn(question);
    const bool only_sides = question.kind == "facing";
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
        "aria-label=\"{2}\">"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\" stroke=\"#999\"/>",
        quiz_width, quiz_height, spoken);
    if (!only_sides) svg += surfaces(drawn);
    svg += sides(drawn, !only_sides);
    std::vector<dvec2> taken;
    if (!only_sides) svg += numbers(drawn, question, taken);
    svg += names_of(corners_of(question), taken);
    return svg + marks(question) + "</svg>";
}

}  // namespace gw::hiddensurface
