// Colours that are indices of a colour map, as in IRIS GL's colour map mode: how a screen shows them.
// Does not change what is drawn.
#pragma once

#include "gw/planes.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gw::inspect {

/// The planes of a window that a machine draws. Index 0 of the last three shows what is below them.
enum class IndexPlanes : std::uint8_t { Window, Overlay, Underlay, PopUp };

inline constexpr int most_index_bits = 16;

struct ColorMap {
    IndexPlanes planes = IndexPlanes::Window;
    int bits = 0;       ///< of an index; 0: colours are not indices
    int bits_in_r = 8;  ///< of an index, its lowest; the others are in G
    std::vector<std::uint32_t>
        entries;  ///< 2^bits of 8 bits a channel, R lowest, as a screen shows

    bool operator==(const ColorMap&) const = default;
    unsigned index_of(const Rgba& color) const;
    bool shows_below(unsigned index) const { return planes != IndexPlanes::Window && index == 0; }
    /// R, G, B of the entry, 0 to 255 each; black if the index shows what is below.
    std::array<std::uint16_t, 3> entry(unsigned index) const;
    /// The entry with the alpha 255; 0 if the index shows what is below.
    Rgba shown(unsigned index) const;
};

/// Throws Error unless there are as many entries as indices.
void check_color_map(const ColorMap& map);

/// The shown picture of docs/manual/indices.md. Precondition: colours are indices.
std::vector<Rgba> shown_picture(const std::vector<Rgba>& colors, const ColorMap& map);
/// The same on black.
std::vector<Rgba> through_map(const std::vector<Rgba>& colors, const ColorMap& map);

/// "window", "overlay", "underlay", "pop-up"
const char* name_of(IndexPlanes planes);
inline constexpr std::array every_index_planes{IndexPlanes::Window, IndexPlanes::Overlay,
                                               IndexPlanes::Underlay, IndexPlanes::PopUp};
/// "index 37", "overlay index 2"
std::string index_text(const ColorMap& map, const Rgba& color);
/// "index 0 > 37 through map entry 37 (200 100 50)", with one index if it stays;
/// "overlay index 2 > 0, which shows what is below"
std::string index_change_text(const ColorMap& map, const Rgba& before, const Rgba& after);

}  // namespace gw::inspect
