// Claims: characters beyond ASCII are accepted in strings and comments of a TOML scene only; toml++
// sees none that it cannot handle.
#include "scene/toml/toml_text.h"

#include <gtest/gtest.h>

#include "scene/toml/read_scene.h"
#include "tests/scene/folder.h"

namespace gw::scene {

TEST(TomlText, KeepsStringsAndEmptiesComments) {
    EXPECT_EQ(toml_text("f", "a = 'é' # é\nb = \"\\\"é\" # \""),
              "a = 'é' # ??\nb = \"\\\"é\" # \"");
    EXPECT_EQ(toml_text("f", "a = '''é'\n'é''' # ü"), "a = '''é'\n'é''' # ??");
    EXPECT_EQ(toml_text("f", "a = \"\"\"#é\"\"\"\"\" # \"é"), "a = \"\"\"#é\"\"\"\"\" # \"??");
    EXPECT_EQ(toml_text("f", "a = [ '', \"\", '#é' ]"), "a = [ '', \"\", '#é' ]");
    EXPECT_EQ(toml_text("f", "a = 'open # é\nb = 1 # é"), "a = 'open # é\nb = 1 # ??");
}

// Every place for a string in TOML.
TEST(TomlText, KnowsWhereStringsBegin) {
    for (const std::string text :
         {"a = 'é'", "'é' = 'é'", "a.'é' . 'é' = 1", "['é'.\"é\"]\n[[ 'é' ]]",
          "a = ['é', 'é',\n'é',\n # '\n 'é' ]",
          "a = { 'é' = 'é', b.'é' = [ 'é' ], c = { 'é' = 1 }, 'é' = 2 }",
          "a = [[1, 2], ['é']]\n'é' = 2", "a = 1979-05-27 07:32:00 \n'é' = +1",
          "a = [{b = 'é'}, {'é' = 1}]\n[a.'é']\nb='é'"})
        EXPECT_EQ(toml_text("f", text), text);
}

TEST(TomlText, IsReadAsItWasWritten) {
    const Folder folder;
    const auto file =
        folder.write("s.toml",
                     "name = \"Zimmer für zwei\" # größer\n[material.\"grün\"]\nKd = [ 1, # "
                     "é\n 0, 1]\n[[object]]\nshape = 'box'\n");
    EXPECT_EQ(read_scene(file).scene.name, "Zimmer für zwei");
}

// U+00E9, U+035A and U+FC3F: where toml++ has undefined behaviour or an error.
TEST(TomlText, NamesTheLineOfACharacterOutsideOfStrings) {
    const Folder folder;
    for (const char* text :
         {"\nclé = 1\n", "\n[camera] é\n", "\nbackground = [0.1, \xcd\x9a]\n",
          "\n[[lig\xef\xb0\xbf]]\n", "\nKd = +'é'", "\na = 'b''é'", "\na = 0.'é'", "\na = [0.'é']",
          "\na = 0{'é' = 1}", "\na = =['é']", "\na = 1 'é'", "'a' = 1 # é\n  é"})
        EXPECT_EQ(
            folder.scene_error("s.toml", text),
            "s.toml:2: a character beyond ASCII outside of a string; expected quotation marks around it")
            << text;
    for (const char* text : {"name = \"\"\"a\\\n  é\"\"\"", "\nname = \"\"\"a\\é\"\"\""})
        EXPECT_EQ(
            folder.scene_error("s.toml", text),
            "s.toml:2: a character beyond ASCII after a backslash; expected it in the line before")
            << text;
}

}  // namespace gw::scene
