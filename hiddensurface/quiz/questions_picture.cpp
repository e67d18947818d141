// Questions about faces, pixels, scan lines and lines.
#include "hiddensurface/lines/window_lines.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/quiz/questions.h"
#include "hiddensurface/run/compare.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::hiddensurface {
namespace {

std::string corners_of(const Polygon& polygon) {
    std::string text;
    for (const dvec3& p : polygon.world) text += fmt::format(" ({:g}, {:g}, {:g})", p.x, p.y, p.z);
    return text;
}

/// The step of Appel's algorithm that draws this side, from either end.
std::size_t step_of_side(const Input& input, const GridPoint& a, const GridPoint& b) {
    StepLog log(Level::Polygon);
    line_algorithm_named("appel")->run(input, log);
    const auto is_at = [](const dvec3& p, const GridPoint& q) {
        return p.x == double(q.x) && p.y == double(q.y);
    };
    for (std::size_t i = 0; i < log.steps().size(); ++i) {
        const auto& line = log.steps()[i].line;
        if (!line) continue;
        if ((is_at(line->a, a) && is_at(line->b, b)) || (is_at(line->a, b) && is_at(line->b, a)))
            return i + 1;
    }
    return 1;
}

}  // namespace

std::optional<Question> ask_facing(QuizRandom& random) {
    Question q;
    q.scene = whole_number_solid(random);
    const QuestionContext context(q.scene);
    const dvec4 eye = eye_of(context.view);
    std::vector<std::uint32_t> back;
    q.text = {
        fmt::format(
            "The eye is at ({:g}, {:g}, {:g}). Which faces of this solid look away from it, by the sign of "
            "D_f? Corners run counter-clockwise seen from outside:",
            eye.x, eye.y, eye.z),
        fmt::format(
            "視点は ({:g}, {:g}, {:g}) にあります。D_f "
            "の符号によると、この立体のどの面が視点に背を向けていますか。頂点は外から見て反時計回りに"
            "並んでいます。",
            eye.x, eye.y, eye.z)};
    for (const Polygon& polygon : context.input.polygons) {
        const double d_f = facing(eye, polygon.world[0], polygon_normal(polygon.world));
        if (d_f == 0) return std::nullopt;
        if (d_f < 0) back.push_back(polygon.id);
        for (std::string* text : {&q.text.en, &q.text.ja})
            *text += fmt::format(" {}:{};", polygon.id, corners_of(polygon));
    }
    if (back.size() < 2) return std::nullopt;
    q.kind = "facing";
    q.text.en.back() = '.';
    q.text.en += " Answer with their numbers.";
    q.text.ja.pop_back();
    q.text.ja += "。番号で答えなさい。";
    q.answer = words_of(back);
    q.among = int(context.input.polygons.size());
    q.why = {"D_f = (P_E - P_i).N is below 0 for these.",
             "これらの面では D_f = (P_E - P_i)・N が負になります。"};
    q.decided = {.algorithm = "back-face"};
    std::size_t number = 0;
    for (const Step& step : context.steps("back-face", Level::Polygon)) {
        ++number;
        if (step.test == "facing" && step.result == "back") q.decided.step = number;
    }
    return q;
}

std::optional<Question> ask_writes(QuizRandom& random) {
    std::vector<int> distances;
    Question q;
    q.scene = facing_rectangles(random, 5, distances);
    const QuestionContext context(q.scene);
    const auto over = polygons_over(context.input);
    const Result z_buffer = context.run("z-buffer");
    const int x = random.whole(60, quiz_width - 60), y = random.whole(50, quiz_height - 50);
    const std::size_t at = context.pixel(x, y);
    if (over[at].size() < 3 || z_buffer.writes[at] < 2) return std::nullopt;
    // Not beside an edge, where the picture would not show the answer.
    for (const int dx : {-5, 0, 5})
        for (const int dy : {-5, 0, 5})
            if (over[context.pixel(x + dx, y + dy)] != over[at]) return std::nullopt;
    q.kind = "writes";
    std::string list;
    for (std::size_t i = 0; i < distances.size(); ++i)
        list += fmt::format("{}{}: {}", i == 0 ? "" : ", ", i + 1, distances[i]);
    q.text = {
        fmt::format(
            "Rectangles face the eye, at distances (number: distance) {}. The Z-buffer draws "
            "them in the order of their numbers. Rectangles {} lie over the marked pixel. How "
            "often is it written? Answer with a number.",
            list, words_of(over[at])),
        fmt::format("長方形は視点に正対し、距離は(番号: 距離){} です。Zバッファは"
                    "番号の順に描きます。印の画素には長方形 {} "
                    "が重なっています。この画素は何回書き込まれますか。数で答えなさい。",
                    list, words_of(over[at]))};
    q.point = dvec2(x + 0.5, y + 0.5);
    q.answer = std::to_string(z_buffer.writes[at]);
    q.why = {"A rectangle that is nearer than all before it is written.",
             "それまでのどれよりも近い長方形が来るたびに書き込まれます。"};
    q.decided = {.algorithm = "z-buffer", .step = z_buffer.ids[at]};
    return q;
}

std::optional<Question> ask_spans(QuizRandom& random) {
    Question q;
    q.scene = tilted_polygons(random, 3, 3);
    const QuestionContext context(q.scene);
    const int row = random.whole(60, quiz_height - 60);
    int spans = 0, shortest = quiz_width;
    std::size_t number = 0, last = 1;
    for (const Step& step : context.steps("scan-line", Level::Span)) {
        ++number;
        if (step.test != "span" || step.window.y != row) continue;
        spans += 1;
        last = number;
        shortest = std::min(shortest, step.window.width);
    }
    if (spans < 3 || shortest < 6) return std::nullopt;
    q.kind = "spans";
    q.text = {
        "On the marked scan line the segments of the triangles begin and end; their ends, sorted in x, "
        "divide it into sample spans. How many of these have at least one triangle over them? Hidden "
        "segments count. Answer with a number.",
        "印の走査線の上で、三角形の線分が始まり、終わります。その端を x "
        "の順にソートすると、走査線はサンプルスパンに分かれます。三角形が一つ以上重なるサンプルスパンはいくつ"
        "ですか。隠れた線分も数えます。数で答えなさい。"};
    q.row = row;
    q.answer = std::to_string(spans);
    q.why = {"Between neighbouring ends, hidden or not.",
             "隠れていてもいなくても、隣り合う端の間が一つのサンプルスパンです。"};
    q.decided = {.algorithm = "scan-line", .level = Level::Span, .step = last};
    return q;
}

std::optional<Question> ask_invisibility(QuizRandom& random) {
    Question q;
    q.scene = tilted_polygons(random, 5, 3);
    const QuestionContext context(q.scene);
    const WindowLines lines = window_lines(context.input);
    const WindowSide& side = lines.sides[std::size_t(random.whole(0, int(lines.sides.size()) - 1))];
    const GridPoint &a = lines.corners[side.a], &b = lines.corners[side.b];
    int number = 0;
    for (const WindowFace& face : lines.faces) {
        const auto part = hidden_part(lines, face, a, b);
        if (!part || part->second < 0.4 || part->first > 0.6) continue;
        if (part->first > 0.42 || part->second < 0.58)
            return std::nullopt;  // changes near the middle
        number += 1;
    }
    if (number == 0 || !side.drawn) return std::nullopt;
    const double unit = double(1 << context.input.subpixel_bits());
    q.point = dvec2(double(a.x + b.x) / 2 / unit, double(a.y + b.y) / 2 / unit);
    if (q.point->x < 10 || q.point->y < 10 || q.point->x > quiz_width - 10 ||
        q.point->y > quiz_height - 10)
        return std::nullopt;
    q.kind = "invisibility";
    q.text = {
        fmt::format(
            "The marked point is the middle of a side of triangle {} (hidden parts of sides are broken "
            "lines). What is its quantitative invisibility: how many triangles hide it? Answer with a "
            "number.",
            side.id),
        fmt::format(
            "印の点は、三角形 {} "
            "の辺の中点です(辺の隠れた部分は破線です)。この点の不可視度、すなわちこの点を隠す三角形の数は"
            "いくつですか。数で答えなさい。",
            side.id)};
    q.answer = std::to_string(number);
    q.why = {"That many triangles lie before the point.",
             "この数の三角形が、印の点より手前にあります。"};
    q.decided = {.algorithm = "appel", .step = step_of_side(context.input, a, b)};
    q.needs_corners = true;
    return q;
}

}  // namespace gw::hiddensurface
