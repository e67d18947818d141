// Font 0: letters of 9 x 15 pixels, enlarged from 5 x 7.
#pragma once

#include "irisgl/state/program.h"

namespace gw::irisgl {

Font screen_font();

}  // namespace gw::irisgl
