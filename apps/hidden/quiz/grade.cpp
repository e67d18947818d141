// gw grade: compares students' answers with the key of their quiz.
#include "apps/command/command.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/hidden/options.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "hiddensurface/quiz/quiz.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <set>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw Error(file.string() + ": " + what);
}

Json read_json(const std::filesystem::path& file) {
    const std::string text = scene::read_text(file);
    try {
        return Json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t at =
            std::clamp<std::size_t>(error.byte, 1, text.size() + 1) - 1;  // of the first wrong byte
        const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
        const std::string rest = scene::printable(text.substr(at, text.find('\n', at) - at), 20);
        throw Error(file.string(), int(line),
                    (rest.empty() ? "ends too early" : "is not JSON at '" + rest + "'") +
                        "; expected JSON that gw quiz wrote");
    } catch (const nlohmann::json::exception&) {
        fail(file, "has a number that is too large; expected JSON that gw quiz wrote");
    }
}

/// The canonical form of "b", 3 or [1, 4].
std::string answer_of(const std::filesystem::path& file, const std::string& number,
                      const Json& value) {
    if (value.is_string()) return hs::canonical_answer(value);
    if (value.is_number_integer()) return hs::canonical_answer(value.dump());
    std::string words;
    bool fits = value.is_array();
    for (const Json& word : value) {
        fits = fits && (word.is_number_integer() || word.is_string());
        words += " " + (word.is_string() ? word.get<std::string>() : word.dump());
    }
    if (!fits)
        fail(file, "answer " + number + " is " + scene::printable(value.dump()) +
                       "; expected text, a whole number or a list of them");
    return hs::canonical_answer(words);
}

struct GradeOptions {
    std::filesystem::path key, answers;  ///< files, or folders of a class
    Form form = Form::Text;
};

struct Key {
    std::string number, kind, answer, why;
};

std::vector<Key> read_key(const std::filesystem::path& file, Json& seed) {
    const Json json = read_json(file);
    try {
        seed = json.at("seed");
        std::vector<Key> key;
        for (const Json& a : json.at("answers"))
            key.push_back({std::to_string(a.at("number").get<int>()), a.at("kind"),
                           hs::canonical_answer(a.at("answer")), a.at("why")});
        if (key.empty()) fail(file, "no answers; expected a key that gw quiz wrote");
        return key;
    } catch (const nlohmann::json::exception&) {
        fail(file, "is no key; expected a key that gw quiz wrote");
    }
}

std::map<std::string, std::string> read_answers(const std::filesystem::path& file,
                                                const std::vector<Key>& key, const Json& seed) {
    const Json json = read_json(file);
    if (!json.is_object() || !json.contains("answers") || !json["answers"].is_object())
        fail(file, "no answers; expected {\"seed\": ..., \"answers\": {\"1\": \"b\", ...}}");
    if (!json.contains("seed") || json["seed"] != seed)
        fail(file,
             fmt::format("seed {}; expected {}, the key's",
                         json.contains("seed") ? scene::printable(json["seed"].dump()) : "missing",
                         seed.dump()));
    std::map<std::string, std::string> answers;
    for (const auto& [number, value] : json["answers"].items()) {
        const bool known = std::any_of(key.begin(), key.end(),
                                       [&, n = number](const Key& k) { return k.number == n; });
        if (!known)
            fail(file, "an answer to question '" + scene::printable(number) + "'; expected 1.." +
                           key.back().number);
        answers[number] = answer_of(file, number, value);
    }
    return answers;
}

struct GradedAnswer {
    Key key;
    std::string given, grade;  ///< "right", "wrong", "missing"
};

struct GradedQuiz {
    Json seed;
    std::vector<GradedAnswer> answers;
    std::size_t right = 0;
    std::string error;  ///< why the student's file could not be read
    bool is_all_right() const { return right == answers.size(); }
};

/// Without answers, all are missing.
GradedQuiz graded(const std::filesystem::path& key_file,
                  const std::optional<std::filesystem::path>& answers_file) {
    GradedQuiz quiz;
    const std::vector<Key> keys = read_key(key_file, quiz.seed);
    std::map<std::string, std::string> answers;
    if (answers_file) answers = read_answers(*answers_file, keys, quiz.seed);
    for (const Key& key : keys) {
        const auto found = answers.find(key.number);
        const std::string given = found == answers.end() ? "" : found->second;
        const char* grade = given.empty() ? "missing" : given == key.answer ? "right" : "wrong";
        quiz.right += given == key.answer ? 1 : 0;
        quiz.answers.push_back({key, given, grade});
    }
    return quiz;
}

std::string text_of(const GradedQuiz& quiz) {
    std::vector<std::vector<std::string>> rows{{"question", "kind", "given", "", "expected"}};
    for (const auto& [key, given, grade] : quiz.answers)
        rows.push_back({key.number, key.kind, given.empty() ? "-" : given, grade,
                        given == key.answer ? "" : key.answer});
    return table(rows) + fmt::format("{} of {} right\n", quiz.right, quiz.answers.size());
}

std::string json_of(const GradedQuiz& quiz) {
    Json list = Json::array();
    for (const auto& [key, given, grade] : quiz.answers)
        list.push_back({{"number", key.number},
                        {"kind", key.kind},
                        {"given", given},
                        {"grade", grade},
                        {"expected", key.answer},
                        {"why", key.why}});
    Json json{{"right", quiz.right}, {"of", quiz.answers.size()}, {"answers", list}};
    if (!quiz.error.empty()) json["error"] = quiz.error;
    return json.dump(2) + "\n";
}

/// A student's answers: FOLDER/answers.json as in the handout, or FOLDER.json.
std::optional<std::filesystem::path> answers_in(const std::filesystem::path& all,
                                                const std::string& folder) {
    for (const std::filesystem::path& file :
         {all / folder / "answers.json", all / (folder + ".json")})
        if (scene::file_exists(file)) return file;
    return {};
}

/// A student's file that cannot be read costs this student's answers, and is a warning.
GradedQuiz graded_or_unreadable(const std::filesystem::path& key,
                                const std::optional<std::filesystem::path>& answers) {
    GradedQuiz missing = graded(key, {});
    try {
        return answers ? graded(key, answers) : missing;
    } catch (const Error& error) {
        missing.error = error.what();
        print_warning(escape_controls(missing.error));
        return missing;
    }
}

/// Names every file and folder that belongs to no student: a misspelt one would count as missing.
void warn_of_strangers(const std::filesystem::path& answers, const std::set<std::string>& folders) {
    std::set<std::filesystem::path> strangers;
    for (const auto& entry : std::filesystem::directory_iterator(answers)) {
        const std::filesystem::path name = entry.path().filename();
        const bool is_known =
            folders.count(name.string()) > 0 ||
            (name.extension() == ".json" && folders.count(name.stem().string()) > 0);
        if (!is_known && name.string().front() != '.') strangers.insert(entry.path());
    }
    for (const std::filesystem::path& path : strangers)
        print_warning(fmt::format("{}: belongs to no student; expected {}.json or {}/answers.json",
                                  escape_controls(path.string()), *folders.begin(),
                                  *folders.begin()));
}

std::vector<std::pair<std::string, GradedQuiz>> graded_class(const std::filesystem::path& keys,
                                                             const std::filesystem::path& answers) {
    if (!std::filesystem::is_directory(answers))
        fail(answers, "is no folder; expected one with a student's answers in each of its folders");
    std::set<std::string> folders;
    for (const auto& entry : std::filesystem::directory_iterator(keys))
        if (scene::file_exists(entry.path() / "key.json"))
            folders.insert(entry.path().filename().string());
    if (folders.empty())
        fail(keys, "has no folder with key.json; expected the answers of gw quiz --students");
    warn_of_strangers(answers, folders);
    std::vector<std::pair<std::string, GradedQuiz>> all;
    for (const std::string& folder : folders)
        all.emplace_back(
            folder, graded_or_unreadable(keys / folder / "key.json", answers_in(answers, folder)));
    return all;
}

/// A line for each student: the answers given, the wrong ones with what was expected.
std::vector<std::vector<std::string>> rows_of(
    const std::vector<std::pair<std::string, GradedQuiz>>& all) {
    std::size_t most = 0;
    for (const auto& [folder, quiz] : all) most = std::max(most, quiz.answers.size());
    std::vector<std::vector<std::string>> rows{{"student", "seed", "right", "of"}};
    for (std::size_t i = 1; i <= most; ++i) rows[0].push_back(std::to_string(i));
    for (const auto& [folder, quiz] : all) {
        rows.push_back({folder, quiz.seed.dump(), std::to_string(quiz.right),
                        std::to_string(quiz.answers.size())});
        for (const auto& [key, given, grade] : quiz.answers)
            rows.back().push_back(given == key.answer ? given
                                                      : fmt::format("{} (not {})", key.answer,
                                                                    !quiz.error.empty() ? "readable"
                                                                    : given.empty()     ? "answered"
                                                                                        : given));
        rows.back().resize(rows[0].size());
    }
    return rows;
}

std::string csv_of(const std::vector<std::vector<std::string>>& rows) {
    std::string text;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            text += fmt::format("\"{}\"{}", row[i], i + 1 == row.size() ? "\n" : ",");
    return text;
}

int grade_class(const GradeOptions& options) {
    const auto all = graded_class(options.key, options.answers);
    bool is_all_right = true;
    Json list = Json::object();
    for (const auto& [folder, quiz] : all) {
        is_all_right = is_all_right && quiz.is_all_right();
        list[folder] = Json::parse(json_of(quiz));
    }
    print(options.form == Form::Json  ? list.dump(2) + "\n"
          : options.form == Form::Csv ? csv_of(rows_of(all))
                                      : table(rows_of(all)));
    return is_all_right ? Done : Differs;
}

int grade(const GradeOptions& options) {
    if (std::filesystem::is_directory(options.key)) return grade_class(options);
    const GradedQuiz quiz = graded(options.key, options.answers);
    print(options.form == Form::Json ? json_of(quiz) : text_of(quiz));
    return quiz.is_all_right() ? Done : Differs;
}

}  // namespace

Command add_grade(CLI::App& app) {
    CLI::App* command = app.add_subcommand("grade", "Compares answers to a quiz with its key");
    const auto options = std::make_shared<GradeOptions>();
    command->add_option("KEY", options->key, "The key; of a class, the folder of the keys")
        ->required()
        ->type_name("KEY.json");
    command
        ->add_option("ANSWERS", options->answers,
                     "The answers; of a class, their folder: one line for each student")
        ->required()
        ->type_name("ANSWERS.json");
    add_form_options(*command, options->form, true);
    command->footer(
        "Exit code 3 unless all are right.\n"
        "Example:\n"
        "  build/release/bin/gw grade quiz/key.json quiz/handout/answers.json || test $? = 3");
    return {command, [options](Session&) { return grade(*options); }};
}

}  // namespace gw::apps
