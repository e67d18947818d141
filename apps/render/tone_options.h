// The display adjustments of a picture as options.
#pragma once

#include "image/picture.h"

namespace CLI {
class App;
}

namespace gw::apps {

/// Adds --gamma and --exposure.
void add_tone_options(CLI::App& command, image::Tone& tone);

}  // namespace gw::apps
