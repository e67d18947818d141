// The light in the pixmaps [F1c, F2.2]: the light that each texel has received, the light that it
// has still to send, and the books. Plain data and sums; does not shoot (solver.h does).
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <cstdint>
#include <vector>

namespace gw::radiosity {

/// Every channel by itself. H and unshot are densities: flux by area.
struct Solution {
    std::vector<dvec3> H;  ///< received so far (irradiance) at each texel
    /// of the texel's radiosity B = E + rho H, the part that it has not sent on
    std::vector<dvec3> unshot;
    dvec3 escaped{0};  ///< flux that left the scene
    dvec3 backs{0};    ///< flux absorbed by sides of figures that are no surface
    std::uint64_t shots = 0;
    bool operator==(const Solution&) const = default;
};

/// Before the first shot, all emitted light is unshot; that of lamps without area has arrived.
Solution initial_solution(const PixmapModel& model);
/// Adds what a lamp without area sends: it arrives, and its reflection is unshot.
void add(const PixmapModel& model, const DirectLight& light, Solution& solution);

dvec3 radiosity_at(const PixmapModel& model, const Solution& solution, std::size_t texel);

/// The nearest value that two float32 hold, a head and a rest. All H and unshot are such values, so
/// that files of float32 hold a solution bit for bit.
double storable(double v);

/// Energy by channel [F1c]. absorbed + unshot + escaped = emitted, but for rounding.
struct Books {
    dvec3 emitted{0}, absorbed{0}, unshot{0}, escaped{0};
    dvec3 unshot_size{0};  ///< unshot without its signs: after an update a part of it is negative
    /// The largest |absorbed + unshot + escaped - emitted| / emitted.
    double imbalance() const;
    /// unshot_size as a part of the emitted light, all channels together.
    double unshot_share() const;
};
Books books(const PixmapModel& model, const Solution& solution);

/// Cohen's estimate of the light that is yet to come, for display only [F1c]. It spreads the unshot
/// energy evenly and lets the mean surface reflect it for ever.
dvec3 ambient(const PixmapModel& model, const Solution& solution);

}  // namespace gw::radiosity
