// The initial state, as [GL11] tables 6.5 to 6.22 give it, and how queries convert values.
#include "tests/gl/unit/support/window.h"

#include <cstring>
#include <string>

namespace gw::gl {
namespace {

struct Initial {
    GLenum name;
    std::vector<double> values;
};
const std::vector<double> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

const std::vector<Initial> initial_state{
    // Table 6.5
    {GL_CURRENT_COLOR, {1, 1, 1, 1}},
    {GL_CURRENT_INDEX, {1}},
    {GL_CURRENT_SECONDARY_COLOR, {0, 0, 0, 1}},
    {GL_CURRENT_FOG_COORDINATE, {0}},
    {GL_CURRENT_TEXTURE_COORDS, {0, 0, 0, 1}},
    {GL_CURRENT_NORMAL, {0, 0, 1}},
    {GL_CURRENT_RASTER_POSITION, {0, 0, 0, 1}},
    {GL_CURRENT_RASTER_DISTANCE, {0}},
    {GL_CURRENT_RASTER_COLOR, {1, 1, 1, 1}},
    {GL_CURRENT_RASTER_INDEX, {1}},
    {GL_CURRENT_RASTER_TEXTURE_COORDS, {0, 0, 0, 1}},
    {GL_CURRENT_RASTER_POSITION_VALID, {1}},
    {GL_EDGE_FLAG, {1}},
    // Table 6.6, 6.7
    {GL_VERTEX_ARRAY, {0}},
    {GL_VERTEX_ARRAY_SIZE, {4}},
    {GL_VERTEX_ARRAY_TYPE, {GL_FLOAT}},
    {GL_VERTEX_ARRAY_STRIDE, {0}},
    {GL_NORMAL_ARRAY, {0}},
    {GL_NORMAL_ARRAY_TYPE, {GL_FLOAT}},
    {GL_COLOR_ARRAY, {0}},
    {GL_COLOR_ARRAY_SIZE, {4}},
    {GL_COLOR_ARRAY_TYPE, {GL_FLOAT}},
    {GL_INDEX_ARRAY, {0}},
    {GL_INDEX_ARRAY_TYPE, {GL_FLOAT}},
    {GL_TEXTURE_COORD_ARRAY, {0}},
    {GL_TEXTURE_COORD_ARRAY_SIZE, {4}},
    {GL_SECONDARY_COLOR_ARRAY, {0}},
    {GL_SECONDARY_COLOR_ARRAY_SIZE, {3}},
    {GL_SECONDARY_COLOR_ARRAY_TYPE, {GL_FLOAT}},
    {GL_FOG_COORDINATE_ARRAY, {0}},
    {GL_FOG_COORDINATE_ARRAY_TYPE, {GL_FLOAT}},
    {GL_EDGE_FLAG_ARRAY, {0}},
    {GL_EDGE_FLAG_ARRAY_STRIDE, {0}},
    // Table 6.8; the viewport is the drawable's
    {GL_MODELVIEW_MATRIX, identity},
    {GL_PROJECTION_MATRIX, identity},
    {GL_TEXTURE_MATRIX, identity},
    {GL_VIEWPORT, {0, 0, 40, 30}},
    {GL_DEPTH_RANGE, {0, 1}},
    {GL_MODELVIEW_STACK_DEPTH, {1}},
    {GL_PROJECTION_STACK_DEPTH, {1}},
    {GL_TEXTURE_STACK_DEPTH, {1}},
    {GL_MATRIX_MODE, {GL_MODELVIEW}},
    {GL_NORMALIZE, {0}},
    {GL_CLIP_ORIGIN, {GL_LOWER_LEFT}},
    {GL_CLIP_DEPTH_MODE, {GL_NEGATIVE_ONE_TO_ONE}},
    {GL_CLIP_PLANE0, {0}},
    {GL_CLIP_PLANE5, {0}},
    // Table 6.9
    {GL_FOG_COLOR, {0, 0, 0, 0}},
    {GL_FOG_INDEX, {0}},
    {GL_FOG_DENSITY, {1}},
    {GL_FOG_START, {0}},
    {GL_FOG_END, {1}},
    {GL_FOG_MODE, {GL_EXP}},
    {GL_FOG, {0}},
    {GL_FOG_COORDINATE_SOURCE, {GL_FRAGMENT_DEPTH}},
    {GL_COLOR_SUM, {0}},
    {GL_SHADE_MODEL, {GL_SMOOTH}},
    // Table 6.10
    {GL_LIGHTING, {0}},
    {GL_COLOR_MATERIAL, {0}},
    {GL_COLOR_MATERIAL_PARAMETER, {GL_AMBIENT_AND_DIFFUSE}},
    {GL_COLOR_MATERIAL_FACE, {GL_FRONT_AND_BACK}},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, {0}},
    {GL_LIGHT_MODEL_TWO_SIDE, {0}},
    {GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR}},
    {GL_LIGHT0, {0}},
    {GL_LIGHT7, {0}},
    // Table 6.12
    {GL_POINT_SIZE, {1}},
    {GL_POINT_SMOOTH, {0}},
    {GL_POINT_SIZE_MIN, {0}},
    {GL_POINT_SIZE_MAX, {128}},
    {GL_POINT_FADE_THRESHOLD_SIZE, {1}},
    {GL_POINT_DISTANCE_ATTENUATION, {1, 0, 0}},
    {GL_POINT_SPRITE, {0}},
    {GL_LINE_WIDTH, {1}},
    {GL_LINE_SMOOTH, {0}},
    {GL_LINE_STIPPLE_PATTERN, {0xFFFF}},
    {GL_LINE_STIPPLE_REPEAT, {1}},
    {GL_LINE_STIPPLE, {0}},
    {GL_CULL_FACE, {0}},
    {GL_CULL_FACE_MODE, {GL_BACK}},
    {GL_FRONT_FACE, {GL_CCW}},
    {GL_POLYGON_SMOOTH, {0}},
    {GL_POLYGON_MODE, {GL_FILL, GL_FILL}},
    {GL_POLYGON_OFFSET_FACTOR, {0}},
    {GL_POLYGON_OFFSET_UNITS, {0}},
    {GL_POLYGON_OFFSET_POINT, {0}},
    {GL_POLYGON_OFFSET_LINE, {0}},
    {GL_POLYGON_OFFSET_FILL, {0}},
    {GL_POLYGON_STIPPLE, {0}},
    // Table 6.13, 6.14
    {GL_TEXTURE_1D, {0}},
    {GL_TEXTURE_2D, {0}},
    {GL_TEXTURE_BINDING_1D, {0}},
    {GL_TEXTURE_BINDING_2D, {0}},
    {GL_TEXTURE_GEN_S, {0}},
    {GL_TEXTURE_GEN_Q, {0}},
    // Table 6.15
    {GL_SCISSOR_TEST, {0}},
    {GL_SCISSOR_BOX, {0, 0, 40, 30}},
    {GL_ALPHA_TEST, {0}},
    {GL_ALPHA_TEST_FUNC, {GL_ALWAYS}},
    {GL_ALPHA_TEST_REF, {0}},
    {GL_STENCIL_TEST, {0}},
    {GL_STENCIL_FUNC, {GL_ALWAYS}},
    {GL_STENCIL_REF, {0}},
    {GL_STENCIL_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_FAIL, {GL_KEEP}},
    {GL_STENCIL_PASS_DEPTH_PASS, {GL_KEEP}},
    {GL_DEPTH_TEST, {0}},
    {GL_DEPTH_FUNC, {GL_LESS}},
    {GL_BLEND, {0}},
    {GL_BLEND_SRC, {GL_ONE}},
    {GL_BLEND_DST, {GL_ZERO}},
    {GL_DITHER, {1}},
    {GL_INDEX_LOGIC_OP, {0}},
    {GL_COLOR_LOGIC_OP, {0}},
    {GL_LOGIC_OP_MODE, {GL_COPY}},
    // Table 6.16
    {GL_COLOR_WRITEMASK, {1, 1, 1, 1}},
    {GL_DEPTH_WRITEMASK, {1}},
    {GL_COLOR_CLEAR_VALUE, {0, 0, 0, 0}},
    {GL_INDEX_CLEAR_VALUE, {0}},
    {GL_DEPTH_CLEAR_VALUE, {1}},
    {GL_STENCIL_CLEAR_VALUE, {0}},
    {GL_ACCUM_CLEAR_VALUE, {0, 0, 0, 0}},
    // Table 6.17
    {GL_UNPACK_SWAP_BYTES, {0}},
    {GL_UNPACK_LSB_FIRST, {0}},
    {GL_UNPACK_ROW_LENGTH, {0}},
    {GL_UNPACK_SKIP_ROWS, {0}},
    {GL_UNPACK_SKIP_PIXELS, {0}},
    {GL_UNPACK_ALIGNMENT, {4}},
    {GL_PACK_ALIGNMENT, {4}},
    {GL_MAP_COLOR, {0}},
    {GL_MAP_STENCIL, {0}},
    {GL_INDEX_SHIFT, {0}},
    {GL_INDEX_OFFSET, {0}},
    {GL_RED_SCALE, {1}},
    {GL_ALPHA_BIAS, {0}},
    {GL_DEPTH_SCALE, {1}},
    {GL_DEPTH_BIAS, {0}},
    // Table 6.18
    {GL_PIXEL_MAP_I_TO_I_SIZE, {1}},
    {GL_PIXEL_MAP_A_TO_A_SIZE, {1}},
    {GL_ZOOM_X, {1}},
    {GL_ZOOM_Y, {1}},
    // Table 6.19
    {GL_MAP1_VERTEX_3, {0}},
    {GL_MAP2_COLOR_4, {0}},
    {GL_MAP1_GRID_DOMAIN, {0, 1}},
    {GL_MAP1_GRID_SEGMENTS, {1}},
    {GL_MAP2_GRID_DOMAIN, {0, 1, 0, 1}},
    {GL_MAP2_GRID_SEGMENTS, {1, 1}},
    {GL_AUTO_NORMAL, {0}},
    {GL_PERSPECTIVE_CORRECTION_HINT, {GL_DONT_CARE}},
    {GL_FOG_HINT, {GL_DONT_CARE}},
    // Table 6.22
    {GL_LIST_BASE, {0}},
    {GL_LIST_INDEX, {0}},
    {GL_LIST_MODE, {0}},
    {GL_ATTRIB_STACK_DEPTH, {0}},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, {0}},
    {GL_NAME_STACK_DEPTH, {0}},
    {GL_RENDER_MODE, {GL_RENDER}},
    {GL_SELECTION_BUFFER_SIZE, {0}},
    {GL_FEEDBACK_BUFFER_SIZE, {0}},
};

TEST(Queries, GiveTheInitialState) {
    const Window window(40, 30);
    for (const Initial& initial : initial_state) {
        std::vector<GLdouble> values(16, -7.0);
        glGetDoublev(initial.name, values.data());
        for (std::size_t i = 0; i < 16; ++i)
            ASSERT_EQ(values[i], i < initial.values.size() ? initial.values[i] : -7.0)
                << std::hex << initial.name << " value " << i;
        ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << std::hex << initial.name;
    }
}

/// [GL11] table 6.20: the least that an implementation has.
TEST(Queries, GiveLimitsThatAreLargeEnough) {
    const Window window;
    const std::vector<std::pair<GLenum, GLint>> least{
        {GL_MAX_LIGHTS, 8},
        {GL_MAX_CLIP_PLANES, 6},
        {GL_MAX_LIST_NESTING, 64},
        {GL_MAX_MODELVIEW_STACK_DEPTH, 32},
        {GL_MAX_TEXTURE_SIZE, 64},
        {GL_MAX_PROJECTION_STACK_DEPTH, 2},
        {GL_MAX_EVAL_ORDER, 8},
        {GL_MAX_TEXTURE_STACK_DEPTH, 2},
        {GL_MAX_PIXEL_MAP_TABLE, 32},
        {GL_MAX_NAME_STACK_DEPTH, 64},
        {GL_SUBPIXEL_BITS, 4},
        {GL_MAX_ATTRIB_STACK_DEPTH, 16},
        {GL_RED_BITS, 8},
        {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 16},
        {GL_DEPTH_BITS, 24},
        {GL_STENCIL_BITS, 8},
    };
    for (const auto& [name, value] : least) {
        GLint got = 0;
        glGetIntegerv(name, &got);
        EXPECT_GE(got, value) << std::hex << name;
    }
}

/// [GL11] 6.1.2: colours become the whole range of an integer, other numbers are rounded.
TEST(Queries, ConvertToTheTypeThatIsAskedFor) {
    const Window window;
    glColor4f(1, 0, 0.5f, 0);
    GLint color[4];
    glGetIntegerv(GL_CURRENT_COLOR, color);
    EXPECT_EQ(color[0], 2147483647);
    EXPECT_EQ(color[1], 0);
    glLineWidth(2.6f);
    GLint width = 0;
    glGetIntegerv(GL_LINE_WIDTH, &width);
    EXPECT_EQ(width, 3);
    GLboolean flag = GL_FALSE;
    glGetBooleanv(GL_LINE_WIDTH, &flag);
    EXPECT_EQ(flag, GL_TRUE);
    GLfloat mode = 0;
    glGetFloatv(GL_MATRIX_MODE, &mode);
    EXPECT_EQ(mode, GLfloat(GL_MODELVIEW));
}

TEST(Queries, KnowEveryNumberThatVersions12To15Added) {
    const Window window;
    for (const GLenum name : {
             // 1.2
             GL_ALIASED_POINT_SIZE_RANGE,
             GL_ALIASED_LINE_WIDTH_RANGE,
             GL_MAX_ELEMENTS_VERTICES,
             GL_MAX_ELEMENTS_INDICES,
             GL_LIGHT_MODEL_COLOR_CONTROL,
             GL_RESCALE_NORMAL,
             GL_PACK_SKIP_IMAGES,
             GL_PACK_IMAGE_HEIGHT,
             GL_UNPACK_SKIP_IMAGES,
             GL_UNPACK_IMAGE_HEIGHT,
             GL_TEXTURE_3D,
             GL_MAX_3D_TEXTURE_SIZE,
             GL_TEXTURE_BINDING_3D,
             // 1.3
             GL_ACTIVE_TEXTURE,
             GL_CLIENT_ACTIVE_TEXTURE,
             GL_MAX_TEXTURE_UNITS,
             GL_TRANSPOSE_MODELVIEW_MATRIX,
             GL_TRANSPOSE_PROJECTION_MATRIX,
             GL_TRANSPOSE_TEXTURE_MATRIX,
             GL_MULTISAMPLE,
             GL_SAMPLE_ALPHA_TO_COVERAGE,
             GL_SAMPLE_ALPHA_TO_ONE,
             GL_SAMPLE_COVERAGE,
             GL_SAMPLE_BUFFERS,
             GL_SAMPLES,
             GL_SAMPLE_COVERAGE_VALUE,
             GL_SAMPLE_COVERAGE_INVERT,
             GL_TEXTURE_CUBE_MAP,
             GL_TEXTURE_BINDING_CUBE_MAP,
             GL_MAX_CUBE_MAP_TEXTURE_SIZE,
             GL_TEXTURE_COMPRESSION_HINT,
             GL_NUM_COMPRESSED_TEXTURE_FORMATS,
             GL_COMPRESSED_TEXTURE_FORMATS,
             // 1.4
             GL_BLEND_DST_RGB,
             GL_BLEND_SRC_RGB,
             GL_BLEND_DST_ALPHA,
             GL_BLEND_SRC_ALPHA,
             GL_BLEND_EQUATION,
             GL_BLEND_COLOR,
             GL_POINT_SIZE_MIN,
             GL_POINT_SIZE_MAX,
             GL_POINT_FADE_THRESHOLD_SIZE,
             GL_POINT_DISTANCE_ATTENUATION,
             GL_GENERATE_MIPMAP_HINT,
             GL_FOG_COORDINATE_SOURCE,
             GL_CURRENT_FOG_COORDINATE,
             GL_FOG_COORDINATE_ARRAY,
             GL_FOG_COORDINATE_ARRAY_TYPE,
             GL_FOG_COORDINATE_ARRAY_STRIDE,
             GL_COLOR_SUM,
             GL_CURRENT_SECONDARY_COLOR,
             GL_SECONDARY_COLOR_ARRAY,
             GL_SECONDARY_COLOR_ARRAY_SIZE,
             GL_SECONDARY_COLOR_ARRAY_TYPE,
             GL_SECONDARY_COLOR_ARRAY_STRIDE,
             GL_MAX_TEXTURE_LOD_BIAS,
             // 1.5
             GL_ARRAY_BUFFER_BINDING,
             GL_ELEMENT_ARRAY_BUFFER_BINDING,
             GL_VERTEX_ARRAY_BUFFER_BINDING,
             GL_NORMAL_ARRAY_BUFFER_BINDING,
             GL_COLOR_ARRAY_BUFFER_BINDING,
             GL_INDEX_ARRAY_BUFFER_BINDING,
             GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
             GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
             GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING,
             GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING,
         }) {
        GLfloat values[64] = {};
        glGetFloatv(name, values);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << std::hex << name;
    }
}

TEST(Queries, NameTheProfileAndItsExtensions) {
    const auto has = [](const char* extension) {
        const auto* names = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
        return std::strstr(names, extension) != nullptr;
    };
    {
        const Window window;
        EXPECT_STREQ(reinterpret_cast<const char*>(glGetString(GL_VERSION)), "1.5");
        EXPECT_TRUE(has("GL_EXT_blend_color"));
    }
    const Window window(8, 8, vgx());
    EXPECT_FALSE(has("GL_EXT_blend_color"));
    EXPECT_STREQ(reinterpret_cast<const char*>(glGetString(GL_VERSION)), "1.1");
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    EXPECT_NE(renderer.find("vgx"), std::string::npos);
}

/// Masks wrap, numbers do not. [GL15] 6.1.2
TEST(GlQueries, IntegersOfNumbersBeyondTheirRangeAreTheNearest) {
    const Window window;
    std::array<GLint, 4> read{};
    glColor4f(1.5f, 1, -2, 0);
    glGetIntegerv(GL_CURRENT_COLOR, read.data());
    EXPECT_EQ(read[0], 2147483647);
    EXPECT_EQ(read[1], 2147483647);
    glFogf(GL_FOG_END, 3e9f);
    glGetIntegerv(GL_FOG_END, read.data());
    EXPECT_EQ(read[0], 2147483647);
    glStencilMask(0xFFFFFFFF);
    glGetIntegerv(GL_STENCIL_WRITEMASK, read.data());
    EXPECT_EQ(read[0], -1);
    const GLfloat color[] = {2, -1, 0.5f, 7};
    glFogfv(GL_FOG_COLOR, color);
    std::array<GLfloat, 4> fog{};
    glGetFloatv(GL_FOG_COLOR, fog.data());
    EXPECT_EQ(fog, (std::array<GLfloat, 4>{1, 0, 0.5f, 1}));
}

}  // namespace
}  // namespace gw::gl
