// A question is drawn until it is worth asking: at most so many scenes are tried.
#include "hiddensurface/quiz/quiz.h"

#include "gw/error.h"
#include "gw/machine.h"
#include "hiddensurface/compare.h"
#include "hiddensurface/lines/window_lines.h"
#include "hiddensurface/normal.h"
#include "hiddensurface/quiz/coverage.h"
#include "hiddensurface/quiz/quiz_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace gw::hiddensurface {

namespace {

constexpr int most_tries = 400;

struct Stage {
    explicit Stage(const scene::Scene& scene)
        : view(scene::make_view(scene, quiz_width, quiz_height)), input(make_input(scene, view, vgx())) {}
    Stage(const Stage&) = delete;
    scene::View view;
    Input input;

    Result run(const std::string& name) const {
        const auto machine = make_fast(vgx(), quiz_width, quiz_height, {.threads = 1});
        StepLog none;
        return run_on(*machine, algorithm_named(name), input, none);
    }
    std::vector<Step> steps(const std::string& name, Level finest) const {
        StepLog log(finest);
        algorithm_named(name).run(input, log);
        return log.steps();
    }
    std::size_t pixel(int x, int y) const { return std::size_t(y) * quiz_width + std::size_t(x); }
};

std::string words_of(const std::vector<std::uint32_t>& ids) {
    std::string text;
    for (const std::uint32_t id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
    return text;
}

using Maker = std::optional<Question> (*)(QuizRandom&);

/// Pixels that have the same polygons over them and show the same one: how many.
using PixelGroups = std::map<std::pair<std::vector<std::uint32_t>, std::uint32_t>, std::size_t>;

/// Pixels that differ when the polygons are painted in this order.
std::size_t wrong_pixels(const std::vector<std::uint32_t>& order, const PixelGroups& groups) {
    std::size_t wrong = 0;
    for (const auto& [group, pixels] : groups) {
        const auto& [over, expected] = group;
        std::uint32_t shown = 0;
        for (auto id = order.rbegin(); id != order.rend() && shown == 0; ++id)
            if (std::count(over.begin(), over.end(), *id) > 0) shown = *id;
        wrong += shown != expected ? pixels : 0;
    }
    return wrong;
}

/// Four orders, one of them right. A right one may be wrong by a few pixels of rounding, a wrong one is
/// plainly so.
std::optional<Question> ask_order(QuizRandom& random) {
    constexpr std::size_t rounding = 2, plain = 150;
    Question q{.scene = tilted_polygons(random, 4, 4)};
    const Stage stage(q.scene);
    const auto over = polygons_over(stage.input);
    const auto expected = stage.run("z-buffer").ids;
    PixelGroups groups;
    for (std::size_t i = 0; i < over.size(); ++i) groups[{over[i], expected[i]}] += 1;
    std::vector<std::uint32_t> order{1, 2, 3, 4};
    std::vector<std::string> right, wrong;
    do {
        const std::size_t pixels = wrong_pixels(order, groups);
        if (pixels <= rounding) right.push_back(words_of(order));
        if (pixels >= plain) wrong.push_back(words_of(order));
    } while (std::next_permutation(order.begin(), order.end()));
    if (right.empty() || right.size() > 6 || wrong.size() < 3) return std::nullopt;
    const auto take = [&](std::vector<std::string>& from) {
        const auto at = from.begin() + random.whole(0, int(from.size()) - 1);
        const std::string taken = *at;
        from.erase(at);
        return taken;
    };
    const std::string chosen = take(right);
    q.choices = {take(wrong), take(wrong), take(wrong)};
    const int place = random.whole(0, 3);
    q.choices.insert(q.choices.begin() + place, chosen);
    q.kind = "order";
    q.text =
        "The polygons are painted one over the other, the first of the order first. Which of these orders "
        "gives the "
        "picture?";
    q.answer = std::string(1, char('a' + place));
    q.why = "Painted in the order " + chosen +
            " no polygon covers one that lies before it; the other orders differ from the "
            "Z-buffer's picture in 150 pixels and more.";
    return q;
}

/// Which of Newell's tests decides: the first in the log that says yes about the first pair.
std::optional<Question> ask_test(QuizRandom& random) {
    const char wanted = char('0' + random.whole(1, 6));
    for (int i = 0; i < 60; ++i) {
        Question q{.scene = tilted_polygons(random, 2, 3, 0.6)};
        const Stage stage(q.scene);
        char decides = 0;
        std::vector<std::uint32_t> pair;
        for (const Step& step : stage.steps("newell", Level::Polygon)) {
            if (step.action != Action::Compare || step.test.size() < 2 || step.test[1] != ':') continue;
            if (pair.empty()) pair = step.polygons;
            if (step.test[0] <= decides) break;  // the next pair
            decides = step.test[0];
            if (step.result == "disjoint" || step.result == "yes") break;
            if (decides == '5') decides = '6';
        }
        if (decides != wanted || pair.size() != 2) continue;
        q.kind = "test";
        q.text = fmt::format(
            "Polygon {} reaches farthest. By which of Newell's tests may it be drawn before polygon {}? The "
            "tests "
            "are asked in this order; name the first that says yes.",
            pair[0], pair[1]);
        q.choices = {"1: their x extents are disjoint",
                     "2: their y extents are disjoint",
                     fmt::format("3: all of {} lies behind the plane of {}", pair[0], pair[1]),
                     fmt::format("4: all of {} lies before the plane of {}", pair[1], pair[0]),
                     "5: their projections are disjoint",
                     "none of the five"};
        q.answer = std::string(1, char('a' + (wanted - '1')));
        q.why =
            wanted == '6'
                ? "All five say no: the other must be drawn first, or one is cut by the plane of the other."
                : fmt::format("Test {} is the first that says yes.", wanted);
        return q;
    }
    return std::nullopt;
}

std::optional<Question> ask_pieces(QuizRandom& random) {
    Question q{.scene = tilted_polygons(random, 3, 3)};
    const Stage stage(q.scene);
    const Result newell = stage.run("newell");
    if (newell.counts.splits == 0 || newell.counts.splits > 3 || newell.counts.undecided > 0)
        return std::nullopt;
    for (const std::uint32_t id : {1u, 2u, 3u})
        if (std::count(newell.ids.begin(), newell.ids.end(), id) < 200) return std::nullopt;
    q.kind = "pieces";
    q.text =
        "Newell, Newell and Sancha's algorithm draws these three triangles, cutting one by the plane of "
        "another only where neither "
        "may be drawn first. How many pieces does it draw? Answer with a number.";
    q.answer = std::to_string(newell.pieces.size());
    q.why = fmt::format("Cuts of the 3 triangles: {}.", newell.counts.splits);
    return q;
}

std::string corners_of(const Polygon& polygon) {
    std::string text;
    for (const dvec3& p : polygon.world) text += fmt::format(" ({:g}, {:g}, {:g})", p.x, p.y, p.z);
    return text;
}

std::optional<Question> ask_facing(QuizRandom& random) {
    Question q{.scene = whole_number_solid(random)};
    const Stage stage(q.scene);
    const dvec4 eye = eye_of(stage.view);
    std::vector<std::uint32_t> back;
    q.text = fmt::format(
        "The eye is at ({:g}, {:g}, {:g}). Which faces of this solid look away from it, by the sign of D_f? "
        "Corners run "
        "counter-clockwise seen from outside:",
        eye.x, eye.y, eye.z);
    for (const Polygon& polygon : stage.input.polygons) {
        const double d_f = facing(eye, polygon.world[0], polygon_normal(polygon.world));
        if (d_f == 0) return std::nullopt;
        if (d_f < 0) back.push_back(polygon.id);
        q.text += fmt::format(" {}:{};", polygon.id, corners_of(polygon));
    }
    if (back.size() < 2) return std::nullopt;
    q.kind = "facing";
    q.text.back() = '.';
    q.text += " Answer with their numbers.";
    q.answer = words_of(back);
    q.why = "D_f = (P_E - P_i).N is below 0 for these.";
    return q;
}

/// How often the Z-buffer writes a pixel, drawing in the order of the numbers.
std::optional<Question> ask_writes(QuizRandom& random) {
    std::vector<int> distances;
    Question q{.scene = facing_rectangles(random, 5, distances)};
    const Stage stage(q.scene);
    const auto over = polygons_over(stage.input);
    const Result z_buffer = stage.run("z-buffer");
    const int x = random.whole(60, quiz_width - 60), y = random.whole(50, quiz_height - 50);
    const std::size_t at = stage.pixel(x, y);
    if (over[at].size() < 3 || z_buffer.writes[at] < 2) return std::nullopt;
    // Not beside an edge, or the picture does not tell.
    for (const int dx : {-5, 0, 5})
        for (const int dy : {-5, 0, 5})
            if (over[stage.pixel(x + dx, y + dy)] != over[at]) return std::nullopt;
    q.kind = "writes";
    q.text = "Rectangles face the eye, at distances";
    for (std::size_t i = 0; i < distances.size(); ++i)
        q.text += fmt::format("{} {} (number {})", i == 0 ? "" : ",", distances[i], i + 1);
    q.text += fmt::format(
        ". The Z-buffer draws them in the order of their numbers. Rectangles {} lie over the marked pixel. "
        "How often is it "
        "written? Answer with a number.",
        words_of(over[at]));
    q.point = dvec2(x + 0.5, y + 0.5);
    q.answer = std::to_string(z_buffer.writes[at]);
    q.why = "Each that is nearer than all before it is written.";
    return q;
}

std::optional<Question> ask_spans(QuizRandom& random) {
    Question q{.scene = tilted_polygons(random, 3, 3)};
    const Stage stage(q.scene);
    const int row = random.whole(60, quiz_height - 60);
    int spans = 0, shortest = quiz_width;
    for (const Step& step : stage.steps("scan-line", Level::Span)) {
        if (step.action != Action::Compare || step.level != Level::Span || step.row != row ||
            step.before.empty())
            continue;
        spans += 1;
        shortest = std::min(shortest, int(step.before[0].back().x - step.before[0].front().x));
    }
    if (spans < 3 || shortest < 6) return std::nullopt;
    q.kind = "spans";
    q.text =
        "On the marked scan line the segments of the triangles begin and end; their ends, sorted in x, "
        "divide it into sample spans. "
        "How many of these have at least one triangle over them? Hidden segments count. Answer with a "
        "number.";
    q.row = row;
    q.answer = std::to_string(spans);
    q.why = "Between neighbouring ends, hidden or not.";
    return q;
}

/// Appel's number in the middle of a side.
std::optional<Question> ask_invisibility(QuizRandom& random) {
    Question q{.scene = tilted_polygons(random, 5, 3)};
    const Stage stage(q.scene);
    const WindowLines lines = window_lines(stage.input);
    const WindowSide& side = lines.sides[std::size_t(random.whole(0, int(lines.sides.size()) - 1))];
    const GridPoint &a = lines.corners[side.a], &b = lines.corners[side.b];
    int number = 0;
    for (const WindowFace& face : lines.faces) {
        const auto part = hidden_part(lines, face, a, b);
        if (!part || part->second < 0.4 || part->first > 0.6) continue;
        if (part->first > 0.42 || part->second < 0.58) return std::nullopt;  // changes too near
        number += 1;
    }
    if (number == 0 || !side.drawn) return std::nullopt;
    const double unit = double(1 << stage.input.subpixel_bits());
    q.point = dvec2(double(a.x + b.x) / 2 / unit, double(a.y + b.y) / 2 / unit);
    if (q.point->x < 10 || q.point->y < 10 || q.point->x > quiz_width - 10 || q.point->y > quiz_height - 10)
        return std::nullopt;
    q.kind = "invisibility";
    q.text = fmt::format(
        "The marked point is the middle of a side of triangle {} (sides are drawn through). What is its "
        "quantitative "
        "invisibility: how many triangles hide it? The scene's files have the coordinates. Answer with a "
        "number.",
        side.id);
    q.answer = std::to_string(number);
    q.why = "So many triangles lie before the point.";
    return q;
}

struct Kind {
    const char* name;
    Maker make;
};
constexpr Kind kinds[] = {{"order", ask_order},
                          {"test", ask_test},
                          {"pieces", ask_pieces},
                          {"facing", ask_facing},
                          {"writes", ask_writes},
                          {"spans", ask_spans},
                          {"invisibility", ask_invisibility}};

Question make_question(const Kind& kind, std::uint32_t seed, std::uint32_t number) {
    QuizRandom random(seed, number);
    for (int i = 0; i < most_tries; ++i)
        if (auto question = kind.make(random)) return std::move(*question);
    throw Error(fmt::format("quiz: no scene for question {} ({}) of seed {}; expected one in {} tries",
                            number, kind.name, seed, most_tries));
}

}  // namespace

const std::vector<std::string>& quiz_kinds() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Kind& kind : kinds) all.push_back(kind.name);
        return all;
    }();
    return names;
}

std::vector<Question> make_quiz(std::uint32_t seed, int count, const std::string& kind) {
    std::vector<Question> quiz;
    for (int i = 0; i < count; ++i) {
        std::size_t k = std::size_t(i) % std::size(kinds);
        if (!kind.empty())
            k = std::size_t(std::find(quiz_kinds().begin(), quiz_kinds().end(), kind) - quiz_kinds().begin());
        if (k >= std::size(kinds))
            throw Error("quiz: unknown kind '" + kind + "'; expected one of quiz_kinds()");
        quiz.push_back(make_question(kinds[k], seed, std::uint32_t(i + 1)));
    }
    return quiz;
}

std::string canonical_answer(const std::string& text) {
    std::string clean;
    for (const char c : text) {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == ';';
        clean += blank ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
    }
    std::istringstream words(clean);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    std::stable_sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    std::string out;
    for (const std::string& word : all) out += (out.empty() ? "" : " ") + word;
    return out;
}

}  // namespace gw::hiddensurface
