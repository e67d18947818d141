// gw radiosity --mix: shares of lamps that were solved before, in other strengths [F4]. Does not
// solve.
#pragma once

#include "apps/command/command.h"
#include "apps/radiosity/options.h"

namespace gw::apps {

/// Writes DIR/mixed.png and what else is asked for. Returns an ExitCode. Throws UsageError for a
/// lamp that the scene does not have, and Error for shares that do not fit.
int show_mix(const RadiosityOptions& options, Session& session, const scene::Scene& scene,
             radiosity::PixmapModel model);

}  // namespace gw::apps
