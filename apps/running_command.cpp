#include "apps/running_command.h"

namespace gw::apps {

namespace {

std::vector<std::string> outer_words;
int depth = 0;

}  // namespace

RunningCommand::RunningCommand(const std::vector<std::string>& words) {
    if (depth++ == 0) outer_words = words;
}

RunningCommand::~RunningCommand() {
    if (--depth == 0) outer_words.clear();
}

const std::vector<std::string>& RunningCommand::words() { return outer_words; }

bool RunningCommand::is_inner() { return depth > 1; }

}  // namespace gw::apps
