// A peer's answers: lists played by peer::Player in a process of its own, because Mesa chooses its
// driver once per process.
#pragma once

#include "gw/machine.h"

#include <string>
#include <vector>

namespace gw::test {

/// What a driver makes of lists, each played on planes of 0 and the initial state.
struct Answers {
    std::string renderer;
    std::vector<Planes> planes;                       ///< one a list
    std::vector<std::vector<QueryResult>> queries{};  ///< of each list
};

/// `driver`: GALLIUM_DRIVER, `llvmpipe` or `softpipe`. Throws Error with what the other process
/// said.
Answers play(const std::string& driver, const std::vector<CommandList>& lists, int width,
             int height, const Profile& profile = vgx());

/// The reference's planes of the same lists.
std::vector<Planes> execute(const std::vector<CommandList>& lists, int width, int height,
                            const Profile& profile = vgx());

}  // namespace gw::test
