// Makes a reference machine with an observer. gw/machine.h makes one without.
#pragma once

#include "gw/machine.h"
#include "gw/reference/observer.h"

namespace gw::reference {

/// `observer` may be null and must outlive the machine.
std::unique_ptr<Machine> make(const Profile& profile, int width, int height, Observer* observer);

}  // namespace gw::reference
