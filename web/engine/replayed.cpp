#include "web/engine/replayed.h"

namespace gw::lab {

Replayed::Replayed(inspect::Recording recording)
    : recording_(std::move(recording)), ranges_(inspect::pass_ranges(recording_)) {}

const Planes& Replayed::planes_after(std::size_t passes) {
    if (!machine_ || passes < done_) {
        machine_ =
            make_fast(recording_.profile, recording_.width, recording_.height, {.threads = 1});
        player_ = std::make_unique<inspect::Player>(recording_, *machine_);
    }
    player_->play_to(passes == 0 ? ranges_.at(0).first : ranges_.at(passes - 1).end);
    done_ = passes;
    return machine_->planes();
}

}  // namespace gw::lab
