#include "apps/recordings/osmesa.h"

#include "apps/command/table.h"
#include "inspect/compare/classify.h"
#include "inspect/peer/player.h"
#include "inspect/replay/player.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

/// Mesa as a machine that only executes.
class MesaMachine : public Machine {
public:
    explicit MesaMachine(const inspect::Recording& r)
        : player(r.profile, r.width, r.height), profile_(r.profile) {}
    void execute(const CommandList& list) override { player.play(list); }
    const Planes& planes() override { return planes_ = player.planes(); }
    const std::vector<PassReport>& passes() override { return passes_; }
    void reset_passes() override {}
    const std::map<std::uint32_t, Readback>& readbacks() override { return readbacks_; }
    void read_into(std::uint32_t, std::span<std::uint32_t>) override {}
    const Profile& profile() const override { return profile_; }

    peer::Player player;

private:
    Profile profile_;
    Planes planes_;
    std::vector<PassReport> passes_;
    std::map<std::uint32_t, Readback> readbacks_;
};

/// OpenGL chooses the lit side after clipping, so one colour for each vertex cannot express it.
/// Switches two-sided lighting off; true if it was on.
bool without_two_side(inspect::Recording& recording) {
    bool changed = false;
    for (CommandList& list : recording.lists)
        for (gw::Command& command : list.commands)
            if (auto* set = std::get_if<SetState>(&command)) {
                changed = changed || set->state.lighting.two_side;
                set->state.lighting.two_side = false;
            }
    return changed;
}

std::vector<std::string> row_of(const std::string& pass, const Planes& ours, const Planes& theirs) {
    std::vector<std::string> row{pass};
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil}) {
        const inspect::Differences d = inspect::classify(ours, theirs, plane);
        for (const std::uint64_t count : {d.rounding, d.edge, d.other, d.worst})
            row.push_back(std::to_string(count));
    }
    return row;
}

}  // namespace

std::string compare_with_osmesa(inspect::Recording recording, const inspect::MachineMaker& make) {
    const bool one_sided = without_two_side(recording);
    const auto ours = make(recording);
    MesaMachine theirs(recording);
    inspect::Player our_player(recording, *ours), their_player(recording, theirs);
    std::vector<std::vector<std::string>> rows{{"pass"}};
    for (const char* plane : {"colour", "Z", "stencil"})
        for (const char* what : {"rounding", "edge", "other", "worst"})
            rows[0].push_back(fmt::format("{} {}", plane, what));
    for (const inspect::PassRange& pass : inspect::pass_ranges(recording)) {
        our_player.play_to(pass.end);
        their_player.play_to(pass.end);
        rows.push_back(row_of(pass.name, ours->planes(), theirs.planes()));
    }
    return fmt::format("{}: pixels of {} that differ after each pass{}\n", theirs.player.renderer(),
                       recording.width * recording.height,
                       one_sided ? "; lighting.two_side is off in both" : "") +
           table(rows);
}

}  // namespace gw::apps
