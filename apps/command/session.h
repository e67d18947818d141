// What a run of the command line hands to its subcommand. Does not parse or run it.
#pragma once

#include "image/output/input_files.h"

#include <string>
#include <vector>

namespace gw::apps {

class CommandRecorder;

struct Session {
    /// The command line after "gw": "maps", "a.gwt", "-o", "dir".
    std::vector<std::string> words;
    /// Keeps what machines execute; null: nothing does.
    CommandRecorder* recorder = nullptr;
    /// What was read so far: no output may replace it.
    image::InputFiles inputs;
    /// Another command runs this one, as gw figures does, and describes the output itself.
    bool is_inner = false;
};

}  // namespace gw::apps
