// The commands and options of gw as plain data, read from CLI11, for every form of description.
#pragma once

#include "apps/command/command.h"

#include <string>
#include <vector>

namespace gw::apps {

struct DescribedOption {
    std::vector<std::string> words;  ///< "-o", "--output"; of a positional its name
    std::string type;                ///< "IMAGE"; "" of a flag
    std::string about;
    bool positional = false;
    std::vector<std::string> values;  ///< the words it takes, if they are few and known
};

struct DescribedCommand {
    std::string name, about, footer;
    std::vector<DescribedOption> options;
};

/// In the order of --help. The root itself is not among them.
std::vector<DescribedCommand> described_commands(const CLI::App& root);

}  // namespace gw::apps
