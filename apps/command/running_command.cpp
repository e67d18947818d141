#include "apps/command/running_command.h"

#include "apps/describe/shell_words.h"
#include "image/output/origin.h"

namespace gw::apps {
namespace {

std::vector<std::string> outer_words;
int depth = 0;

}  // namespace

RunningCommand::RunningCommand(const std::vector<std::string>& words) {
    if (depth++ > 0) return;
    outer_words = words;
    image::set_origin(shell_command(words));
}

RunningCommand::~RunningCommand() {
    if (--depth > 0) return;
    outer_words.clear();
    image::set_origin("");
}

const std::vector<std::string>& RunningCommand::words() { return outer_words; }

bool RunningCommand::is_inner() { return depth > 1; }

}  // namespace gw::apps
