// Light that neither escapes nor is absorbed is shot for ever [F1c]: a closed room of reflectance 1.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace gw::radiosity {

/// Watches the unshot share.
class Stall {
public:
    /// `patches` of the model: about as many shots send all light once.
    explicit Stall(std::size_t patches) : patches_(patches < 16 ? 16 : patches) {}

    /// Call it after every shot. True if the share has fallen by less than a 10,000th of itself in as
    /// many shots as there are patches.
    bool after_shot(double unshot_share) {
        if (++shots_ % patches_ != 0) return false;
        const bool stays = before_ >= 0 && unshot_share > before_ * (1 - 1e-4);
        before_ = unshot_share;
        return stays;
    }

private:
    std::size_t patches_, shots_ = 0;
    double before_ = -1;
};

/// For people: the figure that reflects most, and the share of the energy that stays unshot.
std::string why_stalled(const PixmapModel& model, std::uint64_t shots, double unshot_share);

}  // namespace gw::radiosity
