// Claims: the same seed gives the same quiz, and a longer one begins as a shorter one; each answer
// is right by a second way of finding it; a fragment list is graded as its mistakes were made;
// malformed lists name line and expectation.
#include "gw/error.h"
#include "hiddensurface/interface/line_algorithm.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/quiz/fragments.h"
#include "hiddensurface/quiz/quiz.h"
#include "hiddensurface/quiz/quiz_drawing.h"
#include "hiddensurface/run/compare.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

namespace gw::hiddensurface {
namespace {

std::string text_of(const Question& q) {
    std::string text = q.kind + q.text.en + q.text.ja + q.answer + q.why.en + q.why.ja;
    for (const Bilingual& choice : q.choices) text += choice.en + choice.ja;
    for (const scene::Object& object : q.scene.objects)
        for (const vec3& p : object.mesh->data().positions)
            text +=
                std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + " ";
    return text;
}

struct QuizTrial : Trial {
    explicit QuizTrial(const Question& q) : Trial(q.scene, vgx(), quiz_width, quiz_height) {}
};

std::vector<Question> of_kind(const std::string& kind) { return make_quiz(5, 6, kind); }

}  // namespace

TEST(Quiz, IsTheSameForTheSameSeed) {
    const auto longer = make_quiz(11, 9), shorter = make_quiz(11, 7), other = make_quiz(12, 7);
    ASSERT_EQ(longer.size(), 9u);
    for (std::size_t i = 0; i < shorter.size(); ++i) {
        EXPECT_EQ(text_of(longer[i]), text_of(shorter[i])) << i;
        EXPECT_NE(text_of(other[i]), text_of(shorter[i])) << i;
        EXPECT_EQ(longer[i].kind, quiz_kinds()[i]);
        EXPECT_EQ(canonical_answer(longer[i].answer), longer[i].answer);
    }
    EXPECT_EQ(longer[7].kind, quiz_kinds()[0]);
    EXPECT_THROW(make_quiz(1, 1, "riddle"), Error);
}

// By drawing the four choices: the machine paints the pieces one over the other.
TEST(Quiz, HasOneOrderThatPaintsThePicture) {
    for (const Question& q : of_kind("order")) {
        QuizTrial trial(q);
        ASSERT_EQ(q.choices.size(), 4u);
        for (std::size_t c = 0; c < 4; ++c) {
            Output output{.list = begin_picture(trial.input, "choice")};
            StepLog none;
            std::istringstream words(q.choices[c].en);
            for (std::uint32_t id; words >> id;)
                draw_piece(trial.input, whole(id - 1, trial.input.polygons[id - 1]), output, none);
            trial.machine->execute(output.list);
            int different = 0;
            for (std::size_t i = 0; i < trial.z_buffer.ids.size(); ++i)
                different +=
                    scene::id_of(trial.machine->planes().color[i]) != trial.z_buffer.ids[i] ? 1 : 0;
            if (q.answer == std::string(1, char('a' + c)))
                EXPECT_LE(different, 2) << q.choices[c].en;
            else
                EXPECT_GE(different, 150) << q.choices[c].en;
        }
    }
}

// The order of the corners in the quiz does not come from Newell: tests 1 to 4 again, on the
// scene's coordinates.
TEST(Quiz, NamesTheFirstOfNewellsTestsThatSaysYes) {
    std::set<std::string> answers;
    for (const Question& q : make_quiz(5, 12, "test")) {
        QuizTrial trial(q);
        const int p = q.text.en[8] - '1';  // "Polygon 2 reaches farthest"
        const Facet &a = trial.input.polygons[std::size_t(p)].facets[0],
                    &b = trial.input.polygons[std::size_t(1 - p)].facets[0];
        const auto extent_of = [](const Facet& f, int axis) {
            double low = 1e30, high = -1e30;
            for (const dvec3& v : f.parts[0]) {
                low = std::min(low, v[axis]);
                high = std::max(high, v[axis]);
            }
            return std::pair(low, high);
        };
        const auto apart = [&](int axis) {
            const auto x = extent_of(a, axis), y = extent_of(b, axis);
            return x.second <= y.first || y.second <= x.first;
        };
        const auto all = [](const Facet& of, const Facet& plane, double sign) {
            return std::all_of(of.parts[0].begin(), of.parts[0].end(), [&](const dvec3& v) {
                return sign * side(plane.plane, v) >= -1e-3;
            });
        };
        const char first = apart(0)        ? 'a'
                           : apart(1)      ? 'b'
                           : all(a, b, 1)  ? 'c'
                           : all(b, a, -1) ? 'd'
                                           : 'e';
        if (first < 'e')
            EXPECT_EQ(q.answer, std::string(1, first)) << q.text.en;
        else
            EXPECT_GE(q.answer, "e") << q.text.en;
        answers.insert(q.answer);
    }
    EXPECT_GE(answers.size(), 4u);
}

TEST(Quiz, CountsPiecesThatGiveThePicture) {
    for (const Question& q : of_kind("pieces")) {
        QuizTrial trial(q);
        const Result newell = trial.run("newell");
        EXPECT_EQ(q.answer, std::to_string(3 + newell.counts.splits));
        EXPECT_EQ(newell.counts.wrong, 0u);
    }
}

// A face looks away where the eye is on the solid's side of its plane.
TEST(Quiz, FindsTheFacesThatLookAway) {
    for (const Question& q : of_kind("facing")) {
        QuizTrial trial(q);
        dvec3 middle(0);
        for (const Polygon& polygon : trial.input.polygons)
            middle += polygon.world[0] / double(trial.input.polygons.size());
        std::string back;
        for (const Polygon& polygon : trial.input.polygons) {
            const dvec4 plane = plane_of(polygon_normal(polygon.world), polygon.world[0]);
            EXPECT_LT(side(plane, middle), 0) << "turned inwards: " << q.text.en;
            if (side(plane, trial.view.camera.eye) < 0)
                back += (back.empty() ? "" : " ") + std::to_string(polygon.id);
        }
        EXPECT_EQ(q.answer, back) << q.text.en;
    }
}

TEST(Quiz, CountsWritesAsTheDistancesSay) {
    for (const Question& q : of_kind("writes")) {
        QuizTrial trial(q);
        const auto over = polygons_over(trial.input);
        const std::size_t at = std::size_t(q.point->y) * quiz_width + std::size_t(q.point->x);
        double nearest = 1e30;
        int writes = 0;
        for (const std::uint32_t id : over[at]) {
            const double distance = trial.input.polygons[id - 1].nearest;
            if (distance < nearest) writes += 1;
            nearest = std::min(nearest, distance);
        }
        EXPECT_EQ(q.answer, std::to_string(writes)) << q.text.en;
    }
}

// Spans between the ends of what lies over each pixel of the line: where that changes, a segment
// ends.
TEST(Quiz, CountsSpansOfALine) {
    for (const Question& q : of_kind("spans")) {
        QuizTrial trial(q);
        const auto over = polygons_over(trial.input);
        int spans = 0;
        const auto at = [&](int x) {
            return over[std::size_t(*q.row) * quiz_width + std::size_t(x)];
        };
        for (int x = 0; x < quiz_width; ++x)
            spans += !at(x).empty() && (x == 0 || at(x) != at(x - 1)) ? 1 : 0;
        EXPECT_EQ(q.answer, std::to_string(spans)) << q.text.en;
    }
}

TEST(Quiz, CountsTrianglesBeforeAPoint) {
    for (const Question& q : of_kind("invisibility")) {
        QuizTrial trial(q);
        const std::size_t at = std::size_t(q.point->y) * quiz_width + std::size_t(q.point->x);
        const auto over = polygons_over(trial.input)[at];
        const int answer = std::stoi(q.answer);
        EXPECT_GE(answer, 1);
        EXPECT_LE(answer, int(over.size()) + 1);
        EXPECT_LE(answer, 4);
    }
}

// The step that a question names is there, and about it.
TEST(Quiz, NamesTheStepThatDecides) {
    for (const Question& q : make_quiz(5, 14)) {
        QuizTrial trial(q);
        StepLog log(q.decided.level);
        if (const LineAlgorithm* lines = line_algorithm_named(q.decided.algorithm))
            lines->run(trial.input, log);
        else
            algorithm_named(q.decided.algorithm).run(trial.input, log);
        ASSERT_GE(q.decided.step, 1u) << q.kind;
        if (q.kind == "writes") {  // the machine's own: a step for each polygon
            EXPECT_LE(q.decided.step, trial.input.polygons.size());
            continue;
        }
        ASSERT_LE(q.decided.step, log.steps().size()) << q.kind;
        const Step& step = log.steps()[q.decided.step - 1];
        if (q.kind == "order") {
            EXPECT_EQ(q.decided.step, log.steps().size());
        }
        if (q.kind == "test" && q.answer < "e") {
            EXPECT_EQ(step.test[0], char(q.answer[0] - 'a' + '1'));
            EXPECT_EQ(step.result, "yes");
        }
        if (q.kind == "pieces") {
            EXPECT_EQ(step.action, Action::Split);
        }
        if (q.kind == "facing") {
            EXPECT_EQ(step.result, "back");
        }
        if (q.kind == "spans") {
            EXPECT_EQ(step.window.y, *q.row);
        }
        if (q.kind == "invisibility") {
            ASSERT_TRUE(step.line);
            const dvec3 middle = (step.line->a + step.line->b) / 16.0;
            EXPECT_NEAR(middle.x, q.point->x, 0.1);
            EXPECT_NEAR(middle.y, q.point->y, 0.1);
        }
    }
}

TEST(Quiz, TakesAnswersAsTheyAreWritten) {
    EXPECT_EQ(canonical_answer(" B\n"), "b");
    EXPECT_EQ(canonical_answer("10, 2;4"), "2 4 10");
    EXPECT_EQ(canonical_answer(""), "");
}

TEST(FragmentList, OfTheTruthIsRight) {
    Trial trial(case_scene("cycle"), vgx(), 48, 36);
    const std::string truth = fragments_text(trial.z_buffer.ids, trial.input);
    const auto grade = grade_fragments(read_fragments("truth.csv", truth, trial.input),
                                       trial.z_buffer.ids, trial.input);
    EXPECT_TRUE(grade.all_right());
    EXPECT_EQ(grade.expected, trial.z_buffer.counts.pixels);
    EXPECT_EQ(grade.right, grade.expected);
}

// One mistake of each kind, put into the truth.
TEST(FragmentList, IsGradedByTheMistakesMade) {
    Trial trial(case_scene("cycle"), vgx(), 48, 36);
    auto list =
        read_fragments("list", fragments_text(trial.z_buffer.ids, trial.input), trial.input);
    const auto over = polygons_over(trial.input);
    const auto at = [&](const Fragment& f) -> const std::vector<std::uint32_t>& {
        return over[std::size_t(35 - f.y) * 48 + std::size_t(f.x)];
    };
    const auto two = std::find_if(list.begin(), list.end(),
                                  [&](const Fragment& f) { return at(f).size() == 2; });
    const auto one = std::find_if(list.begin(), list.end(),
                                  [&](const Fragment& f) { return at(f).size() == 1; });
    ASSERT_TRUE(two != list.end() && one != list.end());
    const Fragment second = *one, first = list.back();
    two->id = at(*two)[0] == two->id ? at(*two)[1] : at(*two)[0];  // the hidden one
    one->id = one->id % 3 + 1;  // not over this pixel, so the right one is missing
    list.push_back(first);      // a second time
    const auto grade = grade_fragments(list, trial.z_buffer.ids, trial.input);
    EXPECT_EQ(grade.wrong, 1u);
    EXPECT_EQ(grade.misplaced, 1u);
    EXPECT_EQ(grade.missing, 1u);
    EXPECT_EQ(grade.doubled, 1u);
    EXPECT_EQ(grade.right, grade.expected - 2);
    ASSERT_EQ(grade.mistakes.size(), 4u);
    EXPECT_EQ(grade.mistakes.back().mistake, Mistake::Missing);
    EXPECT_EQ(grade.mistakes.back().x, second.x);
    EXPECT_EQ(grade.mistakes.back().y, second.y);
    EXPECT_EQ(grade_fragments({}, trial.z_buffer.ids, trial.input).missing, grade.expected);
}

// 64.25 would be 64.2 in C++ and 64.3 in JavaScript.
TEST(Quiz, CornersHaveTenthsSoThatAllMediaShowTheSameDigits) {
    int halves = 0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed)
        for (const Question& q : make_quiz(seed, 7)) {
            const double unit = double(1 << QuizTrial(q).input.subpixel_bits());
            for (const QuizCorner& c : corners_of(q)) {
                for (const double value : {c.x, c.y})
                    EXPECT_EQ(value, std::round(value * 10) / 10) << c.name << " of " << seed;
                // The grid's own place: a quarter is a tie.
                const double exact = std::round(c.x * unit) / unit;
                if (std::abs(exact * 10 - std::floor(exact * 10) - 0.5) < 1e-9) {
                    EXPECT_GT(c.x, exact) << c.name << " of " << seed;
                    halves += 1;
                }
            }
        }
    EXPECT_GT(halves, 0);
}

TEST(Quiz, NoNameOfADrawingCoversAnother) {
    const std::regex text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>([^<]+)<");
    for (std::uint64_t seed = 1; seed < 9; ++seed)
        for (const Question& question : make_quiz(seed, 7)) {
            const std::string svg = drawing_of(question, "");
            std::vector<std::smatch> names(std::sregex_iterator(svg.begin(), svg.end(), text), {});
            for (std::size_t i = 0; i < names.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) {
                    const auto apart = [&](int k) {
                        return std::abs(std::stod(names[i][k]) - std::stod(names[j][k]));
                    };
                    EXPECT_TRUE(apart(1) > 9 || apart(2) > 7)
                        << seed << " " << question.kind << ": " << names[i][3] << " over "
                        << names[j][3];
                }
        }
}

TEST(FragmentList, RefusesWhatIsNone) {
    Trial trial(case_scene("cycle"), vgx(), 48, 36);
    const auto message = [&](const char* text) -> std::string {
        try {
            read_fragments("list.csv", text, trial.input);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("# mine\nx,y,polygon\n\n1, 2, 3\r\n"), "");
    for (const char* text :
         {"1,2\n", "1,2,3,4\n", "a,2,1\n", "1.5,2,1\n", "1 2 1\n", "99999999999999999999,1,1\n"}) {
        EXPECT_NE(message(text).find("list.csv:1: "), std::string::npos) << text;
        EXPECT_NE(message(text).find("expected x,y,polygon"), std::string::npos) << text;
    }
    EXPECT_NE(message("0,0,1\n48,0,1\n")
                  .find("list.csv:2: pixel 48,0 is outside the window; expected x 0..47"),
              std::string::npos);
    EXPECT_NE(message("0,-1,1\n").find("outside the window"), std::string::npos);
    EXPECT_NE(message("0,0,4\n").find("no polygon 4; expected 1..3"), std::string::npos);
    EXPECT_NE(message("0,0,0\n").find("no polygon 0"), std::string::npos);
}

}  // namespace gw::hiddensurface
