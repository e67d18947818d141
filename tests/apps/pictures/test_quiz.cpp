// Claims: a quiz's handout tells no answer and its key grades itself; the page to print has every
// question in both languages; each student of a class has a quiz, and the class a report.
#include "apps/command/page_style.h"
#include "apps/hidden/page.h"
#include "hiddensurface/quiz/quiz.h"
#include "tests/apps/support/command_test.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

using QuizFiles = CommandTest;

TEST_F(QuizFiles, MakesAQuizThatGradesItself) {
    const Outcome outcome = gw({"quiz", "q", "--seed", "3", "--questions", "7"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> expected{"answers.html", "handout", "index.html", "index.json",
                                      "key.json"};
    const bool has_pages = !embedded_page("player.html").empty();
    if (has_pages) expected.push_back("practice.html");
    for (int i = 1; has_pages && i <= 7; ++i)
        expected.push_back("steps_0" + std::to_string(i) + ".html");
    EXPECT_EQ(names("q"), expected);
    const auto handout = names("q/handout");
    EXPECT_EQ(handout.size(), 4u + 4u * 7u);
    // Nothing in the handout tells the answers: the form is empty, the questions have none.
    const auto form = nlohmann::json::parse(bytes_of(in("q/handout/answers.json")));
    for (const auto& answer : form["answers"]) EXPECT_EQ(answer, "");
    const auto asked = nlohmann::json::parse(bytes_of(in("q/handout/questions.json")));
    EXPECT_EQ(asked["questions"].size(), 7u);
    for (const auto& question : asked["questions"]) EXPECT_FALSE(question.contains("answer"));
    // The key's own answers are all right; the empty form is all missing; one wrong answer is told.
    const auto key = nlohmann::json::parse(bytes_of(in("q/key.json")));
    nlohmann::json mine{{"seed", 3}};
    for (const auto& a : key["answers"])
        mine["answers"][std::to_string(a["number"].get<int>())] = a["answer"];
    write("mine.json", mine.dump());
    EXPECT_EQ(gw({"grade", "q/key.json", "mine.json"}).code, 0);
    const Outcome empty = gw({"grade", "q/key.json", "q/handout/answers.json"});
    EXPECT_EQ(empty.code, 3);
    EXPECT_NE(empty.out.find("0 of 7 right"), std::string::npos);
    mine["answers"]["3"] = 99;
    write("mine.json", mine.dump());
    const Outcome wrong = gw({"grade", "q/key.json", "mine.json", "--json"});
    EXPECT_EQ(wrong.code, 3);
    EXPECT_EQ(nlohmann::json::parse(wrong.out)["right"], 6);
    EXPECT_EQ(nlohmann::json::parse(wrong.out)["answers"][2]["grade"], "wrong");
    // The scene of a question is one of gw's, with the same picture.
    const Outcome scene =
        gw({"hidden", "q/handout/scene_01.toml", "--algorithm", "newell", "--json"});
    EXPECT_EQ(scene.code, 0) << scene.err;
    EXPECT_EQ(nlohmann::json::parse(scene.out)[0]["counts"]["polygons"], 4);
    // Again, the same bytes.
    EXPECT_EQ(gw({"quiz", "again", "--seed", "3", "--questions", "7"}).code, 0);
    for (const std::string& name : handout)
        EXPECT_EQ(bytes_of(in("again/handout/" + name)), bytes_of(in("q/handout/" + name))) << name;
    EXPECT_EQ(bytes_of(in("again/key.json")), bytes_of(in("q/key.json")));
}

// The page has every question in both languages with a drawing, and no answer; the answers lead to
// the step that decides.
TEST_F(QuizFiles, QuizIsAPageToPrint) {
    ASSERT_EQ(gw({"quiz", "q", "--seed", "3", "--questions", "14"}).code, 0);
    const std::string handout = bytes_of(in("q/handout/quiz.html")),
                      answers = bytes_of(in("q/answers.html"));
    const auto count = [](const std::string& text, const std::string& part) {
        int times = 0;
        for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++times;
        return times;
    };
    EXPECT_EQ(count(handout, "<article>"), 14);
    EXPECT_EQ(count(handout, "<svg "), 14);
    EXPECT_EQ(count(handout, "<p lang=\"en\">"), 14);
    EXPECT_EQ(count(handout, "<p lang=\"ja\">"), 14);
    EXPECT_EQ(count(handout, "class=\"given\""), 0);
    EXPECT_EQ(handout.find("#step="), handout.npos);
    EXPECT_EQ(handout.find("<script"), handout.npos);
    // It looks as all pages do.
    for (const std::string& page : {handout, answers})
        EXPECT_NE(page.find(embedded_style("page.css")), page.npos);
    EXPECT_EQ(count(answers, "class=\"given\""), 14);
    if (!embedded_page("player.html").empty()) {
        EXPECT_EQ(count(answers, "#step="), 14);
    }
    const auto key = nlohmann::json::parse(bytes_of(in("q/key.json")));
    for (const auto& a : key["answers"])
        EXPECT_EQ(handout.find(a["why"].get<std::string>()), handout.npos);
    // In one language nothing of the other is on the pages.
    ASSERT_EQ(gw({"quiz", "ja", "--seed", "3", "--questions", "7", "--language", "ja"}).code, 0);
    ASSERT_EQ(gw({"quiz", "en", "--seed", "3", "--questions", "7", "--language", "en"}).code, 0);
    for (const std::string page : {"handout/quiz.html", "handout/questions.txt", "answers.html"}) {
        const std::string japanese = bytes_of(in("ja/" + page)),
                          english = bytes_of(in("en/" + page));
        EXPECT_EQ(japanese.find("lang=\"en\""), japanese.npos) << page;
        for (const char* word : {"Answer with", "seed ", "Picture", "scene:", "Corners"})
            EXPECT_EQ(japanese.find(word), japanese.npos) << word << " in " << page;
        EXPECT_EQ(english.find("\xE3\x80\x82"), english.npos) << page;  // the Japanese full stop
        // A question's kind is called by its title.
        for (const std::string& kind : hiddensurface::quiz_kinds()) {
            const auto& title = hiddensurface::title_of_kind(kind);
            EXPECT_NE(japanese.find(title.ja), japanese.npos) << kind << " in " << page;
            EXPECT_NE(english.find(title.en), english.npos) << kind << " in " << page;
            EXPECT_EQ(japanese.find("(" + kind + ")"), japanese.npos) << kind << " in " << page;
        }
    }
    expect_refused(2, {"quiz", "p", "--language", "de"}, {"--language 'de'", "en, ja"});
    expect_refused(2, {"quiz", "p", "--export", "qtx"}, {"--export 'qtx'", "moodle"});
    EXPECT_FALSE(std::filesystem::exists(in("p")));
    // Drawings say in words what they show.
    EXPECT_EQ(count(handout, "aria-label=\"A drawing of "), 14);
    // Hidden sides are broken lines where surfaces are shown.
    EXPECT_GE(count(handout, "class=\"hidden\""), 14);
}

TEST_F(QuizFiles, EveryStudentHasAQuizAndTheClassAReport) {
    write("class.csv", "name,seed\n\"Ann\",5\n../Bo b,\xE6\xA3\xAE\n");
    expect_refused(1, {"quiz", "q", "--students", "class.csv"},
                   {"class.csv:3: ", "expected a whole number"});
    write("class.csv", "name,seed\nAnn,5\n../Bo b\n\xE6\xA3\xAE\n");
    const Outcome made =
        gw({"quiz", "q", "--students", "class.csv", "--seed", "8", "--questions", "2"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(bytes_of(in("q/class.csv")),
              "student,seed,folder\n\"Ann\",5,01_Ann\n\"../Bo b\",9,02____Bo_b\n"
              "\"\xE6\xA3\xAE\",10,03_\xE6\xA3\xAE\n");
    ASSERT_EQ(gw({"quiz", "five", "--seed", "5", "--questions", "2"}).code, 0);
    EXPECT_EQ(bytes_of(in("q/handout/01_Ann/questions.json")),
              bytes_of(in("five/handout/questions.json")));
    // Ann is right, Bo has one wrong, the third gave none.
    const auto give = [&](const std::string& folder, bool spoil) {
        const auto key = nlohmann::json::parse(bytes_of(in("q/answers/" + folder + "/key.json")));
        nlohmann::json mine{{"seed", key["seed"]}};
        for (const auto& a : key["answers"])
            mine["answers"][std::to_string(a["number"].get<int>())] = a["answer"];
        if (spoil) mine["answers"]["2"] = "z";
        write("given/" + folder + ".json", mine.dump());
    };
    std::filesystem::create_directory(in("given"));
    give("01_Ann", false);
    give("02____Bo_b", true);
    const Outcome report = gw({"grade", "q/answers", "given", "--csv"});
    EXPECT_EQ(report.code, 3);
    EXPECT_EQ(report.err, "");
    EXPECT_EQ(report.out.substr(0, report.out.find('\n')),
              "\"student\",\"seed\",\"right\",\"of\",\"1\",\"2\"");
    EXPECT_NE(report.out.find("\"01_Ann\",\"5\",\"2\",\"2\","), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("\"02____Bo_b\",\"9\",\"1\",\"2\","), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("(not z)"), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("\",\"10\",\"0\",\"2\","), report.out.npos) << report.out;
    // A misspelt file is named: its student counts as one without answers.
    write("given/1_Ann.json", "{}");
    EXPECT_EQ(gw({"grade", "q/answers", "given", "--csv"}).err,
              "gw: warning: given/1_Ann.json: belongs to no student; expected 01_Ann.json or "
              "01_Ann/answers.json\n");
    expect_refused(1, {"grade", "q/handout", "given"}, {"q/handout", "key.json"});
    expect_refused(1, {"grade", "q/answers", "class.csv"}, {"class.csv", "folder"});
    expect_refused(2, {"quiz", "p", "--students", "0"}, {"--students '0'"});
    expect_refused(1, {"quiz", "p", "--students", "none.csv"}, {"none.csv"});
}

// A heading, names with commas, with and without a seed.
TEST_F(QuizFiles, ReadsQuotedNamesOfAClass) {
    write("class.csv", "name,seed\n\"Li, Wei\"\n\"M\xC3\xBCller, Anna\",5\nMori,6\n\"Abe\"\n");
    ASSERT_EQ(gw({"quiz", "q", "--students", "class.csv", "--seed", "8", "--questions", "1"}).code,
              0);
    EXPECT_EQ(bytes_of(in("q/class.csv")),
              "student,seed,folder\n\"Li, Wei\",8,01_Li__Wei\n"
              "\"M\xC3\xBCller, Anna\",5,02_M\xC3\xBCller__Anna\n\"Mori\",6,03_Mori\n"
              "\"Abe\",11,04_Abe\n");
}

// A file that nobody can read costs its student's answers only.
TEST_F(QuizFiles, GradesAClassWithAnUnreadableFile) {
    ASSERT_EQ(gw({"quiz", "q", "--students", "3", "--questions", "2"}).code, 0);
    std::filesystem::create_directory(in("given"));
    for (const std::string student : {"01", "02", "03"}) {
        const auto key = nlohmann::json::parse(bytes_of(in("q/answers/" + student + "/key.json")));
        nlohmann::json mine{{"seed", key["seed"]}};
        for (const auto& a : key["answers"])
            mine["answers"][std::to_string(a["number"].get<int>())] = a["answer"];
        write("given/" + student + ".json", mine.dump() + (student == "02" ? "," : ""));
    }
    const Outcome report = gw({"grade", "q/answers", "given", "--csv"});
    EXPECT_EQ(report.code, 3);
    EXPECT_NE(report.out.find("\"01\",\"1\",\"2\",\"2\","), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("\"02\",\"2\",\"0\",\"2\","), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("(not readable)"), report.out.npos) << report.out;
    EXPECT_NE(report.out.find("\"03\",\"3\",\"2\",\"2\","), report.out.npos) << report.out;
    const std::string why = "02.json:1: is not JSON at ','; expected JSON that gw quiz wrote\n";
    EXPECT_TRUE(report.err.ends_with(why)) << report.err;
    for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
             {"{\n\"seed\": 2,\n\"answers\": {,}}", "02.json:3: is not JSON at ',}}'; "},
             {"{\n\"seed\": 2", "02.json:2: ends too early; "},
             {"", "02.json:1: ends too early; "},
             {"{\"seed\": 1e999}", "02.json: has a number that is too large; "}}) {
        write("given/02.json", text);
        const std::string err = gw({"grade", "q/answers", "given", "--csv"}).err;
        EXPECT_NE(err.find(said), err.npos) << err;
    }
    const Outcome json = gw({"grade", "q/answers", "given", "--json"});
    const auto all = nlohmann::json::parse(json.out);
    EXPECT_NE(all["02"]["error"].get<std::string>().find("expected JSON"), std::string::npos);
    EXPECT_FALSE(all["01"].contains("error"));
}

TEST_F(QuizFiles, RefusesAnswersThatFitNoKey) {
    ASSERT_EQ(gw({"quiz", "q", "--seed", "3", "--questions", "2"}).code, 0);
    const auto refused = [&](const std::string& text, const std::string& part) {
        write("mine.json", text);
        expect_refused(1, {"grade", "q/key.json", "mine.json"}, {"mine.json", part, "expected"});
    };
    refused("{", "expected JSON");
    refused("[]", "no answers");
    refused(R"({"seed": 4, "answers": {}})", "seed 4");
    refused(R"({"answers": {}})", "seed missing");
    refused(R"({"seed": 3, "answers": {"9": "a"}})", "'9'");
    refused(R"({"seed": 3, "answers": {"1": {"a": 1}}})", "answer 1");
    refused(R"({"seed": 3, "answers": {"1": 1.5}})", "answer 1");
    expect_refused(1, {"grade", "q/handout/answers.json", "mine.json"},
                   {"answers.json", "expected a key"});
    expect_refused(1, {"grade", "none.json", "mine.json"}, {"none.json"});
}

}  // namespace gw::apps
