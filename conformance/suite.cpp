#include "conformance/suite.h"

#include "gw/error.h"
#include "gw/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace gw::conformance {
namespace {

/// A pass for each command that is not SetState, so that the first difference names its command. A
/// list for each colour map.
inspect::Recording recording_of(const Case& c, const std::string& name) {
    inspect::Recording out;
    out.producer = "gw conformance";
    out.scene = name;
    out.profile = c.profile;
    out.width = c.width;
    out.height = c.height;
    CommandList list;
    std::size_t ordinal = 0, index = 0;
    auto map = c.maps.begin();
    for (const Command& command : c.list.commands) {
        for (; map != c.maps.end() && map->command == index; ++map) {
            if (!list.commands.empty()) out.lists.push_back(std::exchange(list, {}));
            out.color_maps.resize(out.lists.size() + 1);
            out.color_maps.back() = map->map;
        }
        ++index;
        if (std::holds_alternative<BeginPass>(command)) continue;
        if (!std::holds_alternative<SetState>(command))
            list.add(BeginPass{fmt::format("{:02} {}", ++ordinal, name_of(command))});
        list.add(command);
    }
    out.lists.push_back(std::move(list));
    return out;
}

/// A foreign machine may be slow, and all recordings together stay below 16 MB.
bool is_small(const inspect::Recording& recording) {
    constexpr int most_pixels = 3000;
    constexpr std::size_t most_bytes = 20000;
    return recording.width * recording.height <= most_pixels &&
           inspect::encode(recording).size() <= most_bytes;
}

}  // namespace

const std::vector<Group>& groups() {
    static const std::vector<Group> recorded = [] {
        std::vector<Group> out;
        std::ranges::copy_if(all_groups(), std::back_inserter(out),
                             [](const Group& group) { return group.count > 0; });
        return out;
    }();
    return recorded;
}

std::vector<Member> members(const Group& group) {
    std::vector<Member> out;
    for (std::uint64_t index = 0; int(out.size()) < group.count; ++index) {
        if (index >= 1000 * std::uint64_t(group.count))
            throw Error(
                fmt::format("group '{}': {} of {} recordings are small enough after {} cases",
                            group.name, out.size(), group.count, index));
        Random random(seed_of("conformance " + group.name, index));
        const std::string name = fmt::format("{}_{:02}", group.name, out.size() + 1);
        inspect::Recording recording = recording_of(group.make(random), name);
        if (is_small(recording) || group.count == 1) out.push_back({name, std::move(recording)});
    }
    return out;
}

std::vector<std::string> rules_of(const Group& group) {
    std::vector<std::string> out;
    std::istringstream words(group.rules);
    for (std::string word; words >> word;) {
        int chapter = 0, first = 0, last = 0;
        const int read = std::sscanf(word.c_str(), "R%d.%d-R%*d.%d", &chapter, &first, &last);
        for (int rule = first; rule <= (read == 3 ? last : first); ++rule)
            out.push_back(fmt::format("R{}.{}", chapter, rule));
    }
    return out;
}

}  // namespace gw::conformance
