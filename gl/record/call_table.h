// The calls of a list of commands as a recording has them: with names of functions and of places in
// the program.
#pragma once

#include "gl/drawable/call_trace.h"
#include "inspect/recording/calls.h"

#include <map>
#include <span>
#include <string>

namespace gw::gl {

class CallNamer {
public:
    inspect::CallTable table_of(std::span<const CallRun> runs);

private:
    /// code_place(), once for each address.
    const std::string& source_name(const void* address);

    std::map<const void*, std::string> sources_;  ///< has a bound
};

}  // namespace gw::gl
