// gw describe: the forms hold every command and option, and the shell that reads them completes
// what they say.
#include "test_paths.h"
#include "tests/apps/support/command_test.h"
#include "tests/apps/support/examples.h"
#include "tests/temporary_folder.h"

#include <cstdio>

namespace gw::apps {
namespace {

class Describe : public ExampleTest {
protected:
    std::string described(const std::string& form) {
        const Outcome outcome = gw({"describe", form});
        EXPECT_EQ(outcome.code, 0);
        return outcome.out;
    }

    /// What bash offers for the last of these words.
    std::string completed(const std::string& words, int count) {
        const TemporaryFolder folder;
        const std::filesystem::path script =
            folder.write("describe.bash", described("bash") + "COMP_WORDS=(" + words +
                                              ") COMP_CWORD=" + std::to_string(count - 1) +
                                              "\n_gw\necho \"${COMPREPLY[@]}\"\n");
        std::FILE* pipe = popen(("bash " + script.string()).c_str(), "r");
        char line[4096] = "";
        const char* read = std::fgets(line, sizeof line, pipe);
        EXPECT_EQ(pclose(pipe), 0);
        return read ? read : "";
    }
};

}  // namespace

TEST_F(Describe, BashCompletesCommandsOptionsAndTheirWords) {
    EXPECT_EQ(completed("gw re", 2), "render record replay\n");
    EXPECT_EQ(completed("gw render --prof", 3), "--profile\n");
    EXPECT_EQ(completed("gw render --profile ''", 4), "vgx reality ideal opengl\n");
    EXPECT_EQ(completed("gw passes --machine r", 4), "reference\n");
    EXPECT_EQ(completed("gw render " GW_SOURCE_DIR "/scenes/teapot.t", 3),
              GW_SOURCE_DIR "/scenes/teapot.toml\n");
}

TEST_F(Describe, EveryFormNamesEveryCommand) {
    for (const char* form : {"bash", "zsh", "man"})
        for (const char* command : {"render", "hidden", "radiosity", "describe"})
            EXPECT_NE(described(form).find(command), std::string::npos) << form << " " << command;
}

TEST_F(Describe, TheManPageHasNoLineThatRoffTakesForAnUnknownRequest) {
    const std::string page = described("man");
    for (std::size_t at = page.find("\n."); at != page.npos; at = page.find("\n.", at + 1)) {
        const std::string request = page.substr(at + 1, 3);
        EXPECT_TRUE(request == ".TP" || request == ".SS" || request == ".SH" || request == ".PP" ||
                    request == ".br" || request == ".TH" || request == ".B ")
            << page.substr(at, 40);
    }
}

TEST_F(Describe, AnUnknownFormIsRefused) {
    const Outcome outcome = gw({"describe", "fish"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("bash"), std::string::npos);
}

}  // namespace gw::apps
