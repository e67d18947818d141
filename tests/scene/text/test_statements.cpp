// Claims: statements are found whatever the line ends, blanks, comments and continuations, with the
// line they begin on.
#include "scene/text/statements.h"

#include <gtest/gtest.h>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

Strings statements(const std::string& text) {
    Strings list;
    for (Statements in("f", text); in.next();)
        list.push_back(std::to_string(in.line()) + ":" + std::string(in.keyword()) + "|" +
                       std::string(in.rest()));
    return list;
}

}  // namespace

TEST(Statements, AreOneForEachLine) {
    EXPECT_EQ(statements("v 1 2 3\n\n# comment\n  f\t1 2 3  \nend"),
              (Strings{"1:v|1 2 3", "4:f|1 2 3", "5:end|"}));
}

TEST(Statements, MayEndLikeWindowsLines) {
    EXPECT_EQ(statements("v 1\r\n\r\nf 2\r\n"), (Strings{"1:v|1", "3:f|2"}));
}

TEST(Statements, GoOnAfterABackslash) {
    EXPECT_EQ(statements("f 1 2\\\n 3 \\\r\n4\nv 5\n"), (Strings{"1:f|1 2 3  4", "4:v|5"}));
    EXPECT_EQ(statements("f 1 \\"), (Strings{"1:f|1"}));
    EXPECT_EQ(statements("f 1 \\\n"), (Strings{"1:f|1"}));
    EXPECT_EQ(statements("# comment \\\nv 1"), (Strings{"2:v|1"}));
}

TEST(TakeWord, StopsAtACommentButNotInsideAWord) {
    std::string_view text = " a  b#c #d e";
    EXPECT_EQ(take_word(text), "a");
    EXPECT_EQ(take_word(text), "b#c");
    EXPECT_EQ(take_word(text), "");
    EXPECT_EQ(take_word(text), "");
}

}  // namespace gw::scene
