#include "inspect/recording/recording.h"

#include "inspect/recording/read_bytes.h"

namespace gw::inspect {

std::string set_of(const Recording& recording, const std::string& pass) {
    for (const ParameterSet& s : recording.sets)
        if (s.pass == pass) return s.set;
    return "";
}

std::vector<std::uint8_t> read_recording_bytes(const std::filesystem::path& file) {
    return read_bytes(file, {[](std::string_view bytes) { return has_identifier(bytes, "GWT1"); },
                             "not a recording; expected a file that gw record wrote"});
}

}  // namespace gw::inspect
