#include "apps/digesting_machine.h"

namespace gw::apps {

void DigestingMachine::execute(const CommandList& list) {
    CommandList digesting = list;
    for (Command& command : digesting.commands) {
        if (auto* pass = std::get_if<BeginPass>(&command)) pass->digests = all_planes;
    }
    machine_.execute(digesting);
}

}  // namespace gw::apps
