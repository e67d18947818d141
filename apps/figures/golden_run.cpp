#include "apps/figures/golden_run.h"

#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/terminal.h"
#include "apps/figures/panel_words.h"
#include "gw/error.h"
#include "gw/profile.h"

#include <fmt/format.h>

#include <cstdlib>
#include <set>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

/// A folder for the pictures, which are not looked at.
class Scratch {
public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "gw-golden-XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw Error(name + ": cannot be made; expected a folder for pictures");
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

std::vector<std::string> small_words(const Panel& panel, const Profile& profile,
                                     const fs::path& folder) {
    std::vector<std::string> words = words_of(panel, folder);
    words.push_back("--quiet");
    if (words[0] == "study") {
        set_option(words, "--samples", "4");
        return words;
    }
    set_option(words, "--size", "96x72");
    set_option(words, "--profile", profile.name);
    if (option_in(words, "--samples")) set_option(words, "--samples", "2");
    if (words[0] == "radiosity")
        for (const auto& [option, value] :
             {std::pair{"--shots", "2"}, {"--hemicube", "16"}, {"--threads", "1"}})
            set_option(words, option, value);
    return words;
}

std::vector<inspect::Recording> run_panel(const Panel& panel, const Profile& profile) {
    const Scratch scratch;
    const SilenceStdout muted;
    CommandRecorder recorder;
    const std::vector<std::string> words = small_words(panel, profile, scratch.folder());
    if (run_command({.words = words, .recorder = &recorder, .is_inner = true}) != Done)
        throw Error("gw " + panel.command + ": does not work");
    return recorder.take(words[1], words[0]);
}

}  // namespace

std::vector<GoldenRecording> run_golden_panel(const Figure& figure, std::size_t index,
                                              const std::vector<Profile>& profiles) {
    const Panel& panel = figure.panels[index];
    const bool has_profile = !panel.command.starts_with("study ");
    std::vector<GoldenRecording> all;
    std::set<std::string> taken;
    for (const Profile& profile : profiles) {
        const bool first = profile == gw::profiles().front();
        if (!first && !has_profile) continue;
        for (inspect::Recording& r : run_panel(panel, profile)) {
            if (!first && r.profile != profile) continue;
            const std::string stem = fmt::format("{}_{}", index + 1, r.profile.name);
            std::string name = stem;
            for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
            all.push_back({fs::path(figure.name) / (name + ".json"), std::move(r)});
        }
    }
    return all;
}

}  // namespace gw::apps
