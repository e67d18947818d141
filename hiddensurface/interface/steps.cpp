#include "hiddensurface/interface/steps.h"

#include "gw/base/cancel.h"
#include "gw/error.h"

#include <array>
#include <charconv>

namespace gw::hiddensurface {

const char* name_of(Level level) {
    constexpr std::array names{"polygon", "line", "span", "pixel"};
    return names[std::size_t(level)];
}
const char* name_of(Action action) {
    constexpr std::array names{"compare", "decide", "sort", "split", "draw"};
    return names[std::size_t(action)];
}

std::uint32_t polygon_of(const std::string& piece) {
    std::uint32_t polygon = 0;
    std::from_chars(piece.data(), piece.data() + piece.size(), polygon);
    return polygon;
}

void StepLog::add(Step step) {
    end_if_canceled();
    if (!wants(step.level) && !(on_ && step.action == Action::Draw)) return;
    if (steps_.size() == most_steps)
        throw Error(
            "the log has more than 2,000,000 steps; expected fewer polygons, a smaller --size or a "
            "coarser --level");
    for (WatchedCount& watched : watched_)
        if (const std::uint64_t now = *watched.count; now != watched.last) {
            step.counts.emplace_back(watched.name, now);
            watched.last = now;
        }
    steps_.push_back(std::move(step));
}

}  // namespace gw::hiddensurface
