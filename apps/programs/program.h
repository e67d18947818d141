// Other programs: runs one and waits for it, and finds gw's libraries for it. Does not read its output.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
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

/// The first of `folders`, beside the command's, that has the file. Throws Error if none has it.
std::filesystem::path folder_beside(std::initializer_list<const char*> folders, const char* file);

}  // namespace gw::apps
