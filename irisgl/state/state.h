// The state of a window of IRIS GL, with the manual's initial values. Plain data.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gw::irisgl {

/// Bits of a colour index.
inline constexpr int index_bits = 12;
inline constexpr unsigned index_mask = (1u << index_bits) - 1;
/// The range of depths: 24 bits, signed.
inline constexpr long z_min = -0x800000, z_max = 0x7fffff;
inline constexpr int light_count = 8;
inline constexpr std::size_t matrix_stack_depth = 32, viewport_stack_depth = 8,
                             attribute_stack_depth = 10;

/// Pixels, both ends included.
struct Bounds {
    int left = 0, right = 0, bottom = 0, top = 0;
    int width() const { return right - left + 1; }
    int height() const { return top - bottom + 1; }
};

/// What a draw mode (NORMALDRAW, OVERDRAW ...) has for itself.
struct PlaneState {
    double index = 0;  ///< 0 .. 4095; a fraction is rounded where it is drawn
    unsigned writemask = index_mask;
    vec4 rgb{0, 0, 0, 1};  ///< 0 .. 1
    std::uint32_t rgb_mask = 0xFFFFFFFF;
};

/// The place of a draw mode in Attributes: drawmode's words are bits from 0x10 on.
constexpr std::size_t plane_of(long draw_mode) {
    return std::size_t(std::countr_zero(static_cast<unsigned long>(draw_mode)) - 4);
}

/// What pushattributes keeps.
struct Attributes {
    std::array<PlaneState, 5> planes;
    long shade_model = 1;
    double line_width = 1, point_size = 1;
    short linestyle = 0, pattern = 0, font = 0;
    long linestyle_repeat = 1;
    bool front = false, back = true;
};

struct LineSmoothing {
    bool lines = false, points = false, polygons = false;
};

struct DepthCue {
    bool on = false;
    unsigned low = 0, high = 7;  ///< indices
    std::array<float, 6> rgb{0, 0, 0, 255, 255, 255};
    long near = z_min, far = z_max;
};

/// How lrectread and lrectwrite see the program's memory: pixmode.
struct PixelMemory {
    long shift = 0;  ///< bits to the left when written, to the right when read
    bool expands = false;
    std::uint32_t c0 = 0, c1 = 0;  ///< what a bit that expands becomes
    long add = 0;                  ///< to the lower 24 bits
    long size = 32;                ///< bits of a pixel
    long offset = 0;               ///< bits of a row before its first pixel
    long stride = 0;               ///< words of a row; 0: as many as it needs
    bool top_to_bottom = false, right_to_left = false, are_depths = false;
};

struct Pixels {
    float zoom_x = 1, zoom_y = 1;
    long source = 0;  ///< readsource
    PixelMemory memory;
};

/// The smallest box of pixels around what was drawn: scrbox. Empty: left is greater than right.
struct ScreenBox {
    bool is_tracked = false;
    long left = 0x7fff, right = -1, bottom = 0x7fff, top = -1;
};

/// What lmbind has bound; 0: nothing.
struct Bound {
    short material = 0, back_material = 0, model = 0;
    std::array<short, light_count> lights{};
    std::array<vec4, light_count> positions{}, directions{};  ///< eye space
    long color_mode = 0;                                      ///< lmcolor
    bool is_lit() const { return material != 0 && model != 0; }
};

struct State {
    bool rgb_mode = false, double_buffered = false;
    long draw_mode = 0x10;  ///< NORMALDRAW
    Attributes now;
    std::vector<Attributes> attribute_stack;
    long matrix_mode = 0;  ///< MSINGLE
    std::vector<dmat4> matrices{dmat4(1)};
    dmat4 projection{1}, texture{1};
    Bounds viewport, screen_mask;
    std::vector<std::array<Bounds, 2>> viewport_stack;
    bool depth_test = false, depth_write = true;
    long depth_function = 3;                       ///< ZF_LEQUAL
    long blend_source = 1, blend_destination = 0;  ///< BF_ONE, BF_ZERO
    long near = z_min, far = z_max;
    bool backface = false, frontface = false, concave = false, line_backup = false,
         line_reset = true, subpixel = false, draws_depth = false,
         textured = false,                          ///< texture and environment are bound
        compares_color = false;                     ///< zsource(ZSRC_COLOR)
    long bound_texture = 0, bound_environment = 0;  ///< bound; 0: none
    std::array<long, 3> stencil_operations{};       ///< fail, pass, zpass: ST_KEEP
    long polygon_mode = 1;                          ///< PYM_FILL
    LineSmoothing smooth;
    DepthCue cue;
    Pixels pixels;
    Bound bound;
    ScreenBox box;
    dvec4 position{0, 0, 0, 1};  ///< the graphics position
    vec3 normal{0, 0, 1};
    vec4 texture_coordinate{0, 0, 0, 1};
    bool is_lit = false;  ///< a normal came after the last colour
    std::array<short, 2> character{};
    double character_depth = 0;  ///< -1 .. 1
    bool is_character_valid = true;
    short basis = 0, u_basis = 0, v_basis = 0;
    std::optional<dmat4> curve_matrix;
    long curve_segments = 20, u_curves = 4, v_curves = 4, u_segments = 10, v_segments = 10;
};

}  // namespace gw::irisgl
