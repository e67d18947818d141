// Machines with a known fault, to test the harness: it must find the fault and name its place.
#pragma once

#include "gw/machine.h"

namespace gw::fuzz {

/// Which fault, in the third draw of a machine's life.
enum class Fault {
    Pixel,    ///< one bit of one depth value, where the draw wrote one
    Counter,  ///< one fragment too many
    Split,    ///< one bit of one colour, only where the list had other commands too
};

std::unique_ptr<Machine> make_faulty(std::unique_ptr<Machine> machine, Fault fault);

}  // namespace gw::fuzz
