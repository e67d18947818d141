// The command line that is being run, for captions: of folders (folder_index.h), and noted on every
// file that is written meanwhile (image/output/origin.h). Does not parse or run it.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// While one lives, these words run; of commands that run inside another, the outer one's stay.
class RunningCommand {
public:
    explicit RunningCommand(const std::vector<std::string>& words);
    ~RunningCommand();
    RunningCommand(const RunningCommand&) = delete;
    RunningCommand& operator=(const RunningCommand&) = delete;

    /// "inspect", "a.gwt", "-o", "dir"; empty outside of a command.
    static const std::vector<std::string>& words();
    /// A command runs inside another: what it makes is the outer one's.
    static bool is_inner();
};

}  // namespace gw::apps
