// gw figures: every figure of the table is made, with its part of the page.
#include "apps/figures/figure_table.h"
#include "tests/apps/support/examples.h"

namespace gw::apps {

class Figures : public ExampleTest, public testing::WithParamInterface<std::string> {
protected:
    void expect_made(const std::string& folder, const Figure& figure) const {
        const std::string page = bytes_of(in(folder + "/index.html"));
        EXPECT_NE(page.find("<section id=\"" + figure.name + "\">"), page.npos);
        for (const Panel& panel : figure.panels)
            for (const Shown& shown : panel.pictures) {
                EXPECT_TRUE(
                    std::filesystem::exists(in(folder + "/" + figure.name + "/" + shown.file)))
                    << shown.file;
                EXPECT_NE(page.find("src=\"" + figure.name + "/" + shown.file + "\""), page.npos);
            }
        EXPECT_EQ(figure.text.find(".html"), std::string::npos) << "a page is a link";
        if (figure.page.empty()) return;
        const std::string address = figure.name + "/" + figure.page;
        EXPECT_TRUE(std::filesystem::exists(in(folder + "/" + address)));
        EXPECT_NE(page.find("<a href=\"" + address + "\">"), page.npos);
    }
};

std::vector<std::string> names_of_figures() {
    std::vector<std::string> names;
    for (const Figure& figure : figures()) names.push_back(figure.name);
    return names;
}

const Figure& named(const std::string& name) {
    return *std::find_if(figures().begin(), figures().end(),
                         [&](const Figure& f) { return f.name == name; });
}

TEST_P(Figures, IsMadeWithAllThatItShows) {
    const Outcome outcome = gw({"figures", "out", "--only", GetParam(), "--size", "16x12"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "out/index.html\n");
    expect_made("out", named(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(All, Figures, testing::ValuesIn(names_of_figures()),
                         [](const auto& test) { return test.param; });

TEST_F(Figures, OneAtATimeMakeTheSamePageInTheTablesOrder) {
    ASSERT_EQ(gw({"figures", "a", "--only", "fig1", "--size", "16x12"}).code, 0);
    const std::string first = bytes_of(in("a/index.html"));
    ASSERT_EQ(gw({"figures", "a", "--only", "edges"}).code, 0);
    ASSERT_EQ(gw({"figures", "a", "--only", "fig1", "--size", "16x12"}).code, 0);
    const std::string page = bytes_of(in("a/index.html"));
    EXPECT_EQ(first.find("id=\"edges\""), page.npos);
    expect_made("a", named("fig1"));
    expect_made("a", named("edges"));
    EXPECT_LT(page.find("id=\"fig1\""), page.find("id=\"edges\""));
}

TEST_F(Figures, CaptionsHaveTheCommandWhichMakesThePicture) {
    ASSERT_EQ(gw({"figures", "a", "--only", "fig1", "--size", "16x12"}).code, 0);
    const std::string page = bytes_of(in("a/index.html")), begin = "<code>",
                      picture = bytes_of(in("a/fig1/c.png"));
    EXPECT_NE(page.find(">8 passes; "), page.npos);
    const std::size_t at = page.rfind(begin) + begin.size();
    const std::string command =
        page.substr(at, page.find("</code>") == page.npos ? 0 : page.find("</code>", at) - at);
    EXPECT_EQ(command,
              "build/release/bin/gw render scenes/rings.toml -o a/fig1/c.png --size 16x12");
    std::filesystem::remove(in("a/fig1/c.png"));
    expect_to_work({command});
    EXPECT_EQ(bytes_of(in("a/fig1/c.png")), picture);
}

TEST_F(Figures, ListNamesAll) {
    const std::string list = gw({"figures", "--list"}).out;
    for (const Figure& figure : figures()) EXPECT_NE(list.find(figure.name + " "), list.npos);
}

TEST_F(Figures, RefuseWhatCannotBe) {
    expect_refused(2, {"figures"}, {"DIR is missing"});
    expect_refused(2, {"figures", "a", "--only", "fig99"}, {"--only 'fig99'", "fig1, fig4"});
    expect_refused(2, {"figures", "a", "--size", "0x0"}, {"--size '0x0'"});
    expect_refused(1, {"figures", "missing/a"}, {"missing"});
    write("file", "");
    expect_refused(1, {"figures", "file"}, {"file", "is not a folder"});
    std::filesystem::remove(in("scenes"));
    expect_refused(1, {"figures", "a"}, {"scenes", "root"});
}

}  // namespace gw::apps
