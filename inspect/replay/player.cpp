#include "inspect/replay/player.h"

#include "inspect/recording/check_lists.h"

namespace gw::inspect {

std::vector<PassRange> pass_ranges(const Recording& recording) {
    std::vector<PassRange> ranges;
    std::size_t index = 0;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) {
            if (const auto* begin = std::get_if<BeginPass>(&command))
                ranges.push_back({begin->name, index, index});
            else if (ranges.empty() && !std::holds_alternative<SetState>(command))
                ranges.push_back({"", 0, 0});
            ++index;
            if (!ranges.empty()) ranges.back().end = index;
        }
    for (std::size_t i = 1; i < ranges.size(); ++i) ranges[i - 1].end = ranges[i].first;
    return ranges;
}

std::size_t command_count(const Recording& recording) {
    std::size_t count = 0;
    for (const CommandList& list : recording.lists) count += list.commands.size();
    return count;
}

const Command& command_at(const Recording& recording, std::size_t index) {
    auto list = recording.lists.begin();
    for (; index >= list->commands.size(); ++list) index -= list->commands.size();
    return list->commands[index];
}

void Player::play_to(std::size_t end) {
    while (done_ < end && list_ < recording_.lists.size()) {
        const auto& commands = recording_.lists[list_].commands;
        const std::size_t count = std::min(commands.size() - command_, end - done_);
        if (command_ == 0) {
            if (count < commands.size())
                validate(recording_.lists[list_], recording_.profile, recording_.width,
                         recording_.height, context_);
            follow(recording_.lists[list_], context_);
        }
        if (count == commands.size()) {
            machine_.execute(recording_.lists[list_]);
        } else if (count > 0) {
            const auto first = commands.begin() + std::ptrdiff_t(command_);
            machine_.execute({{first, first + std::ptrdiff_t(count)}});
        }
        done_ += count;
        command_ += count;
        if (command_ < commands.size()) continue;
        ++list_;
        command_ = 0;
    }
}

void Player::play() { play_to(command_count(recording_)); }

void play_by_pass(const Recording& recording, Machine& machine,
                  const std::function<void(std::size_t)>& after) {
    Player player(recording, machine);
    const std::vector<PassRange> passes = pass_ranges(recording);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        player.play_to(passes[i].end);
        after(i);
    }
    player.play();
}

}  // namespace gw::inspect
