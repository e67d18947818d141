// Whether a pass list can draw a picture. Does not look at a scene.
#pragma once

#include "multipass/passes/pass.h"

#include <optional>
#include <string>

namespace gw::multipass {

/// A fault of a list.
struct ListFault {
    std::size_t pass = 0;
    std::string key;   ///< of [[pass]]
    std::string what;  ///< the fault and the expectation
};

/// The first fault. None: the picture does not depend on the planes' former contents, every pass
/// can have an effect, and the driver can run it.
std::optional<ListFault> first_fault(const PassList& passes);

}  // namespace gw::multipass
