// gw hidden --grade and --fragments: compares students' answers with the key, and their fragments
// with the Z-buffer's.
#include "apps/command/command.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "gw/error.h"
#include "gw/shown.h"
#include "hiddensurface/quiz/fragments.h"
#include "hiddensurface/quiz/quiz.h"
#include "image/write.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
    } catch (const nlohmann::json::exception& error) {
        fail(file,
             scene::printable(error.what(), 200) + "; expected JSON that gw hidden --quiz wrote");
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
        if (key.empty()) fail(file, "no answers; expected a key that gw hidden --quiz wrote");
        return key;
    } catch (const nlohmann::json::exception& error) {
        fail(file,
             scene::printable(error.what(), 200) + "; expected a key that gw hidden --quiz wrote");
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

/// A reason why most pixels are wrong, if they are; a list of another size often is.
std::string hint_of(const hs::FragmentGrade& grade, const Size& size) {
    if (2 * grade.right >= grade.expected) return "";
    return fmt::format(
        "most pixels are wrong: was the list made with --size {}x{} and with this camera?\n",
        size.width, size.height);
}

std::string text_of(const hs::FragmentGrade& grade, const std::string& name) {
    constexpr std::size_t most = 20;
    std::string text = fmt::format(
        "expected {}\nright {}\nmissing {}\ndoubled {}\nmisplaced {}\nwrong {}\n", grade.expected,
        grade.right, grade.missing, grade.doubled, grade.misplaced, grade.wrong);
    for (std::size_t i = 0; i < grade.mistakes.size() && i < most; ++i) {
        const hs::FragmentMistake& m = grade.mistakes[i];
        text += m.line > 0 ? fmt::format("{}:{}: ", name, m.line) : name + ": ";
        text += fmt::format("{}: {},{}", hs::name_of(m.mistake), m.x, m.y);
        if (m.given != 0) text += fmt::format(" polygon {}", m.given);
        text += m.expected != 0 ? fmt::format("; expected polygon {}\n", m.expected)
                                : "; expected none\n";
    }
    if (grade.mistakes.size() > most)
        text += fmt::format("and {} more\n", grade.mistakes.size() - most);
    return text;
}

std::string json_of(const hs::FragmentGrade& grade) {
    Json json{{"expected", grade.expected},   {"right", grade.right},
              {"missing", grade.missing},     {"doubled", grade.doubled},
              {"misplaced", grade.misplaced}, {"wrong", grade.wrong}};
    json["mistakes"] = Json::array();
    for (const hs::FragmentMistake& m : grade.mistakes)
        json["mistakes"].push_back({{"mistake", hs::name_of(m.mistake)},
                                    {"x", m.x},
                                    {"y", m.y},
                                    {"line", m.line},
                                    {"given", m.given},
                                    {"expected", m.expected}});
    return json.dump(2) + "\n";
}

/// The darkened picture with the mistakes in --compare's colours: wrong red, doubled yellow,
/// misplaced cyan, missing blue.
image::Picture marked(image::Picture picture, const hs::FragmentGrade& grade) {
    for (std::uint16_t& v : picture.values) v = static_cast<std::uint16_t>(v / 3);
    for (const hs::FragmentMistake& m : grade.mistakes) {
        const Color color = m.mistake == hs::Mistake::Wrong       ? red
                            : m.mistake == hs::Mistake::Doubled   ? yellow
                            : m.mistake == hs::Mistake::Misplaced ? cyan
                                                                  : blue;
        put(picture, pixel_index(m.x, picture.height - 1 - m.y, picture.width), color);
    }
    return picture;
}

}  // namespace

namespace {

struct GradedAnswer {
    Key key;
    std::string given, grade;  ///< "right", "wrong", "missing"
};

struct GradedQuiz {
    Json seed;
    std::vector<GradedAnswer> answers;
    std::size_t right = 0;
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
    return Json{{"right", quiz.right}, {"of", quiz.answers.size()}, {"answers", list}}.dump(2) +
           "\n";
}

/// A student's answers: FOLDER/answers.json as in the handout, or FOLDER.json.
std::optional<std::filesystem::path> answers_in(const std::filesystem::path& all,
                                                const std::string& folder) {
    for (const std::filesystem::path& file :
         {all / folder / "answers.json", all / (folder + ".json")})
        if (scene::file_exists(file)) return file;
    return {};
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
                                  shown(path.string()), *folders.begin(), *folders.begin()));
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
        fail(keys, "has no folder with key.json; expected the answers of gw hidden --students");
    warn_of_strangers(answers, folders);
    std::vector<std::pair<std::string, GradedQuiz>> all;
    for (const std::string& folder : folders)
        all.emplace_back(folder, graded(keys / folder / "key.json", answers_in(answers, folder)));
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
            rows.back().push_back(
                given == key.answer
                    ? given
                    : fmt::format("{} (not {})", key.answer, given.empty() ? "answered" : given));
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

int grade_class(const HiddenOptions& options) {
    const auto all = graded_class(options.grade[0], options.grade[1]);
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

}  // namespace

int hidden_grade(const HiddenOptions& options) {
    if (std::filesystem::is_directory(options.grade[0])) return grade_class(options);
    const GradedQuiz quiz = graded(options.grade[0], options.grade[1]);
    print(options.form == Form::Json ? json_of(quiz) : text_of(quiz));
    return quiz.is_all_right() ? Done : Differs;
}

int hidden_fragments(const HiddenOptions& options, Session& session) {
    if (!options.marked.empty()) check_picture_target(options.marked);
    if (!options.truth.empty()) image::check_target(options.truth);
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    session.inputs.add(options.fragments);
    for (const auto& target : {options.truth, options.marked}) session.inputs.check(target);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    hs::StepLog none;
    const auto z_buffer = hs::run_on(*make_machine(options.picture, profile, session),
                                     hs::algorithm_named("z-buffer"), input, none)
                              .ids;
    if (!options.truth.empty())
        image::write_file(options.truth, hs::fragments_text(z_buffer, input));
    if (options.fragments.empty()) return Done;
    const std::string name = options.fragments.string();
    const auto grade = hs::grade_fragments(
        hs::read_fragments(name, scene::read_text(options.fragments), input), z_buffer, input);
    if (!options.marked.empty())
        image::write_picture(options.marked,
                             marked(picture_of_ids(input, z_buffer, flat_colors(input)), grade));
    print(options.form == Form::Json
              ? json_of(grade)
              : text_of(grade, shown(name)) + hint_of(grade, options.picture.size));
    return grade.all_right() ? Done : Differs;
}

}  // namespace gw::apps
