#include "irisgl/state/program.h"

#include "irisgl/window/window.h"

#include <cstdio>
#include <set>

namespace gw::irisgl {

namespace {

constexpr MapEntry rgb_entry(unsigned r, unsigned g, unsigned b) { return r | g << 8 | b << 16; }

/// The first 16 entries of the map when a program starts.
constexpr std::array first_entries{
    rgb_entry(0, 0, 0),       rgb_entry(255, 0, 0),     rgb_entry(0, 255, 0),
    rgb_entry(255, 255, 0),   rgb_entry(0, 0, 255),     rgb_entry(255, 0, 255),
    rgb_entry(0, 255, 255),   rgb_entry(255, 255, 255), rgb_entry(85, 85, 85),
    rgb_entry(198, 113, 113), rgb_entry(113, 198, 113), rgb_entry(142, 142, 56),
    rgb_entry(113, 113, 198), rgb_entry(142, 56, 142),  rgb_entry(56, 142, 142),
    rgb_entry(170, 170, 170)};

}  // namespace

ColorMap::ColorMap() {
    for (std::size_t i = 0; i < first_entries.size(); ++i) entries[i] = first_entries[i];
    for (auto& planes : aside)
        planes = {0, rgb_entry(255, 0, 0), rgb_entry(0, 255, 0), rgb_entry(0, 0, 255)};
    aside[2] = {0, rgb_entry(170, 170, 170), rgb_entry(0, 0, 0), rgb_entry(255, 255, 255)};
    for (auto& channel : gamma)
        for (std::size_t i = 0; i < 256; ++i) channel[i] = std::uint8_t(i);
}

bool Pattern::bit(int x, int y) const {
    const int words = size / 16, row = y % size, column = x % size;
    const std::uint16_t word = rows[std::size_t(row * words + column / 16)];
    return (word >> (15 - column % 16) & 1) != 0;
}

Program& program() {
    static Program& one = *new Program;
    return one;
}

Window& current_window() { return *program().current; }
State& state() { return program().current->state; }

void warn(const std::string& text) {
    static std::set<std::string>& said = *new std::set<std::string>;
    if (said.insert(text).second) std::fprintf(stderr, "gw: %s\n", text.c_str());
}

}  // namespace gw::irisgl
