// Records what a program draws: GW_RECORD names the file. docs/recordings.md, "Streams".
#pragma once

namespace gw::gl {

/// Begins the recording if GW_RECORD is set; later calls do nothing. Throws Error if the file cannot
/// be written.
void start_recording();

}  // namespace gw::gl
