// Makes a reference machine with an observer. gw/machine.h makes one without.
#pragma once

#include "gw/machine.h"
#include "gw/reference/observer.h"

namespace gw::reference {

/// `observer` may be null and must outlive the machine. It is told of the pixels of one surface; 0:
/// of the window. With samples, clears and copies are told of sample 0.
std::unique_ptr<Machine> make(const Profile& profile, int width, int height, Observer* observer,
                              std::uint32_t surface = 0);

}  // namespace gw::reference
