#include "inspect/replay/shown_maps.h"

#include "inspect/replay/player.h"

#include <algorithm>

namespace gw::inspect {

ShownMaps::ShownMaps(const Recording& recording) {
    const ColorMap* now = nullptr;
    std::size_t commands = 0;
    for (std::size_t i = 0; i < recording.lists.size(); ++i) {
        if (i < recording.color_maps.size() && recording.color_maps[i])
            now = recording.color_maps[i]->bits != 0 ? &*recording.color_maps[i] : nullptr;
        after_lists_.push_back(now);
        list_ends_.push_back(commands += recording.lists[i].commands.size());
    }
    for (const PassRange& pass : pass_ranges(recording)) pass_ends_.push_back(pass.end);
}

const ColorMap* ShownMaps::of(std::size_t command) const {
    const auto end = std::ranges::upper_bound(pass_ends_, command);
    const std::size_t last = end != pass_ends_.end() ? *end - 1 : command;
    const auto list = std::ranges::upper_bound(list_ends_, last);
    return list != list_ends_.end() ? after_lists_[std::size_t(list - list_ends_.begin())]
                                    : nullptr;
}

const ColorMap* ShownMaps::last() const {
    return after_lists_.empty() ? nullptr : after_lists_.back();
}

void ShownDigests::add(Machine& machine) {
    const ColorMap* const map = maps_.of_pass(all_.size());
    std::optional<Digest>& digest = all_.emplace_back();
    if (map == nullptr) return;
    const Planes& planes = machine.planes();
    Planes shown;
    shown.width = planes.width;
    shown.height = planes.height;
    shown.color = shown_picture(planes.color, *map);
    digest = gw::digest(shown, Plane::Color);
}

std::string shown_value(const Planes& planes, Plane plane, int x, int y, const ColorMap* map) {
    if (map == nullptr || (plane != Plane::Color && plane != Plane::Back))
        return value_at(planes, plane, x, y);
    const Rgba& color = (plane == Plane::Color ? planes.color : planes.back)[planes.index(x, y)];
    return index_change_text(*map, color, color);
}

}  // namespace gw::inspect
