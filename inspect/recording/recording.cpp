#include "inspect/recording/recording.h"

namespace gw::inspect {

std::string set_of(const Recording& recording, const std::string& pass) {
    for (const ParameterSet& s : recording.sets)
        if (s.pass == pass) return s.set;
    return "";
}

}  // namespace gw::inspect
