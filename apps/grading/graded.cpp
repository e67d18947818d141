#include "apps/grading/graded.h"

#include "apps/command/page_style.h"
#include "gw/escape_controls.h"
#include "image/plot/markup.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

namespace gw::apps {
namespace {

using Json = nlohmann::ordered_json;
using plot::escaped;

/// Names and feedback are anybody's text.
std::string plain(const std::string& text) { return escape_controls(text, "\n\t"); }
std::string marked_up(const std::string& text) { return escaped(plain(text)); }

bool is_right(const GradedScene& scene) { return scene.outcome == "right"; }

double seconds_of(const GradedSubmission& graded) {
    double sum = 0;
    for (const GradedScene& scene : graded.scenes) sum += scene.seconds;
    return sum;
}

/// In hundredths, since the third place is noise.
double rounded(double seconds) { return std::int64_t(seconds * 100 + 0.5) / 100.0; }

std::string test_case(const GradedSubmission& graded, const GradedScene& scene) {
    const std::string head =
        fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.2f}")",
                    marked_up(graded.name), marked_up(scene.scene), scene.seconds);
    if (is_right(scene)) return head + "/>\n";
    // JUnit: a failure is a wrong answer, an error is none.
    const char* kind = scene.outcome == "wrong" ? "failure" : "error";
    return fmt::format("{}>\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", head, kind,
                       escaped(scene.outcome), marked_up(scene.feedback), kind);
}

std::string test_suite(const GradedSubmission& graded) {
    const auto wrong = std::ranges::count(graded.scenes, "wrong", &GradedScene::outcome);
    const auto right = std::ranges::count_if(graded.scenes, is_right);
    std::string text = fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.2f}\">\n",
        marked_up(graded.name), graded.scenes.size(), wrong,
        std::ptrdiff_t(graded.scenes.size()) - wrong - right, seconds_of(graded));
    for (const GradedScene& scene : graded.scenes) text += test_case(graded, scene);
    return text + "  </testsuite>\n";
}

/// A spreadsheet would compute a cell that begins so.
std::string cell(std::string text) {
    if (!text.empty() && std::string("=+-@\t").find(text[0]) != std::string::npos)
        text.insert(0, "'");
    for (std::size_t at = 0; (at = text.find('"', at)) != text.npos; at += 2) text.insert(at, "\"");
    return '"' + text + '"';
}

/// A name in an address.
std::string link_to(const std::string& path) {
    std::string text;
    for (const char c : path) {
        const bool stays = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string("-_./").find(c) != std::string::npos;
        text += stays ? std::string(1, c)
                      : fmt::format("%{:02X}", unsigned(static_cast<unsigned char>(c)));
    }
    return text;
}

/// The page's own words, in the language of the feedback.
struct GradeWords {
    bool japanese = false;
    std::string operator()(const char* en, const char* ja) const { return japanese ? ja : en; }
};

std::string outcome_said(const std::string& outcome, GradeWords say) {
    static const std::map<std::string, const char*> japanese{
        {"right", "正解"},          {"wrong", "不正解"},
        {"endless", "終わらない"},  {"crashed", "異常終了"},
        {"broken", "読めない答え"}, {"flooding", "出力が多すぎる"},
        {"memory", "メモリ不足"},   {"no program", "プログラムなし"},
    };
    const auto found = japanese.find(outcome);
    return found == japanese.end() ? escaped(outcome) : say(outcome.c_str(), found->second);
}

std::string section_of(const GradedSubmission& graded, std::size_t number, GradeWords say) {
    std::string text =
        fmt::format("<section id=\"s{}\">\n<h2>{}</h2>\n", number, marked_up(graded.name));
    for (const GradedScene& scene : graded.scenes) {
        text += fmt::format("<h3>{}: {}, {} / {}</h3>\n<pre>{}</pre>\n", marked_up(scene.scene),
                            outcome_said(scene.outcome, say), scene.points, scene.of,
                            marked_up(scene.feedback));
        if (!scene.player.empty())
            text += fmt::format(
                "<p><a href=\"{}\">{}</a></p>\n",
                link_to((folder_of_student(graded.name) / scene.player).generic_string()),
                say("Play its steps", "ステップを再生"));
    }
    return text + "</section>\n";
}

std::string table_row(const GradedSubmission& graded, std::size_t number, std::size_t scenes,
                      GradeWords say) {
    std::string text = fmt::format("<tr><th scope=\"row\"><a href=\"#s{}\">{}</a></th>", number,
                                   marked_up(graded.name));
    if (graded.scenes.empty())
        return text + fmt::format("<td colspan=\"{}\">{}</td></tr>\n", scenes + 1,
                                  say("not graded yet", "未採点"));
    text += fmt::format("<td class=\"n\">{} / {}</td>", graded.points(), graded.of());
    for (const GradedScene& scene : graded.scenes)
        text += fmt::format("<td class=\"{}\">{}</td>", is_right(scene) ? "right" : "not",
                            outcome_said(scene.outcome, say));
    return text + "</tr>\n";
}

constexpr const char* class_style = R"(<style>
.right { border-left: 4px solid var(--right) }
.not { border-left: 4px solid var(--wrong) }
</style>
)";

}  // namespace

std::vector<std::string> outcome_words() {
    return {"right", "wrong", "endless", "crashed", "broken", "flooding", "memory", "no program"};
}

int GradedSubmission::points() const {
    int sum = 0;
    for (const GradedScene& scene : scenes) sum += scene.points;
    return sum;
}

int GradedSubmission::of() const {
    int sum = 0;
    for (const GradedScene& scene : scenes) sum += scene.of;
    return sum;
}

std::filesystem::path folder_of_student(const std::string& name) {
    return std::filesystem::path("students") / name;
}

std::string results_json(const GradedSubmission& graded) {
    Json tests = Json::array();
    for (const GradedScene& s : graded.scenes)
        tests.push_back(
            {{"name", s.scene},
             {"score", s.points},
             {"max_score", s.of},
             {"status", is_right(s) ? "passed" : "failed"},
             {"output", plain(s.feedback)},
             {"output_format", "text"},
             {"tags", {s.outcome}},
             {"extra_data",
              {{"outcome", s.outcome}, {"seconds", rounded(s.seconds)}, {"player", s.player}}}});
    const Json json{{"score", graded.points()},
                    {"execution_time", rounded(seconds_of(graded))},
                    {"visibility", "visible"},
                    {"stdout_visibility", "hidden"},
                    {"extra_data", {{"digest", graded.digest}}},
                    {"tests", tests}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<GradedSubmission> read_results(const std::filesystem::path& file) {
    const Json json = Json::parse(std::ifstream(file, std::ios::binary), nullptr, false);
    try {
        GradedSubmission graded;
        graded.digest = json.at("extra_data").at("digest");
        for (const Json& t : json.at("tests")) {
            const Json& more = t.at("extra_data");
            graded.scenes.push_back({t.at("name"), more.at("outcome"), t.at("score"),
                                     t.at("max_score"), more.at("seconds"), t.at("output"),
                                     more.at("player")});
        }
        return graded;
    } catch (const Json::exception&) {
        return {};
    }
}

std::string junit_xml(const std::vector<GradedSubmission>& all) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"gw autograde\">\n";
    for (const GradedSubmission& graded : all)
        if (!graded.scenes.empty()) text += test_suite(graded);
    return text + "</testsuites>\n";
}

std::vector<std::vector<std::string>> grade_rows(const std::vector<GradedSubmission>& all,
                                                 const std::vector<std::string>& scenes) {
    std::vector<std::vector<std::string>> rows{{"student", "points", "of"}};
    rows[0].insert(rows[0].end(), scenes.begin(), scenes.end());
    for (const GradedSubmission& graded : all) {
        const bool is_graded = !graded.scenes.empty();
        std::vector<std::string> row{escape_controls(graded.name),
                                     is_graded ? std::to_string(graded.points()) : "",
                                     is_graded ? std::to_string(graded.of()) : ""};
        for (std::size_t i = 0; i < scenes.size(); ++i)
            row.push_back(is_graded ? graded.scenes[i].outcome : "not graded yet");
        rows.push_back(row);
    }
    return rows;
}

std::string grades_csv(const std::vector<std::vector<std::string>>& rows) {
    std::string text;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            text += cell(row[i]) + (i + 1 == row.size() ? "\n" : ",");
    return text;
}

std::string class_page(const std::vector<GradedSubmission>& all,
                       const std::vector<std::string>& scenes, const std::string& language) {
    const GradeWords say{language == "ja"};
    std::string head, rows, sections;
    for (const std::string& scene : scenes)
        head += "<th scope=\"col\">" + marked_up(scene) + "</th>";
    for (std::size_t i = 0; i < all.size(); ++i) {
        rows += table_row(all[i], i + 1, scenes.size(), say);
        sections += section_of(all[i], i + 1, say);
    }
    return page_begin(say("Grades", "成績"), {}, language) + class_style +
           fmt::format(
               "<p>{}: <a href=\"grades.csv\">grades.csv</a>, <a href=\"junit.xml\">junit.xml</a>; "
               "Gradescope: students/NAME/results.json</p>\n<table>\n<thead><tr><th "
               "scope=\"col\">{}</th><th scope=\"col\">{}</th>{}</tr></thead>\n"
               "<tbody>\n{}</tbody>\n</table>\n{}",
               say("Also as", "ほかの形"), say("student", "学生"), say("points", "得点"), head,
               rows, sections) +
           std::string(page_end);
}

}  // namespace gw::apps
