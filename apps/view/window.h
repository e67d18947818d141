// A window on the screen for a viewer, by SDL2. Knows no scene.
#pragma once

#include "apps/view/viewer.h"

#include <string>

namespace gw::apps {

/// Shows the viewer's screen and gives it what the user does, until it is finished. Throws Error if
/// there is no display.
void show_window(Viewer& viewer, const std::string& title);

}  // namespace gw::apps
