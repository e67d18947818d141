#include "apps/command/command_recorder.h"

#include "apps/command/versions.h"
#include "inspect/replay/recorder.h"

#include <mutex>

namespace gw::apps {
namespace {

/// Of one machine, which may be gone.
struct Track {
    Profile profile;
    int width = 0, height = 0;
    std::vector<CommandList> lists;
};

bool taping = false;
std::mutex tracks_mutex;
std::vector<std::shared_ptr<Track>> tracks;
std::vector<inspect::ParameterSet> noted;

class TapedMachine : public inspect::Recorder {
public:
    TapedMachine(std::unique_ptr<Machine> machine, std::shared_ptr<Track> track)
        : Recorder(*machine, track->lists),
          machine_(std::move(machine)),
          track_(std::move(track)) {}

private:
    std::unique_ptr<Machine> machine_;
    std::shared_ptr<Track> track_;
};

}  // namespace

Tape::Tape() { taping = true; }

Tape::~Tape() {
    taping = false;
    tracks.clear();
    noted.clear();
}

std::vector<inspect::Recording> Tape::take(const std::string& scene, const std::string& renderer) {
    std::vector<inspect::Recording> recordings;
    for (const auto& track : tracks) {
        if (track->lists.empty()) continue;
        recordings.push_back({.producer = "gw " + version(),
                              .scene = scene,
                              .renderer = renderer,
                              .profile = track->profile,
                              .width = track->width,
                              .height = track->height,
                              .sets = noted,
                              .lists = std::move(track->lists)});
        track->lists.clear();
    }
    return recordings;
}

void note_parameter_sets(const std::function<std::map<std::string, std::string>()>& sets) {
    if (!taping) return;
    for (const auto& [pass, set] : sets()) noted.push_back({pass, set});
}

std::unique_ptr<Machine> taped(std::unique_ptr<Machine> machine, int width, int height) {
    if (!taping) return machine;
    auto track = std::make_shared<Track>(Track{machine->profile(), width, height, {}});
    const std::scoped_lock lock(tracks_mutex);
    tracks.push_back(track);
    return std::make_unique<TapedMachine>(std::move(machine), std::move(track));
}

}  // namespace gw::apps
