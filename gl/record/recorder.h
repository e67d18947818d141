// Begins the outputs that variables ask for: GW_RECORD, GW_STATS, GW_SCREENSHOT, GW_FRAMES.
#pragma once

namespace gw::gl {

/// Later calls do nothing. A file that cannot be written is reported and left out.
void start_recording();

}  // namespace gw::gl
