#include "inspect/replay/replayed.h"

namespace gw::inspect {

Replayed::Replayed(Recording recording, int threads)
    : recording_(std::move(recording)), ranges_(pass_ranges(recording_)), threads_(threads) {}

const Planes& Replayed::planes_after(std::size_t passes) {
    if (!machine_ || passes < done_) {
        machine_ = make_fast(recording_.profile, recording_.width, recording_.height,
                             {.threads = threads_});
        player_ = std::make_unique<Player>(recording_, *machine_);
    }
    player_->play_to(passes == 0 ? ranges_.at(0).first : ranges_.at(passes - 1).end);
    done_ = passes;
    return machine_->planes();
}

}  // namespace gw::inspect
