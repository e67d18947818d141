// FlatBuffers' verifier, and the commands, which it does not know.
#include "inspect/recording/file_commands.h"

#include <algorithm>

namespace gw::inspect {
namespace {

/// Checks that commands are the tables that their types name, which the generated verifier cannot
/// know.
bool commands_are_whole(const gwt::CommandList& list, flatbuffers::Verifier& verifier) {
    const auto* types = list.commands_type();
    const auto* commands = list.commands();
    if (!types || !commands) return !types && !commands;
    if (types->size() != commands->size()) return false;
    for (unsigned i = 0; i < types->size(); ++i) {
        bool whole = true;
        with_command(static_cast<gwt::CommandType>(types->Get(i)), commands->Get(i),
                     [&](const auto& c) { whole = c.Verify(verifier); });
        if (!whole) return false;
    }
    return true;
}

}  // namespace

bool is_whole(std::span<const std::uint8_t> bytes) {
    // The verifier counts a table as often as it is referred to, so that this bounds its own time
    // too; a command counts twice.
    flatbuffers::Verifier verifier(bytes.data(), bytes.size(), 16, 1 << 25);
    if (bytes.size() >= FLATBUFFERS_MAX_BUFFER_SIZE || !gwt::VerifyRecordingBuffer(verifier))
        return false;
    const auto* lists = gwt::GetRecording(bytes.data())->lists();
    return !lists || std::all_of(lists->begin(), lists->end(), [&](const gwt::CommandList* list) {
        return commands_are_whole(*list, verifier);
    });
}

}  // namespace gw::inspect
