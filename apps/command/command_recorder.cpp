#include "apps/command/command_recorder.h"

#include "apps/command/command.h"
#include "inspect/replay/forwarding_machine.h"

namespace gw::apps {

/// The lists of one machine, which may no longer exist.
struct CommandRecorder::Track {
    Profile profile;
    int width = 0, height = 0;
    std::vector<CommandList> lists;
};

namespace {

/// Owns the machine that it records, and shares the lists with the recorder.
class RecordedMachine : public inspect::Recorder {
public:
    RecordedMachine(std::unique_ptr<Machine> machine,
                    std::shared_ptr<std::vector<CommandList>> lists)
        : Recorder(*machine, *lists), machine_(std::move(machine)), lists_(std::move(lists)) {}

private:
    std::unique_ptr<Machine> machine_;
    std::shared_ptr<std::vector<CommandList>> lists_;
};

}  // namespace

CommandRecorder::CommandRecorder() = default;
CommandRecorder::~CommandRecorder() = default;

std::unique_ptr<Machine> CommandRecorder::add(std::unique_ptr<Machine> machine, int width,
                                              int height) {
    auto track = std::make_shared<Track>(Track{machine->profile(), width, height, {}});
    {
        const std::scoped_lock lock(mutex_);
        tracks_.push_back(track);
    }
    return std::make_unique<RecordedMachine>(
        std::move(machine), std::shared_ptr<std::vector<CommandList>>(track, &track->lists));
}

void CommandRecorder::add_parameter_sets(const std::map<std::string, std::string>& sets) {
    for (const auto& [pass, set] : sets) sets_.push_back({pass, set});
}

std::vector<inspect::Recording> CommandRecorder::take(const std::string& scene,
                                                      const std::string& renderer) {
    std::vector<inspect::Recording> recordings;
    for (const auto& track : tracks_) {
        if (track->lists.empty()) continue;
        recordings.push_back({.producer = "gw " + version(),
                              .scene = scene,
                              .renderer = renderer,
                              .profile = track->profile,
                              .width = track->width,
                              .height = track->height,
                              .sets = sets_,
                              .lists = std::move(track->lists)});
        track->lists.clear();
    }
    return recordings;
}

std::unique_ptr<Machine> recorded(std::unique_ptr<Machine> machine, int width, int height,
                                  CommandRecorder* recorder) {
    return recorder ? recorder->add(std::move(machine), width, height) : std::move(machine);
}

}  // namespace gw::apps
