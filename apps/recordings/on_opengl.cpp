#include "apps/recordings/on_opengl.h"

#include "apps/command/table.h"
#include "gw/error.h"
#include "gw/reference/make.h"
#include "inspect/compare/classify.h"
#include "inspect/compare/difference_classes.h"
#include "inspect/peer/player.h"
#include "inspect/replay/plane_values.h"
#include "inspect/replay/player.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

/// An implementation of OpenGL as a machine that only executes.
class OpenglMachine : public Machine {
public:
    OpenglMachine(const inspect::Recording& r, const std::string& implementation)
        : player(r.profile, r.width, r.height, implementation), profile_(r.profile) {}
    void execute(const CommandList& list) override { player.play(list); }
    const Planes& planes() override { return planes_ = player.planes(); }
    const std::vector<PassReport>& passes() override { return passes_; }
    void reset_passes() override {}
    const std::map<std::uint32_t, Readback>& readbacks() override { return readbacks_; }
    void read_into(std::uint32_t, std::span<std::uint32_t>, ReadLayout) override {}
    const Profile& profile() const override { return profile_; }

    peer::Player player;

private:
    Profile profile_;
    Planes planes_;
    std::vector<PassReport> passes_;
    std::map<std::uint32_t, Readback> readbacks_;
};

/// A cause in the manual's words, and where it explains the difference.
struct Explained {
    const char *name, *place;
};
constexpr std::array<Explained, inspect::cause_count> causes{{
    {"coverage", "rasterization.md#coverage: which centres on a side are inside; ends of lines"},
    {"colour", "fragments.md#blending, rasterization.md#planes: roundings"},
    {"texture", "texture.md#textures: filter weights of 8 bits, roundings"},
    {"antialiasing", "rasterization.md#antialiasing: exact areas here"},
    {"Z", "rasterization.md#planes: depths within 3/4 unit here, often float32 there"},
    {"stencil", "fragments.md#alpha-stencil-and-depth-tests: follows coverage and Z"},
}};

std::vector<std::string> row_of(const std::string& pass, const Planes& ours, const Planes& theirs,
                                Plane colors) {
    std::vector<std::string> row{pass};
    for (const Plane plane : {colors, Plane::Depth, Plane::Stencil}) {
        const inspect::Differences d = inspect::classify(ours, theirs, plane);
        for (const std::uint64_t count : {d.rounding, d.edge, d.other, d.worst})
            row.push_back(std::to_string(count));
    }
    return row;
}

std::string table_of(const inspect::CauseTallies& tallies) {
    std::vector<std::vector<std::string>> rows{{"cause", "pixels", "mean", "largest"}};
    std::string places;
    for (std::size_t i = 0; i < causes.size(); ++i) {
        const inspect::CauseTally& t = tallies[i];
        if (t.pixels == 0) continue;
        rows.push_back({causes[i].name, std::to_string(t.pixels), fmt::format("{:.2f}", t.mean()),
                        std::to_string(t.largest)});
        places += fmt::format("{}: docs/manual/{}\n", causes[i].name, causes[i].place);
    }
    return table(rows) + "\n" + places;
}

class Comparison {
public:
    Comparison(const inspect::Recording& recording, const OnOpengl& options)
        : recording_(recording),
          passes_(inspect::pass_ranges(recording)),
          painted_(recording),
          ours_(reference::make(recording.profile, recording.width, recording.height, &painted_)),
          theirs_(recording, options.implementation),
          first_(options.passes ? std::size_t(options.passes->first) : 0),
          last_(options.passes ? std::size_t(options.passes->second) : passes_.size()) {
        if (options.passes && last_ >= passes_.size())
            throw Error(fmt::format("the recording has {}; expected passes below {}",
                                    inspect::plural(passes_.size(), "pass", "passes"),
                                    passes_.size()));
    }

    OpenglComparison run() {
        inspect::Player our_player(recording_, *ours_), their_player(recording_, theirs_);
        for (std::size_t i = 0; i < passes_.size() && i <= last_; ++i) {
            our_player.play_to(passes_[i].end);
            their_player.play_to(passes_[i].end);
            if (i >= first_) compare(passes_[i].name);
        }
        return {.text = text(), .same = same_, .worst = worst_};
    }

private:
    void compare(const std::string& pass) {
        const Planes &ours = ours_->planes(), &theirs = theirs_.planes();
        const Plane colors = painted_.main_plane();
        rows_.push_back(row_of(pass, ours, theirs, colors));
        const auto tallies = inspect::tally_causes(ours, theirs, colors, painted_.of(colors));
        for (const inspect::CauseTally& t : tallies) same_ = same_ && t.pixels == 0;
        add(total_, tallies);
        const std::uint64_t pixels = inspect::classify(ours, theirs, colors).pixels();
        if (pixels < worst_.pixels || (pixels == 0 && !worst_.distances.empty())) return;
        worst_ = {pass, pixels, inspect::distances(ours, theirs, colors)};
    }

    std::string text() const {
        std::vector<std::vector<std::string>> rows{{"pass"}};
        for (const char* plane : {"colour", "Z", "stencil"})
            for (const char* what : {"rounding", "edge", "other", "worst"})
                rows[0].push_back(fmt::format("{} {}", plane, what));
        rows.insert(rows.end(), rows_.begin(), rows_.end());
        std::string out = fmt::format("{}: pixels of {} that differ after each pass\n{}",
                                      theirs_.player.renderer(),
                                      recording_.width * recording_.height, table(rows));
        if (same_) return out + "no differences\n";
        return out + "\nby cause, all passes together; units of a channel or of Z\n" +
               table_of(total_) + "docs/manual/differences.md#against-mesa measures each cause\n";
    }

    const inspect::Recording& recording_;
    std::vector<inspect::PassRange> passes_;
    inspect::Painted painted_;
    std::unique_ptr<Machine> ours_;
    OpenglMachine theirs_;
    std::size_t first_, last_;

    std::vector<std::vector<std::string>> rows_;
    inspect::CauseTallies total_{};
    WorstPass worst_;
    bool same_ = true;
};

}  // namespace

OpenglComparison compare_on_opengl(const inspect::Recording& recording, const OnOpengl& options) {
    return Comparison(recording, options).run();
}

}  // namespace gw::apps
