// OpenGL's state in its attribute groups: one struct for each bit of PushAttrib, with the initial
// values of [GL11] tables 6.5 to 6.22. Enumerations are kept as GL's own values, so that queries
// need no second table. Plain data; nothing here knows the machine.
#pragma once

#include "gw/base/types.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gw::gl {

inline constexpr int light_count = 8;
inline constexpr std::size_t texture_unit_count = 4;
inline constexpr int texture_stack_depth = 10, modelview_stack_depth = 32;
inline constexpr int projection_stack_depth = 10;

/// Texture coordinates s, t, r, q of units 1 to 3.
using FurtherTexcoords = std::array<vec4, texture_unit_count - 1>;
inline constexpr FurtherTexcoords initial_further_texcoords{vec4(0, 0, 0, 1), vec4(0, 0, 0, 1),
                                                            vec4(0, 0, 0, 1)};

/// GL_CURRENT_BIT. [GL11] table 6.5
struct CurrentState {
    vec4 color{1, 1, 1, 1};
    vec3 secondary_color{0, 0, 0};
    float fog_coordinate = 0;
    float index = 1;
    vec3 normal{0, 0, 1};
    vec4 texcoord{0, 0, 0, 1};  ///< s, t, r, q
    FurtherTexcoords further_texcoords = initial_further_texcoords;
    bool edge_flag = true;
    struct Raster {
        dvec4 position{0, 0, 0, 1};  ///< window coordinates; w is the clip coordinate
        double distance = 0;         ///< from the eye, for fog; or the fog coordinate
        vec4 color{1, 1, 1, 1};
        vec3 secondary_color{0, 0, 0};
        float index = 1;
        vec4 texcoord{0, 0, 0, 1};
        FurtherTexcoords further_texcoords = initial_further_texcoords;
        bool valid = true;
        bool operator==(const Raster&) const = default;
    } raster;
    bool operator==(const CurrentState&) const = default;
};

/// GL_POINT_BIT
struct PointState {
    float size = 1;
    bool smooth = false, sprite = false;
    float min_size = 0, max_size = 128;
    float fade_threshold = 1;  ///< without effect: fading is optional (OpenGL 1.5, 3.3)
    vec3 attenuation{1, 0, 0};
    std::array<bool, 4> coord_replace{};  ///< of texture units
    bool operator==(const PointState&) const = default;
};

/// GL_LINE_BIT
struct LineState {
    float width = 1;
    bool smooth = false;
    bool stipple = false;
    int stipple_factor = 1;
    std::uint16_t stipple_pattern = 0xFFFF;
    bool operator==(const LineState&) const = default;
};

/// GL_POLYGON_BIT
struct PolygonState {
    bool cull = false;
    GLenum cull_face = GL_BACK, front_face = GL_CCW;
    GLenum front_mode = GL_FILL, back_mode = GL_FILL;
    bool smooth = false;
    bool stipple = false;
    float offset_factor = 0, offset_units = 0;
    bool offset_point = false, offset_line = false, offset_fill = false;
    bool operator==(const PolygonState&) const = default;
};

/// Rows of a polygon stipple, bottom row first; bit 31 is the leftmost pixel.
using Stipple = std::array<std::uint32_t, 32>;
/// GL_POLYGON_STIPPLE_BIT. Null: all bits are set.
struct PolygonStippleState {
    std::shared_ptr<const Stipple> pattern;
    bool operator==(const PolygonStippleState&) const = default;
};

/// GL_PIXEL_MODE_BIT; the pixel maps are not part of it. [GL11] 3.6.3
struct PixelState {
    vec4 scale{1, 1, 1, 1}, bias{0, 0, 0, 0};
    float depth_scale = 1, depth_bias = 0;
    int index_shift = 0, index_offset = 0;
    bool map_color = false, map_stencil = false;
    float zoom_x = 1, zoom_y = 1;
    GLenum read_buffer = GL_FRONT;
    bool operator==(const PixelState&) const = default;
};

inline constexpr int pixel_map_count = 10;
inline constexpr int max_pixel_map = 256;
/// The ten tables of pixel transfer. [GL11] 3.6.3. No group of PushAttrib has them.
struct PixelMaps {
    /// GL_PIXEL_MAP_I_TO_I .. GL_PIXEL_MAP_A_TO_A. Values of the maps to indices are integers.
    std::array<std::vector<float>, pixel_map_count> tables;
    PixelMaps() { tables.fill({0.0f}); }
    const std::vector<float>& operator[](GLenum map) const {
        return tables[map - GL_PIXEL_MAP_I_TO_I];
    }
};

constexpr bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

struct LightState {
    bool enable = false;
    vec4 ambient{0, 0, 0, 1}, diffuse{0, 0, 0, 1}, specular{0, 0, 0, 1};
    vec4 position{0, 0, 1, 0};  ///< in eye space
    vec3 spot_direction{0, 0, -1};
    float spot_exponent = 0, spot_cutoff = 180;
    float constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0;
    bool operator==(const LightState&) const = default;
};
struct MaterialState {
    vec4 ambient{0.2f, 0.2f, 0.2f, 1}, diffuse{0.8f, 0.8f, 0.8f, 1};
    vec4 specular{0, 0, 0, 1}, emission{0, 0, 0, 1};
    float shininess = 0;
    vec3 indexes{0, 1, 1};  ///< ambient, diffuse, specular
    bool operator==(const MaterialState&) const = default;
};
/// GL_LIGHTING_BIT
struct LightingState {
    bool enable = false;
    GLenum shade_model = GL_SMOOTH;
    vec4 model_ambient{0.2f, 0.2f, 0.2f, 1};
    bool local_viewer = false, two_side = false;
    GLenum color_control = GL_SINGLE_COLOR;
    bool color_material = false;
    GLenum color_material_face = GL_FRONT_AND_BACK;
    GLenum color_material_mode = GL_AMBIENT_AND_DIFFUSE;
    std::array<MaterialState, 2> material{};  ///< front, back
    std::array<LightState, light_count> lights{
        {{.enable = false, .diffuse = {1, 1, 1, 1}, .specular = {1, 1, 1, 1}}}};
    bool operator==(const LightingState&) const = default;
};

/// GL_FOG_BIT
struct FogState {
    bool enable = false;
    GLenum mode = GL_EXP;
    float density = 1, start = 0, end = 1, index = 0;
    vec4 color{0, 0, 0, 0};
    GLenum coordinate_source = GL_FRAGMENT_DEPTH;
    bool color_sum = false;
    bool operator==(const FogState&) const = default;
};

/// GL_DEPTH_BUFFER_BIT
struct DepthState {
    bool test = false;
    GLenum func = GL_LESS;
    bool mask = true;
    double clear = 1;
    bool operator==(const DepthState&) const = default;
};

/// GL_ACCUM_BUFFER_BIT
struct AccumState {
    vec4 clear{0, 0, 0, 0};
    bool operator==(const AccumState&) const = default;
};

/// GL_STENCIL_BUFFER_BIT
struct StencilState {
    bool test = false;
    GLenum func = GL_ALWAYS;
    int ref = 0;
    GLuint mask = ~0u;
    GLenum fail = GL_KEEP, zfail = GL_KEEP, zpass = GL_KEEP;
    GLuint write_mask = ~0u;
    int clear = 0;
    bool operator==(const StencilState&) const = default;
};

/// GL_VIEWPORT_BIT
struct ViewportState {
    int x = 0, y = 0, width = 0, height = 0;
    double near_value = 0, far_value = 1;
    bool operator==(const ViewportState&) const = default;
};

/// Whether no primitive can have a fragment.
inline bool is_empty(const ViewportState& v) { return v.width == 0 || v.height == 0; }

/// GL_TRANSFORM_BIT; matrices are not part of it.
struct TransformState {
    GLenum matrix_mode = GL_MODELVIEW;
    std::array<bool, 6> clip_enable{};
    std::array<dvec4, 6> clip_plane{};  ///< in eye space
    bool normalize = false, rescale_normal = false;
    GLenum clip_origin = GL_LOWER_LEFT, clip_depth_mode = GL_NEGATIVE_ONE_TO_ONE;
    bool operator==(const TransformState&) const = default;
};

/// GL_COLOR_BUFFER_BIT
struct ColorBufferState {
    bool alpha_test = false;
    GLenum alpha_func = GL_ALWAYS;
    float alpha_ref = 0;
    bool blend = false;
    GLenum blend_src = GL_ONE, blend_dst = GL_ZERO;
    GLenum blend_equation = GL_FUNC_ADD;
    GLenum blend_src_alpha = GL_ONE, blend_dst_alpha = GL_ZERO;
    GLenum blend_equation_alpha = GL_FUNC_ADD;
    vec4 blend_color{0, 0, 0, 0};
    bool dither = true;
    bool logic_op = false, index_logic_op = false;
    GLenum logic_op_mode = GL_COPY;
    GLenum draw_buffer = GL_FRONT;
    std::array<bool, 4> mask{true, true, true, true};
    std::array<std::uint16_t, 4> mask_bits{0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};  ///< of IRIS GL
    GLuint index_mask = ~0u;
    vec4 clear{0, 0, 0, 0};
    float clear_index = 0;
    bool operator==(const ColorBufferState&) const = default;
};

/// GL_HINT_BIT
struct HintState {
    GLenum perspective_correction = GL_DONT_CARE, point_smooth = GL_DONT_CARE;
    GLenum line_smooth = GL_DONT_CARE, polygon_smooth = GL_DONT_CARE, fog = GL_DONT_CARE;
    GLenum generate_mipmap = GL_DONT_CARE, texture_compression = GL_DONT_CARE;
    bool operator==(const HintState&) const = default;
};

inline constexpr int map_count = 9;
/// GL_EVAL_BIT; the control points are not part of it.
struct EvalState {
    std::array<bool, map_count> map1{}, map2{};  ///< GL_MAP1_COLOR_4 ..
    bool auto_normal = false;
    int grid1_segments = 1;
    double grid1_u1 = 0, grid1_u2 = 1;
    std::array<int, 2> grid2_segments{1, 1};
    double grid2_u1 = 0, grid2_u2 = 1, grid2_v1 = 0, grid2_v2 = 1;
    bool operator==(const EvalState&) const = default;
};

/// GL_LIST_BIT
struct ListState {
    GLuint base = 0;
    bool operator==(const ListState&) const = default;
};

struct TexGenState {
    bool enable = false;
    GLenum mode = GL_EYE_LINEAR;
    dvec4 object_plane{0, 0, 0, 0}, eye_plane{0, 0, 0, 0};
    bool operator==(const TexGenState&) const = default;
};
/// The parameters of a texture object. [GL11] table 6.13
struct TextureParameters {
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
    GLenum wrap_s = GL_REPEAT, wrap_t = GL_REPEAT, wrap_r = GL_REPEAT;
    vec4 border_color{0, 0, 0, 0};
    float priority = 1;
    float min_lod = -1000, max_lod = 1000, lod_bias = 0;
    int base_level = 0, max_level = 1000;
    bool generate_mipmap = false;
    GLenum depth_mode =
        GL_LUMINANCE;  ///< of depths: the format of what they or their comparison give
    GLenum compare_mode = GL_NONE, compare_func = GL_LEQUAL;
    bool operator==(const TextureParameters&) const = default;
};
/// GL_COMBINE's function of colours or of alpha. [GL13] 3.8.12
struct CombineState {
    GLenum func = GL_MODULATE;
    std::array<GLenum, 3> source{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}, operand{};
    int scale = 1;  ///< 1, 2 or 4
    bool operator==(const CombineState&) const = default;
};
/// Levels of detail are moved by at most so many.
inline constexpr float max_lod_bias = 16;
/// The texture targets by their precedence, the last first.
inline constexpr std::array<GLenum, 5> texture_targets{
    GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
inline constexpr std::size_t texture_target_count = texture_targets.size();
/// One texture unit. [GL13] table 6.17
struct TextureUnit {
    std::array<bool, texture_target_count> enable{};
    std::array<GLuint, texture_target_count> bound{};
    GLenum env_mode = GL_MODULATE;
    vec4 env_color{0, 0, 0, 0};
    CombineState combine_rgb{.operand = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA}};
    CombineState combine_alpha{.operand = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA}};
    float lod_bias = 0;            ///< of the unit; the texture's own is added
    std::array<TexGenState, 4> gen{///< of s, t, r, q
                                   {{.object_plane = {1, 0, 0, 0}, .eye_plane = {1, 0, 0, 0}},
                                    {.object_plane = {0, 1, 0, 0}, .eye_plane = {0, 1, 0, 0}}}};

    bool is_enabled() const {
        return enable[0] || enable[1] || enable[2] || enable[3] || enable[4];
    }
    bool generates() const {
        return gen[0].enable || gen[1].enable || gen[2].enable || gen[3].enable;
    }
    bool operator==(const TextureUnit&) const = default;
};
/// GL_TEXTURE_BIT. PushAttrib also keeps the parameters of the bound textures.
struct TextureState {
    std::size_t active = 0;  ///< the unit that calls and queries are about
    std::array<TextureUnit, texture_unit_count> units;
    bool seamless = false;  ///< cubes are filtered over their edges

    TextureUnit& unit() { return units[active]; }
    const TextureUnit& unit() const { return units[active]; }
    /// Whether a unit beside the first has a texture.
    bool uses_further_units() const {
        return units[1].is_enabled() || units[2].is_enabled() || units[3].is_enabled();
    }
    bool operator==(const TextureState&) const = default;
};

/// GL_MULTISAMPLE_BIT. Without effect if what is drawn to has no samples.
struct MultisampleState {
    bool multisample = true, alpha_to_coverage = false, alpha_to_one = false, coverage = false;
    float coverage_value = 1;
    bool coverage_invert = false;
    bool operator==(const MultisampleState&) const = default;
};

/// GL_SCISSOR_BIT
struct ScissorState {
    bool test = false;
    Rect box;
    bool operator==(const ScissorState&) const = default;
};

/// All groups.
struct State {
    CurrentState current;
    PointState point;
    LineState line;
    PolygonState polygon;
    PolygonStippleState polygon_stipple;
    PixelState pixel;
    LightingState lighting;
    FogState fog;
    DepthState depth;
    AccumState accum;
    StencilState stencil;
    ViewportState viewport;
    TransformState transform;
    ColorBufferState color_buffer;
    HintState hint;
    EvalState eval;
    ListState list;
    TextureState texture;
    ScissorState scissor;
    MultisampleState multisample;
    bool operator==(const State&) const = default;
};

}  // namespace gw::gl
