// What is written over the pictures of gw hidden, for people at the back of a room: which
// algorithm, which step, which counts; words in the colours that the pictures use. Does not draw.
#pragma once

#include "apps/hidden/lettering.h"
#include "hiddensurface/run/algorithm.h"
#include "hiddensurface/run/replay.h"

namespace gw::apps {

/// Which algorithm and step; what it is about, polygons in the colours of their borders; the
/// question and its answer.
std::vector<TextLine> caption_of_step(const std::string& algorithm,
                                      const hiddensurface::Replay& replay);

/// Of a comparison's picture, difference and writes.
std::array<std::vector<TextLine>, 3> captions_of(const std::string& algorithm,
                                                 const hiddensurface::Counts& counts);

}  // namespace gw::apps
