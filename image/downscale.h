// A picture made smaller, to be shown among many.
#pragma once

#include "image/picture.h"

namespace gw::image {

/// Every square of `factor` x `factor` pixels as their mean, to nearest; squares at the right and
/// top may be cut.
Picture reduced(const Picture& picture, int factor);

}  // namespace gw::image
