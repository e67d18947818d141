// Illuminances that gw radiosity prints, and the lamps in candela of its model. Does not solve.
#pragma once

#include "apps/radiosity/pictures.h"

namespace gw::apps {

/// The scene's model with the direct light of its lamps in candela.
radiosity::PixmapModel lit_model(const scene::Scene& scene, const RadiosityOptions& options);

/// Throws UsageError if lux are asked of a scene whose light has no unit.
void check_lux(const RadiosityOptions& options, const scene::Scene& scene);

/// A line for each point of --lux-at.
std::string lux_lines(const RadiosityOptions& options, const Solved& solved);

}  // namespace gw::apps
