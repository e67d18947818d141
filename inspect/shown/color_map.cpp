#include "inspect/shown/color_map.h"

#include "gw/error.h"

#include <fmt/format.h>

namespace gw::inspect {

const char* name_of(IndexPlanes planes) {
    switch (planes) {
        case IndexPlanes::Window: return "window";
        case IndexPlanes::Overlay: return "overlay";
        case IndexPlanes::Underlay: return "underlay";
        case IndexPlanes::PopUp: return "pop-up";
    }
    return "";
}

unsigned ColorMap::index_of(const Rgba& color) const {
    const unsigned in_r = (1u << bits_in_r) - 1;
    return ((color[0] & in_r) | unsigned(color[1]) << bits_in_r) & ((1u << bits) - 1);
}

std::array<std::uint16_t, 3> ColorMap::entry(unsigned index) const {
    if (shows_below(index)) return {};
    const std::uint32_t rgb = entries[index];
    return {std::uint16_t(rgb & 255), std::uint16_t(rgb >> 8 & 255),
            std::uint16_t(rgb >> 16 & 255)};
}

Rgba ColorMap::shown(unsigned index) const {
    const auto [r, g, b] = entry(index);
    return {r, g, b, std::uint16_t(shows_below(index) ? 0 : 255)};
}

void check_color_map(const ColorMap& map) {
    const auto check = [](const char* what, int value, int least, int most) {
        if (value < least || value > most)
            throw Error(
                fmt::format("a colour map of {} {}; expected {} to {}", value, what, least, most));
    };
    check("bits", map.bits, 0, most_index_bits);
    check("bits in R", map.bits_in_r, 1, most_index_bits);
    const std::size_t expected = map.bits == 0 ? 0 : std::size_t{1} << map.bits;
    if (map.entries.size() != expected)
        throw Error(
            fmt::format("a colour map of {} entries; expected {}", map.entries.size(), expected));
}

std::vector<Rgba> shown_picture(const std::vector<Rgba>& colors, const ColorMap& map) {
    std::vector<Rgba> shown;
    shown.reserve(colors.size());
    for (const Rgba& color : colors) shown.push_back(map.shown(map.index_of(color)));
    return shown;
}

std::vector<Rgba> through_map(const std::vector<Rgba>& colors, const ColorMap& map) {
    std::vector<Rgba> shown = shown_picture(colors, map);
    for (Rgba& color : shown) color[3] = 255;
    return shown;
}

std::string index_text(const ColorMap& map, const Rgba& color) {
    const std::string index = fmt::format("index {}", map.index_of(color));
    return map.planes == IndexPlanes::Window ? index
                                             : fmt::format("{} {}", name_of(map.planes), index);
}

std::string index_change_text(const ColorMap& map, const Rgba& before, const Rgba& after) {
    const unsigned index = map.index_of(after);
    std::string out = index_text(map, before);
    if (map.index_of(before) != index) out += fmt::format(" > {}", index);
    if (map.shows_below(index)) return out + ", which shows what is below";
    const auto [r, g, b] = map.entry(index);
    return out + fmt::format(" through map entry {} ({} {} {})", index, r, g, b);
}

}  // namespace gw::inspect
