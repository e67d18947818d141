// The light of each lamp by itself [F4]. Radiosity is linear in what is emitted: shares that were
// sent by the same shots add up to the whole, and may be mixed in other strengths without a shot.
// Does not shoot (Solver::follow does) and does not write files.
#pragma once

#include "radiosity/solver/saved.h"

namespace gw::radiosity {

/// A lamp is all objects of one name that emit, or all lights of one name without area.
struct Share {
    std::string lamp;
    std::vector<dvec3> E;  ///< of each texel, by this lamp only
    Solution solution;
};

/// In the order of the scene, objects first. A light of an object's name is the same lamp.
std::vector<std::string> lamps_of(const PixmapModel& model);

/// Before the first shot. Their solutions are for Solver::follow.
std::vector<Share> initial_shares(const PixmapModel& model);

/// The state of the scene whose lamps are `factors` times as strong, by channel, after the same
/// shots. The model's emission changes with it. Precondition: a factor of at least 0 for each
/// share.
Solution mix(const std::vector<Share>& shares, const std::vector<dvec3>& factors,
             PixmapModel& model);

/// As `save` and `load` do, of the share `number` of `count`, from 1.
Saved save_share(const PixmapModel& model, const FormFactorOptions& options, const Share& share,
                 std::size_t number, std::size_t count);
/// `E` of the share is of the model. Throws Error as `load` does, and if the file has another lamp.
Share load_share(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
                 const std::string& lamp, const std::string& file);

/// Throws Error, naming the first file with another number of shots than `shots`.
void check_same_shots(const std::vector<Share>& shares, const std::vector<std::string>& files,
                      std::uint64_t shots);

}  // namespace gw::radiosity
