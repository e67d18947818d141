// gw quiz: writes a handout of questions with drawings and scenes, and the answers beside
// it; or one for each student.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/hidden/options.h"
#include "apps/hidden/page.h"
#include "apps/hidden/quiz/quiz_export.h"
#include "apps/hidden/quiz/quiz_files.h"
#include "apps/hidden/quiz/quiz_page.h"
#include "apps/hidden/quiz/students.h"
#include "hiddensurface/quiz/quiz_data.h"
#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <set>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

struct QuizOptions {
    std::filesystem::path folder;
    int seed = 1, questions = 7;
    std::string kind;      ///< of the questions; "": all kinds in turn
    std::string students;  ///< students_from; "": one quiz
    QuizLanguage language = QuizLanguage::Both;
    std::set<std::string> exports;  ///< of export_names
    Form form = Form::Text;
    bool quiet = false;
};

const std::vector<std::string> export_names{"moodle", "qti"};

/// The player's address of the deciding step, at the question's pixel.
std::string link_of(const hs::Question& question, const std::string& player) {
    std::string link = fmt::format("{}#step={}", player, question.decided.step);
    if (question.point)
        link += fmt::format("&pixel={},{}", int(question.point->x),
                            hs::quiz_height - 1 - int(question.point->y));
    return link;
}

/// The questions as text and as JSON, the form to fill in, and the key.
struct Texts {
    std::string text;
    Json questions = Json::array(), form = Json::object(), key = Json::array();
};

std::string corners_text(const hs::Question& question, const QuizHtml& words) {
    std::string text;
    for (const hs::QuizCorner& c : hs::corners_of(question))
        text += fmt::format("   {}: {:.1f} {:.1f} {:.4f}\n", c.name, c.x, c.y, c.Z);
    const hs::Bilingual head{"Corners: x, y in pixels from the upper left, Z 0 to 1",
                             "頂点：x、y は左上からの画素、Z は 0 から 1"};
    return text.empty() ? "" : fmt::format("   {}\n{}", words.plain(head), text);
}

void add_question(const hs::Question& q, std::size_t number, const std::string& picture,
                  const std::string& scene, QuizLanguage language, Texts& out) {
    const QuizHtml words{language};
    out.text += fmt::format("{}. {}\n   ", number, words.plain(hs::title_of_kind(q.kind)));
    if (language != QuizLanguage::Japanese) out.text += q.text.en + "\n   ";
    if (language != QuizLanguage::English) out.text += q.text.ja + "\n   ";
    out.text += fmt::format("{}: {}; {}: {}\n{}", words.plain({"Picture", "図"}), picture,
                            words.plain({"scene", "シーン"}), scene, corners_text(q, words));
    Json json{{"number", number},         {"kind", q.kind},     {"question", q.text.en},
              {"question_ja", q.text.ja}, {"picture", picture}, {"scene", scene}};
    Json choices = Json::object();
    for (std::size_t i = 0; i < q.choices.size(); ++i) {
        out.text += fmt::format("   {}) {}\n", char('a' + i), words.plain(q.choices[i]));
        choices[std::string(1, char('a' + i))] = q.choices[i].en;
    }
    if (!choices.empty()) json["choices"] = std::move(choices);
    out.text += "\n";
    out.questions.push_back(json);
    out.form[std::to_string(number)] = "";
    out.key.push_back({{"number", number},
                       {"kind", q.kind},
                       {"answer", q.answer},
                       {"why", q.why.en},
                       {"why_ja", q.why.ja},
                       {"algorithm", q.decided.algorithm},
                       {"step", q.decided.step}});
}

/// One student's folders.
struct Folders {
    std::filesystem::path handout, answers;
};

/// Returns the questions as text or JSON.
std::string put_quiz(image::OutputSet& output, const Folders& folders, const QuizSheet& sheet,
                     const QuizOptions& options) {
    Texts all;
    std::vector<std::string> players, practice{hs::quiz_json(sheet.questions)};
    const bool has_pages = !embedded_page("quiz.html").empty();
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
        const hs::Question& question = sheet.questions[i];
        const std::string name = fmt::format("{:02}", i + 1), picture = "picture_" + name + ".svg",
                          scene = "scene_" + name;
        const auto file = [&](const std::string& rest) -> image::OutputFile& {
            return output.add(folders.handout / rest);
        };
        const std::string spoken = QuizHtml{sheet.language}.plain(hs::drawing_in_words(question));
        file(picture).write_text(hs::drawing_of(question, escaped_xml(spoken)) + "\n");
        file(scene + ".toml").write_text(toml_of(question, scene + ".obj"));
        file(scene + ".obj").write_text(obj_of(question.scene, scene + ".mtl"));
        file(scene + ".mtl").write_text(mtl_of(question.scene));
        add_question(question, i + 1, picture, scene + ".toml", sheet.language, all);
        players.emplace_back();
        if (!has_pages) continue;
        const std::string page = "steps_" + name + ".html";
        practice.push_back(hs::deciding_log(question));
        output.add(folders.answers / page).write_text(page_with("player.html", {practice.back()}));
        players.back() = link_of(question, page);
    }
    if (has_pages)
        output.add(folders.answers / "practice.html").write_text(page_with("quiz.html", practice));
    if (options.exports.contains("moodle"))
        output.add(folders.answers / "moodle.xml").write_text(moodle_xml(sheet));
    if (options.exports.contains("qti"))
        output.add(folders.answers / "qti.zip").write_text(qti_package(sheet));
    const Json head{{"seed", sheet.seed},
                    {"size", fmt::format("{}x{}", hs::quiz_width, hs::quiz_height)}};
    Json questions = head, empty{{"seed", sheet.seed}, {"answers", all.form}},
         key{{"seed", sheet.seed}, {"student", sheet.student}, {"answers", all.key}};
    questions["questions"] = all.questions;
    output.add(folders.handout / "quiz.html").write_text(handout_page(sheet));
    output.add(folders.handout / "questions.txt").write_text(all.text);
    output.add(folders.handout / "questions.json").write_text(questions.dump(2) + "\n");
    output.add(folders.handout / "answers.json").write_text(empty.dump(2) + "\n");
    output.add(folders.answers / "answers.html").write_text(answers_page(sheet, players));
    output.add(folders.answers / "key.json").write_text(key.dump(2) + "\n");
    return options.form == Form::Json ? questions.dump(2) + "\n" : all.text;
}

QuizSheet quiz_sheet(const QuizOptions& options, const std::string& student, int seed) {
    return {student, seed, hs::make_quiz(std::uint32_t(seed), options.questions, options.kind),
            options.language};
}

/// A folder and a seed for each student, and the class's list.
std::string put_class(image::OutputSet& output, const QuizOptions& options,
                      const std::vector<Student>& students, Progress& progress) {
    const auto handout = options.folder / "handout", answers = options.folder / "answers";
    output.make_folder(answers);
    std::string list = "student,seed,folder\n", text;
    for (const Student& student : students) {
        progress.at(fmt::format("quiz {} of {}", student.folder, students.size()));
        const Folders folders{handout / student.folder, answers / student.folder};
        output.make_folder(folders.handout);
        output.make_folder(folders.answers);
        put_quiz(output, folders, quiz_sheet(options, student.name, student.seed), options);
        list += fmt::format("\"{}\",{},{}\n", student.name, student.seed, student.folder);
        text += fmt::format("{}: seed {}\n", student.folder, student.seed);
        output.commit();
    }
    output.add(options.folder / "class.csv").write_text(list);
    return text;
}

int quiz(const QuizOptions& options, const Session& session) {
    image::OutputSet output(session.inputs);
    std::vector<Student> students;
    if (!options.students.empty()) students = students_from(options.students, options.seed);
    const std::filesystem::path handout = options.folder / "handout";
    output.make_folder(options.folder);
    output.make_folder(handout);
    Progress progress("making questions", options.quiet);
    const std::string text = options.students.empty()
                                 ? put_quiz(output, {handout, options.folder},
                                            quiz_sheet(options, "", options.seed), options)
                                 : put_class(output, options, students, progress);
    if (options.students.empty()) put_index(output, options.folder, session);
    output.commit();
    print(text);
    return Done;
}

void add_whole_number(CLI::App& command, const char* name, int& to, int low, int high,
                      const char* help) {
    command
        .add_option_function<std::string>(
            name,
            [name, &to, low, high](const std::string& word) {
                to = whole_number_from(name, word, low, high);
            },
            help)
        ->type_name("N");
}

}  // namespace

Command add_quiz(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("quiz", "Exercises about hidden surfaces, with their answers");
    const auto options = std::make_shared<QuizOptions>();
    command
        ->add_option("DIR", options->folder,
                     "The exercises go to DIR/handout, their answers to DIR/key.json")
        ->required()
        ->type_name("DIR");
    add_whole_number(*command, "--seed", options->seed, 0, 2147483647,
                     "The same seed gives the same questions (default 1)");
    add_whole_number(*command, "--questions", options->questions, 1, 99,
                     "The number of questions (default 7)");
    command
        ->add_option("--students", options->students,
                     "A quiz for each student, in folders of their own. A number, or a file with "
                     "lines name or name,seed")
        ->type_name("N|FILE.csv");
    command
        ->add_option_function<std::string>(
            "--kind",
            [options](const std::string& word) {
                options->kind = one_of("--kind", word, hs::quiz_kinds());
            },
            "Questions of one kind (default: all kinds in turn)")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--language",
            [options](const std::string& word) {
                options->language = one_of("--language", word, {"en", "ja"}) == "en"
                                        ? QuizLanguage::English
                                        : QuizLanguage::Japanese;
            },
            "The language of the pages and exports: en or ja (default: both)")
        ->type_name("NAME");
    command
        ->add_option_function<std::vector<std::string>>(
            "--export",
            [options](const std::vector<std::string>& words) {
                for (const std::string& word : words)
                    options->exports.insert(one_of("--export", word, export_names));
            },
            "For a learning platform: moodle (DIR/moodle.xml) or qti (DIR/qti.zip). Can be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    add_form_options(*command, options->form, false);
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer("Example:\n  build/release/bin/gw quiz quiz --seed 7");
    return {command, [options](Session& session) { return quiz(*options, session); }};
}

}  // namespace gw::apps
