// All that a program of IRIS GL has outside its windows: definitions, objects, the colour map, devices.
#pragma once

#include "irisgl/state/cursor_image.h"
#include "irisgl/state/events.h"
#include "irisgl/state/menus.h"
#include "irisgl/state/objects.h"
#include "irisgl/state/state.h"
#include "irisgl/state/tokens.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gw::irisgl {

class Window;

/// 8 bits a channel, R lowest.
using MapEntry = std::uint32_t;

struct Blink {
    short rate = 0;
    MapEntry other = 0;
    bool shows_other = false;
};

/// After `duration` retraces the map `next` follows.
struct Cycle {
    short duration = 0;
    unsigned next = 0;
};

struct ColorMap {
    ColorMap();
    std::array<MapEntry, 4096> entries{};
    std::map<unsigned, Blink> blinks;
    /// The maps of overlay, underlay and pop-up planes, and of cursors.
    std::array<std::array<MapEntry, 256>, 4> aside{};
    bool is_multi = false;             ///< 16 maps of 256 entries each instead of one
    unsigned number = 0;               ///< setmap
    std::map<unsigned, Cycle> cycles;  ///< by map: cyclemap
    /// The entry of an index in the map that is shown.
    unsigned place(unsigned index) const { return is_multi ? number * 256 + index % 256 : index; }
    std::array<std::array<std::uint8_t, 256>, 3> gamma{};
    std::uint64_t changes = 0;
};

struct Material {
    vec4 ambient{0.2f, 0.2f, 0.2f, 1}, diffuse{0.8f, 0.8f, 0.8f, 1}, specular{0, 0, 0, 1},
        emission{0, 0, 0, 1};
    float shininess = 0, alpha = 1;
    vec3 indices{0, 0, 0};  ///< ambient, diffuse, specular: colour map mode
};
struct Light {
    vec4 ambient{0, 0, 0, 1}, color{1, 1, 1, 1}, position{0, 0, 1, 0};
    vec4 direction{0, 0, -1, 0};
    float exponent = 0, spread = 180;
};
struct LightModel {
    vec4 ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false, two_side = false;
    vec2 attenuation{1, 0};
    float attenuation2 = 0;
};

struct Pattern {
    int size = 0;
    std::vector<std::uint16_t> rows;  ///< bottom row first, size / 16 words each
    bool bit(int x, int y) const;
};

struct Glyph {
    int w = 0, h = 0, xoff = 0, yoff = 0, width = 0;
    std::vector<std::uint16_t> rows;  ///< bottom row first, the highest bit on the left
};
struct Font {
    std::vector<Glyph> glyphs;
    int height = 0, descender = 0;
};

/// A font of the font manager: font 0, scaled.
struct ManagedFont {
    double size = 0;  ///< pixels of a line
    Font font;
};

struct TextureDefinition {
    int components = 0;
    long width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    std::vector<float> properties;
    unsigned version = 0;
};

/// What prefposition and its kin ask of the next window.
struct WindowHints {
    long width = 0, height = 0;  ///< 0: any
    bool has_origin = false;
    long x = 0, y = 0;
    long min_width = 0, min_height = 0, max_width = 0, max_height = 0;
    long aspect_x = 0, aspect_y = 0;
    bool has_border = true;
};

struct Program {
    std::map<long, std::unique_ptr<Window>> windows;
    Window* current = nullptr;
    WindowHints hints;
    ColorMap colors;
    Objects objects;
    Events events;
    Menus menus;
    std::map<short, Material> materials;
    std::map<short, Light> lights;
    std::map<short, LightModel> models;
    std::map<short, std::uint16_t> linestyles{{0, 0xFFFF}};
    std::map<short, Pattern> patterns;
    std::map<short, dmat4> bases;
    std::map<short, Font> fonts;
    std::map<long, ManagedFont> managed_fonts;
    long managed_font = 0;  ///< of fmprstr; 0: none
    std::map<long, TextureDefinition> textures;
    std::map<long, std::vector<float>> environments;
    std::map<short, CursorImage> cursors;
    std::size_t cursor_type = 0;  ///< curstype
    short cursor = 0;
    bool is_cursor_on = true;
    /// glcompat: polygons but those of bgnpolygon, bgntmesh and bgnqstrip own the pixels of their edges.
    bool are_polygons_old = true;
    /// glcompat: ranges of depths are 0 to z_max on any machine.
    bool are_depths_mapped = false;
};

/// The process' one. Never destroyed: exit handlers may draw.
Program& program();
/// The current window. Precondition: there is one.
Window& current_window();
State& state();

/// Once for each text: "gw: ..." on stderr.
void warn(const std::string& text);

}  // namespace gw::irisgl
