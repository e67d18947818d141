// Runs another program and waits for it. Does not read its output.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

/// Runs `words[0]`, looked up as a shell does, with more environment variables. Returns its exit
/// code as a shell sees it: 128 + n for signal n. Meanwhile SIGINT, SIGTERM and SIGHUP end the
/// program, not this process. `each_second` is called meanwhile. Throws Error if it cannot be run.
int run_program(const std::vector<std::string>& words,
                const std::vector<std::pair<std::string, std::string>>& variables,
                const std::function<void()>& each_second);

}  // namespace gw::apps
