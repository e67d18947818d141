// gw radiosity --form-factor: what two figures send each other, and whether it is reciprocal.
#pragma once

#include "apps/command/progress.h"
#include "apps/radiosity/options.h"

namespace gw::apps {

/// Prints both form factors. Throws Error for a name that no figure has.
void print_form_factor(const RadiosityOptions& options, const radiosity::PixmapModel& model,
                       Progress& progress);

}  // namespace gw::apps
