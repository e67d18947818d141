// Machines with a known fault, to test the harness. Does not find the fault.
#pragma once

#include "gw/machine.h"

namespace gw::fuzz {

/// The fault, from the machine's third draw on.
enum class Fault {
    Pixel,    ///< one bit of one depth value that the draw wrote
    Counter,  ///< one fragment too many
    Split,    ///< one bit of one colour, only if the list has other commands too
};

std::unique_ptr<Machine> make_faulty(std::unique_ptr<Machine> machine, Fault fault);

}  // namespace gw::fuzz
