// Whether a pass list can draw a picture, whoever wrote it. Does not look at a scene.
#pragma once

#include "multipass/passes/pass.h"

#include <optional>
#include <string>

namespace gw::multipass {

/// What is wrong with a list: its first fault.
struct ListFault {
    std::size_t pass = 0;
    std::string key;   ///< of pass_keys.h
    std::string what;  ///< with what was expected
};

/// None: the list draws the same picture whatever the planes hold before, every pass can do
/// something, and the driver has a way to run it.
std::optional<ListFault> fault_of(const PassList& passes);

}  // namespace gw::multipass
