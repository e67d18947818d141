// The end of a process whose library runs out of memory in a function that must not throw.
#pragma once

namespace gw::apps {

/// From now on such an end is one line "gw: out of memory" and exit code 1, and leaves no temporary
/// files. Any other call of std::terminate aborts as by default, but leaves none either.
void end_clearly_on_terminate();

}  // namespace gw::apps
