// Every state variable that the functions Get.. answer, in one table. [GL11] tables 6.5 to 6.22
#include "gl/query/values.h"

#include "gl/attributes/attributes.h"
#include "gl/context/context.h"
#include "gl/state/capabilities.h"
#include "gw/base/leaked_static.h"

#include <map>

namespace gw::gl {

namespace {

using Getter = QueryValues (*)(Context&);
using Table = std::map<GLenum, Getter>;

void add_current(Table& t) {
    t[GL_CURRENT_COLOR] = [](Context& c) { return units(c.state.current.color); };
    t[GL_CURRENT_INDEX] = [](Context& c) { return number(c.state.current.index); };
    t[GL_CURRENT_NORMAL] = [](Context& c) { return units(c.state.current.normal); };
    t[GL_CURRENT_TEXTURE_COORDS] = [](Context& c) { return numbers_of(c.state.current.texcoord); };
    t[GL_CURRENT_RASTER_POSITION] = [](Context& c) {
        return numbers_of(c.state.current.raster.position);
    };
    t[GL_CURRENT_RASTER_DISTANCE] = [](Context& c) {
        return number(c.state.current.raster.distance);
    };
    t[GL_CURRENT_RASTER_COLOR] = [](Context& c) { return units(c.state.current.raster.color); };
    t[GL_CURRENT_RASTER_INDEX] = [](Context& c) { return number(c.state.current.raster.index); };
    t[GL_CURRENT_RASTER_TEXTURE_COORDS] = [](Context& c) {
        return numbers_of(c.state.current.raster.texcoord);
    };
    t[GL_CURRENT_RASTER_POSITION_VALID] = [](Context& c) {
        return whole(c.state.current.raster.valid);
    };
    t[GL_EDGE_FLAG] = [](Context& c) { return whole(c.state.current.edge_flag); };
}

template <Array array>
void add_array(Table& t, GLenum size, GLenum type, GLenum stride) {
    if (size != 0) t[size] = [](Context& c) { return whole(c.client.array(array).size); };
    if (type != 0) t[type] = [](Context& c) { return whole(c.client.array(array).type); };
    t[stride] = [](Context& c) { return whole(c.client.array(array).stride); };
}

void add_arrays(Table& t) {
    add_array<Array::Vertex>(t, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE);
    add_array<Array::Normal>(t, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE);
    add_array<Array::Color>(t, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE);
    add_array<Array::Index>(t, 0, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE);
    add_array<Array::TexCoord>(t, GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_TYPE,
                               GL_TEXTURE_COORD_ARRAY_STRIDE);
    add_array<Array::EdgeFlag>(t, 0, 0, GL_EDGE_FLAG_ARRAY_STRIDE);
}

void add_transform(Table& t) {
    t[GL_MODELVIEW_MATRIX] = [](Context& c) { return numbers_of(c.matrices.modelview.top()); };
    t[GL_PROJECTION_MATRIX] = [](Context& c) { return numbers_of(c.matrices.projection.top()); };
    t[GL_TEXTURE_MATRIX] = [](Context& c) { return numbers_of(c.matrices.texture.top()); };
    t[GL_MODELVIEW_STACK_DEPTH] = [](Context& c) {
        return whole(c.matrices.modelview.entries.size());
    };
    t[GL_PROJECTION_STACK_DEPTH] = [](Context& c) {
        return whole(c.matrices.projection.entries.size());
    };
    t[GL_TEXTURE_STACK_DEPTH] = [](Context& c) { return whole(c.matrices.texture.entries.size()); };
    t[GL_MATRIX_MODE] = [](Context& c) { return whole(c.state.transform.matrix_mode); };
    t[GL_VIEWPORT] = [](Context& c) {
        const ViewportState& v = c.state.viewport;
        return wholes({v.x, v.y, v.width, v.height});
    };
    t[GL_DEPTH_RANGE] = [](Context& c) {
        QueryValues out = unit_value(c.state.viewport.near_value);
        out.add(c.state.viewport.far_value);
        return out;
    };
}

void add_lighting(Table& t) {
    t[GL_FOG_COLOR] = [](Context& c) { return units(c.state.fog.color); };
    t[GL_FOG_INDEX] = [](Context& c) { return number(c.state.fog.index); };
    t[GL_FOG_DENSITY] = [](Context& c) { return number(c.state.fog.density); };
    t[GL_FOG_START] = [](Context& c) { return number(c.state.fog.start); };
    t[GL_FOG_END] = [](Context& c) { return number(c.state.fog.end); };
    t[GL_FOG_MODE] = [](Context& c) { return whole(c.state.fog.mode); };
    t[GL_SHADE_MODEL] = [](Context& c) { return whole(c.state.lighting.shade_model); };
    t[GL_COLOR_MATERIAL_PARAMETER] = [](Context& c) {
        return whole(c.state.lighting.color_material_mode);
    };
    t[GL_COLOR_MATERIAL_FACE] = [](Context& c) {
        return whole(c.state.lighting.color_material_face);
    };
    t[GL_LIGHT_MODEL_AMBIENT] = [](Context& c) { return units(c.state.lighting.model_ambient); };
    t[GL_LIGHT_MODEL_LOCAL_VIEWER] = [](Context& c) {
        return whole(c.state.lighting.local_viewer);
    };
    t[GL_LIGHT_MODEL_TWO_SIDE] = [](Context& c) { return whole(c.state.lighting.two_side); };
}

void add_rasterization(Table& t) {
    t[GL_POINT_SIZE] = [](Context& c) { return number(c.state.point.size); };
    t[GL_LINE_WIDTH] = [](Context& c) { return number(c.state.line.width); };
    t[GL_LINE_STIPPLE_PATTERN] = [](Context& c) { return whole(c.state.line.stipple_pattern); };
    t[GL_LINE_STIPPLE_REPEAT] = [](Context& c) { return whole(c.state.line.stipple_factor); };
    t[GL_CULL_FACE_MODE] = [](Context& c) { return whole(c.state.polygon.cull_face); };
    t[GL_FRONT_FACE] = [](Context& c) { return whole(c.state.polygon.front_face); };
    t[GL_POLYGON_MODE] = [](Context& c) {
        return wholes(c.state.polygon.front_mode, c.state.polygon.back_mode);
    };
    t[GL_POLYGON_OFFSET_FACTOR] = [](Context& c) { return number(c.state.polygon.offset_factor); };
    t[GL_POLYGON_OFFSET_UNITS] = [](Context& c) { return number(c.state.polygon.offset_units); };
}

void add_texture(Table& t) {
    t[GL_TEXTURE_BINDING_1D] = [](Context& c) { return whole(c.state.texture.bound[0]); };
    t[GL_TEXTURE_BINDING_2D] = [](Context& c) { return whole(c.state.texture.bound[1]); };
}

void add_fragments(Table& t) {
    t[GL_SCISSOR_BOX] = [](Context& c) { return wholes(c.state.scissor.box); };
    t[GL_ALPHA_TEST_FUNC] = [](Context& c) { return whole(c.state.color_buffer.alpha_func); };
    t[GL_ALPHA_TEST_REF] = [](Context& c) { return unit_value(c.state.color_buffer.alpha_ref); };
    t[GL_STENCIL_FUNC] = [](Context& c) { return whole(c.state.stencil.func); };
    t[GL_STENCIL_VALUE_MASK] = [](Context& c) { return whole(c.state.stencil.mask); };
    t[GL_STENCIL_REF] = [](Context& c) { return whole(c.state.stencil.ref); };
    t[GL_STENCIL_FAIL] = [](Context& c) { return whole(c.state.stencil.fail); };
    t[GL_STENCIL_PASS_DEPTH_FAIL] = [](Context& c) { return whole(c.state.stencil.zfail); };
    t[GL_STENCIL_PASS_DEPTH_PASS] = [](Context& c) { return whole(c.state.stencil.zpass); };
    t[GL_DEPTH_FUNC] = [](Context& c) { return whole(c.state.depth.func); };
    t[GL_BLEND_SRC] = [](Context& c) { return whole(c.state.color_buffer.blend_src); };
    t[GL_BLEND_DST] = [](Context& c) { return whole(c.state.color_buffer.blend_dst); };
    t[GL_BLEND_EQUATION] = [](Context& c) { return whole(c.state.color_buffer.blend_equation); };
    t[GL_BLEND_COLOR] = [](Context& c) { return units(c.state.color_buffer.blend_color); };
    t[GL_LOGIC_OP_MODE] = [](Context& c) { return whole(c.state.color_buffer.logic_op_mode); };
    t[GL_DRAW_BUFFER] = [](Context& c) { return whole(c.state.color_buffer.draw_buffer); };
    t[GL_READ_BUFFER] = [](Context& c) { return whole(c.state.pixel.read_buffer); };
    t[GL_INDEX_WRITEMASK] = [](Context& c) { return whole(c.state.color_buffer.index_mask); };
    t[GL_COLOR_WRITEMASK] = [](Context& c) {
        const auto& mask = c.state.color_buffer.mask;
        return wholes(Rect{mask[0], mask[1], mask[2], mask[3]});
    };
    t[GL_DEPTH_WRITEMASK] = [](Context& c) { return whole(c.state.depth.mask); };
    t[GL_STENCIL_WRITEMASK] = [](Context& c) { return whole(c.state.stencil.write_mask); };
    t[GL_COLOR_CLEAR_VALUE] = [](Context& c) { return units(c.state.color_buffer.clear); };
    t[GL_INDEX_CLEAR_VALUE] = [](Context& c) { return number(c.state.color_buffer.clear_index); };
    t[GL_DEPTH_CLEAR_VALUE] = [](Context& c) { return unit_value(c.state.depth.clear); };
    t[GL_STENCIL_CLEAR_VALUE] = [](Context& c) { return whole(c.state.stencil.clear); };
    t[GL_ACCUM_CLEAR_VALUE] = [](Context& c) { return units(c.state.accum.clear); };
}

template <class StoreOf>
void add_store(Table& t, GLenum first, StoreOf) {
    t[first] = [](Context& c) { return whole(StoreOf()(c).swap_bytes); };
    t[first + 1] = [](Context& c) { return whole(StoreOf()(c).lsb_first); };
    t[first + 2] = [](Context& c) { return whole(StoreOf()(c).row_length); };
    t[first + 3] = [](Context& c) { return whole(StoreOf()(c).skip_rows); };
    t[first + 4] = [](Context& c) { return whole(StoreOf()(c).skip_pixels); };
    t[first + 5] = [](Context& c) { return whole(StoreOf()(c).alignment); };
}

template <int map>
void add_map_size(Table& t) {
    t[GL_PIXEL_MAP_I_TO_I_SIZE + GLenum(map)] = [](Context& c) {
        return whole(c.pixel_maps.tables[std::size_t(map)].size());
    };
}

void add_pixels(Table& t) {
    add_store(t, GL_UNPACK_SWAP_BYTES, [](Context& c) { return c.client.unpack; });
    add_store(t, GL_PACK_SWAP_BYTES, [](Context& c) { return c.client.pack; });
    t[GL_MAP_COLOR] = [](Context& c) { return whole(c.state.pixel.map_color); };
    t[GL_MAP_STENCIL] = [](Context& c) { return whole(c.state.pixel.map_stencil); };
    t[GL_INDEX_SHIFT] = [](Context& c) { return whole(c.state.pixel.index_shift); };
    t[GL_INDEX_OFFSET] = [](Context& c) { return whole(c.state.pixel.index_offset); };
    t[GL_RED_SCALE] = [](Context& c) { return number(c.state.pixel.scale.x); };
    t[GL_GREEN_SCALE] = [](Context& c) { return number(c.state.pixel.scale.y); };
    t[GL_BLUE_SCALE] = [](Context& c) { return number(c.state.pixel.scale.z); };
    t[GL_ALPHA_SCALE] = [](Context& c) { return number(c.state.pixel.scale.w); };
    t[GL_RED_BIAS] = [](Context& c) { return number(c.state.pixel.bias.x); };
    t[GL_GREEN_BIAS] = [](Context& c) { return number(c.state.pixel.bias.y); };
    t[GL_BLUE_BIAS] = [](Context& c) { return number(c.state.pixel.bias.z); };
    t[GL_ALPHA_BIAS] = [](Context& c) { return number(c.state.pixel.bias.w); };
    t[GL_DEPTH_SCALE] = [](Context& c) { return number(c.state.pixel.depth_scale); };
    t[GL_DEPTH_BIAS] = [](Context& c) { return number(c.state.pixel.depth_bias); };
    t[GL_ZOOM_X] = [](Context& c) { return number(c.state.pixel.zoom_x); };
    t[GL_ZOOM_Y] = [](Context& c) { return number(c.state.pixel.zoom_y); };
    [&]<int... map>(std::integer_sequence<int, map...>) { (add_map_size<map>(t), ...); }
    (std::make_integer_sequence<int, pixel_map_count>());
}

void add_evaluators(Table& t) {
    t[GL_MAP1_GRID_DOMAIN] = [](Context& c) {
        return numbers_of(c.state.eval.grid1_u1, c.state.eval.grid1_u2);
    };
    t[GL_MAP1_GRID_SEGMENTS] = [](Context& c) { return whole(c.state.eval.grid1_segments); };
    t[GL_MAP2_GRID_DOMAIN] = [](Context& c) {
        const EvalState& s = c.state.eval;
        return numbers_of(dvec4(s.grid2_u1, s.grid2_u2, s.grid2_v1, s.grid2_v2));
    };
    t[GL_MAP2_GRID_SEGMENTS] = [](Context& c) {
        return wholes(c.state.eval.grid2_segments[0], c.state.eval.grid2_segments[1]);
    };
}

void add_hints(Table& t) {
    t[GL_PERSPECTIVE_CORRECTION_HINT] = [](Context& c) {
        return whole(c.state.hint.perspective_correction);
    };
    t[GL_POINT_SMOOTH_HINT] = [](Context& c) { return whole(c.state.hint.point_smooth); };
    t[GL_LINE_SMOOTH_HINT] = [](Context& c) { return whole(c.state.hint.line_smooth); };
    t[GL_POLYGON_SMOOTH_HINT] = [](Context& c) { return whole(c.state.hint.polygon_smooth); };
    t[GL_FOG_HINT] = [](Context& c) { return whole(c.state.hint.fog); };
}

/// The step of sizes and widths with antialiasing.
double size_step(const Profile& profile) { return profile.coverage_bits > 0 ? 0x1p-11 : 1; }

void add_limits(Table& t) {
    t[GL_MAX_ELEMENTS_INDICES] = [](Context&) { return whole(1 << 16); };
    t[GL_MAX_ELEMENTS_VERTICES] = [](Context&) { return whole(1 << 16); };
    t[GL_MAX_LIGHTS] = [](Context&) { return whole(light_count); };
    t[GL_MAX_CLIP_PLANES] = [](Context&) { return whole(max_clip_planes); };
    t[GL_MAX_MODELVIEW_STACK_DEPTH] = [](Context&) { return whole(modelview_stack_depth); };
    t[GL_MAX_PROJECTION_STACK_DEPTH] = [](Context&) { return whole(projection_stack_depth); };
    t[GL_MAX_TEXTURE_STACK_DEPTH] = [](Context&) { return whole(texture_stack_depth); };
    t[GL_MAX_TEXTURE_SIZE] = [](Context&) { return whole(max_texture_size); };
    t[GL_MAX_PIXEL_MAP_TABLE] = [](Context&) { return whole(max_pixel_map); };
    t[GL_MAX_NAME_STACK_DEPTH] = [](Context&) { return whole(name_stack_depth); };
    t[GL_MAX_LIST_NESTING] = [](Context&) { return whole(max_list_nesting); };
    t[GL_MAX_EVAL_ORDER] = [](Context&) { return whole(max_eval_order); };
    t[GL_MAX_VIEWPORT_DIMS] = [](Context&) { return wholes(max_window_size, max_window_size); };
    t[GL_MAX_ATTRIB_STACK_DEPTH] = [](Context&) { return whole(attribute_stack_depth); };
    t[GL_MAX_CLIENT_ATTRIB_STACK_DEPTH] = [](Context&) { return whole(client_stack_depth); };
    t[GL_SUBPIXEL_BITS] = [](Context& c) { return whole(c.profile.subpixel_bits); };
    t[GL_POINT_SIZE_RANGE] = [](Context&) { return numbers_of(1, 128); };
    t[GL_POINT_SIZE_GRANULARITY] = [](Context& c) { return number(size_step(c.profile)); };
    t[GL_LINE_WIDTH_RANGE] = [](Context&) { return numbers_of(1, 128); };
    t[GL_LINE_WIDTH_GRANULARITY] = [](Context& c) { return number(size_step(c.profile)); };
    t[GL_AUX_BUFFERS] = [](Context&) { return whole(0); };
    t[GL_RGBA_MODE] = [](Context&) { return whole(GL_TRUE); };
    t[GL_INDEX_MODE] = [](Context&) { return whole(GL_FALSE); };
    t[GL_STEREO] = [](Context&) { return whole(GL_FALSE); };
    t[GL_DOUBLEBUFFER] = [](Context& c) {
        return whole(c.drawable != nullptr && c.drawable->is_double_buffered());
    };
    for (const GLenum name : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS})
        t[name] = [](Context& c) { return whole(c.profile.color_bits); };
    t[GL_INDEX_BITS] = [](Context&) { return whole(0); };
    t[GL_DEPTH_BITS] = [](Context& c) { return whole(c.profile.depth_bits); };
    t[GL_STENCIL_BITS] = [](Context& c) { return whole(c.profile.stencil_bits); };
    for (const GLenum name :
         {GL_ACCUM_RED_BITS, GL_ACCUM_GREEN_BITS, GL_ACCUM_BLUE_BITS, GL_ACCUM_ALPHA_BITS})
        t[name] = [](Context& c) { return whole(c.profile.accum_bits); };
}

void add_stacks(Table& t) {
    t[GL_LIST_BASE] = [](Context& c) { return whole(c.state.list.base); };
    t[GL_LIST_INDEX] = [](Context& c) { return whole(c.lists.open ? c.lists.name : 0u); };
    t[GL_LIST_MODE] = [](Context& c) { return whole(c.lists.open ? c.lists.mode : 0u); };
    t[GL_ATTRIB_STACK_DEPTH] = [](Context& c) { return whole(c.attribute_stack.size()); };
    t[GL_CLIENT_ATTRIB_STACK_DEPTH] = [](Context& c) { return whole(c.client_stack.size()); };
    t[GL_NAME_STACK_DEPTH] = [](Context& c) { return whole(c.selection.names.size()); };
    t[GL_RENDER_MODE] = [](Context& c) { return whole(c.selection.mode); };
    t[GL_FEEDBACK_BUFFER_SIZE] = [](Context& c) { return whole(c.selection.feedback_size); };
    t[GL_FEEDBACK_BUFFER_TYPE] = [](Context& c) { return whole(c.selection.feedback_type); };
    t[GL_SELECTION_BUFFER_SIZE] = [](Context& c) { return whole(c.selection.hits_size); };
}

Table make_variables() {
    Table t;
    add_current(t);
    add_arrays(t);
    add_transform(t);
    add_lighting(t);
    add_rasterization(t);
    add_texture(t);
    add_fragments(t);
    add_pixels(t);
    add_evaluators(t);
    add_hints(t);
    add_limits(t);
    add_stacks(t);
    return t;
}

}  // namespace

std::optional<QueryValues> state_variable(Context& c, GLenum pname) {
    static const Table& table = leaked_static(make_variables());
    if (const auto found = table.find(pname); found != table.end()) return found->second(c);
    if (const Capability* capability = find_capability(pname))
        return whole(is_enabled(c.state, *capability));
    if (const ClientArray* array = find_array(c.client, pname)) return whole(array->enable);
    return std::nullopt;
}

}  // namespace gw::gl
