#include "radiosity/solver/stall.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::radiosity {
namespace {

double largest_reflectance(const Figure& figure) {
    return std::max({figure.rho.x, figure.rho.y, figure.rho.z});
}

}  // namespace

std::string why_stalled(const PixmapModel& model, std::uint64_t shots, double unshot_share) {
    const Figure& most = *std::ranges::max_element(model.figures, {}, largest_reflectance);
    return fmt::format(
        "stopped after {} shots: {:.4f} of the energy stays unshot, because it neither escapes nor is "
        "absorbed; '{}' reflects {:g} of its light; expected Kd below 1",
        shots, unshot_share, most.name, largest_reflectance(most));
}

}  // namespace gw::radiosity
