// Questions about orders: painting, Newell's tests and pieces.
#include "hiddensurface/quiz/questions.h"
#include "hiddensurface/run/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gw::hiddensurface {
namespace {

/// The number of pixels for each set of polygons over a pixel and the polygon that it shows.
using PixelGroups = std::map<std::pair<std::vector<std::uint32_t>, std::uint32_t>, std::size_t>;

/// The number of pixels that differ if the polygons are painted in this order.
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

}  // namespace

std::string words_of(const std::vector<std::uint32_t>& ids) {
    std::string text;
    for (const std::uint32_t id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
    return text;
}

/// One of four orders is right. A right one may differ in a few pixels by rounding; a wrong one
/// differs in many.
std::optional<Question> ask_order(QuizRandom& random) {
    constexpr std::size_t rounding = 2, plain = 150;
    Question q;
    q.scene = tilted_polygons(random, 4, 4);
    const QuestionContext context(q.scene);
    const auto over = polygons_over(context.input);
    const auto expected = context.run("z-buffer").ids;
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
    std::vector<std::string> orders{take(wrong), take(wrong), take(wrong)};
    const int place = random.whole(0, 3);
    orders.insert(orders.begin() + place, chosen);
    for (const std::string& one : orders) q.choices.push_back({one, one});
    q.kind = "order";
    q.text = {
        "The polygons are painted one over the other, the first of the order first. Which of these orders "
        "gives the picture?",
        "ポリゴンを、並べた順に重ねて塗ります。図のとおりになるのはどの順ですか。"};
    q.answer = std::string(1, char('a' + place));
    q.why = {
        "Painted in the order " + chosen +
            " no polygon covers one that lies before it; the other orders differ from the "
            "Z-buffer's picture in 150 pixels or more.",
        chosen +
            " の順に塗れば、手前のポリゴンが後から塗りつぶされることはありません。ほかの順では、"
            "Zバッファの画像と 150 画素以上が異なります。"};
    q.decided = {.algorithm = "newell", .step = context.steps("newell", Level::Polygon).size()};
    return q;
}

/// The answer is the first test in the log that says yes about the first pair.
std::optional<Question> ask_test(QuizRandom& random) {
    const char wanted = char('0' + random.whole(1, 6));
    for (int i = 0; i < 60; ++i) {
        Question q;
        q.scene = tilted_polygons(random, 2, 3, 0.6);
        const QuestionContext context(q.scene);
        char decides = 0;
        std::vector<std::string> pair;
        std::size_t number = 0, deciding = 1;
        for (const Step& step : context.steps("newell", Level::Polygon)) {
            ++number;
            if (step.action != Action::Compare || step.test.size() < 2 || step.test[1] != '-')
                continue;
            if (step.test[0] < '1' || step.test[0] > '5') continue;
            if (pair.empty()) pair = step.pieces;
            if (step.test[0] <= decides) break;  // the next pair
            decides = step.test[0];
            deciding = number;
            if (step.result == "yes") break;
            if (decides == '5') decides = '6';
        }
        if (decides != wanted || pair.size() != 2) continue;
        q.kind = "test";
        const std::string &first = pair[0], &second = pair[1];
        q.text = {
            fmt::format(
                "Polygon {} reaches farthest. By which of Newell's tests may it be drawn before polygon {}? "
                "The tests are asked in this order; name the first that says yes.",
                first, second),
            fmt::format(
                "ポリゴン {} が最も遠くまで届きます。これをポリゴン {} "
                "より先に描いてよいことは、Newell のどの判定で分かりますか。判定はこの順に行い"
                "ます。最初に「はい」となるものを選びなさい。",
                first, second)};
        q.choices = {{"1: their x extents are disjoint", "1: x の範囲が重ならない"},
                     {"2: their y extents are disjoint", "2: y の範囲が重ならない"},
                     {fmt::format("3: all of {} lies behind the plane of {}", first, second),
                      fmt::format("3: {} の全体が {} の平面の後ろにある", first, second)},
                     {fmt::format("4: all of {} lies before the plane of {}", second, first),
                      fmt::format("4: {} の全体が {} の平面の手前にある", second, first)},
                     {"5: their projections are disjoint", "5: 投影が重ならない"},
                     {"none of the five", "五つのどれでもない"}};
        q.answer = std::string(1, char('a' + (wanted - '1')));
        q.why = wanted == '6'
                    ? Bilingual{"All five say no: the other must be drawn first, or one is cut by the plane "
                                "of the other.",
                                "五つとも「いいえ」です。もう一方を先に描くか、一方を他方の平面で切ります。"}
                    : Bilingual{fmt::format("Test {} is the first that says yes.", wanted),
                                fmt::format("最初に「はい」となるのは判定 {} です。", wanted)};
        q.decided = {.algorithm = "newell", .step = deciding};
        q.needs_corners = true;
        return q;
    }
    return std::nullopt;
}

std::optional<Question> ask_pieces(QuizRandom& random) {
    Question q;
    q.scene = tilted_polygons(random, 3, 3);
    const QuestionContext context(q.scene);
    const Result newell = context.run("newell");
    if (newell.counts.splits == 0 || newell.counts.splits > 3 || newell.counts.undecided > 0)
        return std::nullopt;
    for (const std::uint32_t id : {1u, 2u, 3u})
        if (std::count(newell.ids.begin(), newell.ids.end(), id) < 200) return std::nullopt;
    q.kind = "pieces";
    q.text = {
        "Newell, Newell and Sancha's algorithm draws these three triangles. If neither of two may be drawn "
        "first, it cuts the one that reaches farther by the plane of the other, or if that misses it, the "
        "other by its plane. How many pieces does it draw? Answer with a number.",
        "Newell、Newell、Sancha のアルゴリズムで、この三つの三角形を描きます。どちらも先に描けない"
        "ときは、より遠くまで届くほうを他方の平面で切り、その平面が届かなければ他方を切ります。"
        "全部でいくつの部分を描きますか。数で答えなさい。"};
    q.answer = std::to_string(newell.pieces.size());
    q.why = {fmt::format("Cuts of the 3 triangles: {}.", newell.counts.splits),
             fmt::format("三つの三角形は {} 回切られます。", newell.counts.splits)};
    q.decided = {.algorithm = "newell", .step = 1};
    std::size_t number = 0;
    for (const Step& step : context.steps("newell", Level::Polygon)) {
        ++number;
        if (step.action == Action::Split) q.decided.step = number;
    }
    q.needs_corners = true;
    return q;
}

}  // namespace gw::hiddensurface
