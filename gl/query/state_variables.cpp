// Every state variable that the functions Get.. answer, in one table. [GL11] tables 6.5 to 6.22
#include "gl/query/state_variables.h"
#include "gl/query/values.h"

#include "gl/attributes/attributes.h"
#include "gl/context/context.h"
#include "gl/state/capabilities.h"
#include "gw/base/leaked_static.h"

#include <map>

namespace gw::gl {

namespace {

using Table = StateVariables;

void add_current(Table& t) {
    t[GL_CURRENT_COLOR] = [](Context& context) { return units(context.state.current.color); };
    t[GL_CURRENT_SECONDARY_COLOR] = [](Context& context) {
        return units(vec4(context.state.current.secondary_color, 1));
    };
    t[GL_CURRENT_FOG_COORDINATE] = [](Context& context) {
        return number(context.state.current.fog_coordinate);
    };
    t[GL_CURRENT_INDEX] = [](Context& context) { return number(context.state.current.index); };
    t[GL_CURRENT_NORMAL] = [](Context& context) { return units(context.state.current.normal); };
    t[GL_CURRENT_RASTER_POSITION] = [](Context& context) {
        return numbers_of(context.state.current.raster.position);
    };
    t[GL_CURRENT_RASTER_DISTANCE] = [](Context& context) {
        return number(context.state.current.raster.distance);
    };
    t[GL_CURRENT_RASTER_COLOR] = [](Context& context) {
        return units(context.state.current.raster.color);
    };
    t[GL_CURRENT_RASTER_INDEX] = [](Context& context) {
        return number(context.state.current.raster.index);
    };
    t[GL_CURRENT_RASTER_POSITION_VALID] = [](Context& context) {
        return whole(context.state.current.raster.valid);
    };
    t[GL_EDGE_FLAG] = [](Context& context) { return whole(context.state.current.edge_flag); };
}

void add_transform(Table& t) {
    t[GL_MODELVIEW_MATRIX] = [](Context& context) {
        return numbers_of(context.matrices.modelview.top());
    };
    t[GL_PROJECTION_MATRIX] = [](Context& context) {
        return numbers_of(context.matrices.projection.top());
    };
    t[GL_TRANSPOSE_MODELVIEW_MATRIX] = [](Context& context) {
        return numbers_of(glm::transpose(context.matrices.modelview.top()));
    };
    t[GL_TRANSPOSE_PROJECTION_MATRIX] = [](Context& context) {
        return numbers_of(glm::transpose(context.matrices.projection.top()));
    };
    t[GL_MODELVIEW_STACK_DEPTH] = [](Context& context) {
        return whole(context.matrices.modelview.entries.size());
    };
    t[GL_PROJECTION_STACK_DEPTH] = [](Context& context) {
        return whole(context.matrices.projection.entries.size());
    };
    t[GL_MATRIX_MODE] = [](Context& context) { return whole(context.state.transform.matrix_mode); };
    t[GL_CLIP_ORIGIN] = [](Context& context) { return whole(context.state.transform.clip_origin); };
    t[GL_CLIP_DEPTH_MODE] = [](Context& context) {
        return whole(context.state.transform.clip_depth_mode);
    };
    t[GL_VIEWPORT] = [](Context& context) {
        const ViewportState& v = context.state.viewport;
        return wholes({v.x, v.y, v.width, v.height});
    };
    t[GL_DEPTH_RANGE] = [](Context& context) {
        QueryValues out = unit_value(context.state.viewport.near_value);
        out.add(context.state.viewport.far_value);
        return out;
    };
}

void add_lighting(Table& t) {
    t[GL_FOG_COLOR] = [](Context& context) { return units(context.state.fog.color); };
    t[GL_FOG_INDEX] = [](Context& context) { return number(context.state.fog.index); };
    t[GL_FOG_DENSITY] = [](Context& context) { return number(context.state.fog.density); };
    t[GL_FOG_START] = [](Context& context) { return number(context.state.fog.start); };
    t[GL_FOG_END] = [](Context& context) { return number(context.state.fog.end); };
    t[GL_FOG_MODE] = [](Context& context) { return whole(context.state.fog.mode); };
    t[GL_FOG_COORDINATE_SOURCE] = [](Context& context) {
        return whole(context.state.fog.coordinate_source);
    };
    t[GL_SHADE_MODEL] = [](Context& context) { return whole(context.state.lighting.shade_model); };
    t[GL_COLOR_MATERIAL_PARAMETER] = [](Context& context) {
        return whole(context.state.lighting.color_material_mode);
    };
    t[GL_COLOR_MATERIAL_FACE] = [](Context& context) {
        return whole(context.state.lighting.color_material_face);
    };
    t[GL_LIGHT_MODEL_AMBIENT] = [](Context& context) {
        return units(context.state.lighting.model_ambient);
    };
    t[GL_LIGHT_MODEL_LOCAL_VIEWER] = [](Context& context) {
        return whole(context.state.lighting.local_viewer);
    };
    t[GL_LIGHT_MODEL_COLOR_CONTROL] = [](Context& context) {
        return whole(context.state.lighting.color_control);
    };
    t[GL_LIGHT_MODEL_TWO_SIDE] = [](Context& context) {
        return whole(context.state.lighting.two_side);
    };
}

void add_rasterization(Table& t) {
    t[GL_POINT_SIZE] = [](Context& context) { return number(context.state.point.size); };
    t[GL_POINT_SIZE_MIN] = [](Context& context) { return number(context.state.point.min_size); };
    t[GL_POINT_SIZE_MAX] = [](Context& context) { return number(context.state.point.max_size); };
    t[GL_POINT_FADE_THRESHOLD_SIZE] = [](Context& context) {
        return number(context.state.point.fade_threshold);
    };
    t[GL_POINT_DISTANCE_ATTENUATION] = [](Context& context) {
        return numbers_of(context.state.point.attenuation);
    };
    t[GL_LINE_WIDTH] = [](Context& context) { return number(context.state.line.width); };
    t[GL_LINE_STIPPLE_PATTERN] = [](Context& context) {
        return whole(context.state.line.stipple_pattern);
    };
    t[GL_LINE_STIPPLE_REPEAT] = [](Context& context) {
        return whole(context.state.line.stipple_factor);
    };
    t[GL_CULL_FACE_MODE] = [](Context& context) { return whole(context.state.polygon.cull_face); };
    t[GL_FRONT_FACE] = [](Context& context) { return whole(context.state.polygon.front_face); };
    t[GL_POLYGON_MODE] = [](Context& context) {
        return wholes(context.state.polygon.front_mode, context.state.polygon.back_mode);
    };
    t[GL_POLYGON_OFFSET_FACTOR] = [](Context& context) {
        return number(context.state.polygon.offset_factor);
    };
    t[GL_POLYGON_OFFSET_UNITS] = [](Context& context) {
        return number(context.state.polygon.offset_units);
    };
}

void add_fragments(Table& t) {
    t[GL_SCISSOR_BOX] = [](Context& context) { return wholes(context.state.scissor.box); };
    t[GL_ALPHA_TEST_FUNC] = [](Context& context) {
        return whole(context.state.color_buffer.alpha_func);
    };
    t[GL_ALPHA_TEST_REF] = [](Context& context) {
        return unit_value(context.state.color_buffer.alpha_ref);
    };
    t[GL_STENCIL_FUNC] = [](Context& context) { return whole(context.state.stencil.func); };
    t[GL_STENCIL_VALUE_MASK] = [](Context& context) { return whole(context.state.stencil.mask); };
    t[GL_STENCIL_REF] = [](Context& context) { return whole(context.state.stencil.ref); };
    t[GL_STENCIL_FAIL] = [](Context& context) { return whole(context.state.stencil.fail); };
    t[GL_STENCIL_PASS_DEPTH_FAIL] = [](Context& context) {
        return whole(context.state.stencil.zfail);
    };
    t[GL_STENCIL_PASS_DEPTH_PASS] = [](Context& context) {
        return whole(context.state.stencil.zpass);
    };
    t[GL_DEPTH_FUNC] = [](Context& context) { return whole(context.state.depth.func); };
    t[GL_BLEND_SRC] = [](Context& context) { return whole(context.state.color_buffer.blend_src); };
    t[GL_BLEND_DST] = [](Context& context) { return whole(context.state.color_buffer.blend_dst); };
    t[GL_BLEND_EQUATION] = [](Context& context) {
        return whole(context.state.color_buffer.blend_equation);
    };
    t[GL_BLEND_SRC_RGB] = t[GL_BLEND_SRC];
    t[GL_BLEND_DST_RGB] = t[GL_BLEND_DST];
    t[GL_BLEND_SRC_ALPHA] = [](Context& context) {
        return whole(context.state.color_buffer.blend_src_alpha);
    };
    t[GL_BLEND_DST_ALPHA] = [](Context& context) {
        return whole(context.state.color_buffer.blend_dst_alpha);
    };
    t[GL_BLEND_EQUATION_ALPHA] = [](Context& context) {
        return whole(context.state.color_buffer.blend_equation_alpha);
    };
    t[GL_BLEND_COLOR] = [](Context& context) {
        return units(context.state.color_buffer.blend_color);
    };
    t[GL_LOGIC_OP_MODE] = [](Context& context) {
        return whole(context.state.color_buffer.logic_op_mode);
    };
    t[GL_DRAW_BUFFER] = [](Context& context) {
        return whole(context.state.color_buffer.draw_buffer);
    };
    t[GL_READ_BUFFER] = [](Context& context) { return whole(context.state.pixel.read_buffer); };
    t[GL_INDEX_WRITEMASK] = [](Context& context) {
        return whole(context.state.color_buffer.index_mask);
    };
    t[GL_COLOR_WRITEMASK] = [](Context& context) {
        const auto& mask = context.state.color_buffer.mask;
        return wholes(Rect{mask[0], mask[1], mask[2], mask[3]});
    };
    t[GL_DEPTH_WRITEMASK] = [](Context& context) { return whole(context.state.depth.mask); };
    t[GL_STENCIL_WRITEMASK] = [](Context& context) {
        return whole(context.state.stencil.write_mask);
    };
    t[GL_COLOR_CLEAR_VALUE] = [](Context& context) {
        return units(context.state.color_buffer.clear);
    };
    t[GL_INDEX_CLEAR_VALUE] = [](Context& context) {
        return number(context.state.color_buffer.clear_index);
    };
    t[GL_DEPTH_CLEAR_VALUE] = [](Context& context) {
        return unit_value(context.state.depth.clear);
    };
    t[GL_STENCIL_CLEAR_VALUE] = [](Context& context) { return whole(context.state.stencil.clear); };
    t[GL_ACCUM_CLEAR_VALUE] = [](Context& context) { return units(context.state.accum.clear); };
    t[GL_SAMPLE_COVERAGE_VALUE] = [](Context& context) {
        return number(context.state.multisample.coverage_value);
    };
    t[GL_SAMPLE_COVERAGE_INVERT] = [](Context& context) {
        return whole(context.state.multisample.coverage_invert);
    };
}

template <class StoreOf>
void add_store(Table& t, GLenum first, StoreOf) {
    t[first] = [](Context& context) { return whole(StoreOf()(context).swap_bytes); };
    t[first + 1] = [](Context& context) { return whole(StoreOf()(context).lsb_first); };
    t[first + 2] = [](Context& context) { return whole(StoreOf()(context).row_length); };
    t[first + 3] = [](Context& context) { return whole(StoreOf()(context).skip_rows); };
    t[first + 4] = [](Context& context) { return whole(StoreOf()(context).skip_pixels); };
    t[first + 5] = [](Context& context) { return whole(StoreOf()(context).alignment); };
    const GLenum images = first == GL_PACK_SWAP_BYTES ? GL_PACK_SKIP_IMAGES : GL_UNPACK_SKIP_IMAGES;
    t[images] = [](Context& context) { return whole(StoreOf()(context).skip_images); };
    t[images + 1] = [](Context& context) { return whole(StoreOf()(context).image_height); };
}

template <int map>
void add_map_size(Table& t) {
    t[GL_PIXEL_MAP_I_TO_I_SIZE + GLenum(map)] = [](Context& context) {
        return whole(context.pixel_maps.tables[std::size_t(map)].size());
    };
}

void add_pixels(Table& t) {
    add_store(t, GL_UNPACK_SWAP_BYTES, [](Context& context) { return context.client.unpack; });
    add_store(t, GL_PACK_SWAP_BYTES, [](Context& context) { return context.client.pack; });
    t[GL_PIXEL_PACK_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.client.pack.buffer));
    };
    t[GL_PIXEL_UNPACK_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.client.unpack.buffer));
    };
    t[GL_COPY_READ_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.copy_read_buffer));
    };
    t[GL_COPY_WRITE_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.copy_write_buffer));
    };
    t[GL_MAP_COLOR] = [](Context& context) { return whole(context.state.pixel.map_color); };
    t[GL_MAP_STENCIL] = [](Context& context) { return whole(context.state.pixel.map_stencil); };
    t[GL_INDEX_SHIFT] = [](Context& context) { return whole(context.state.pixel.index_shift); };
    t[GL_INDEX_OFFSET] = [](Context& context) { return whole(context.state.pixel.index_offset); };
    t[GL_RED_SCALE] = [](Context& context) { return number(context.state.pixel.scale.x); };
    t[GL_GREEN_SCALE] = [](Context& context) { return number(context.state.pixel.scale.y); };
    t[GL_BLUE_SCALE] = [](Context& context) { return number(context.state.pixel.scale.z); };
    t[GL_ALPHA_SCALE] = [](Context& context) { return number(context.state.pixel.scale.w); };
    t[GL_RED_BIAS] = [](Context& context) { return number(context.state.pixel.bias.x); };
    t[GL_GREEN_BIAS] = [](Context& context) { return number(context.state.pixel.bias.y); };
    t[GL_BLUE_BIAS] = [](Context& context) { return number(context.state.pixel.bias.z); };
    t[GL_ALPHA_BIAS] = [](Context& context) { return number(context.state.pixel.bias.w); };
    t[GL_DEPTH_SCALE] = [](Context& context) { return number(context.state.pixel.depth_scale); };
    t[GL_DEPTH_BIAS] = [](Context& context) { return number(context.state.pixel.depth_bias); };
    t[GL_ZOOM_X] = [](Context& context) { return number(context.state.pixel.zoom_x); };
    t[GL_ZOOM_Y] = [](Context& context) { return number(context.state.pixel.zoom_y); };
    [&]<int... map>(std::integer_sequence<int, map...>) { (add_map_size<map>(t), ...); }
    (std::make_integer_sequence<int, pixel_map_count>());
}

void add_evaluators(Table& t) {
    t[GL_MAP1_GRID_DOMAIN] = [](Context& context) {
        return numbers_of(context.state.eval.grid1_u1, context.state.eval.grid1_u2);
    };
    t[GL_MAP1_GRID_SEGMENTS] = [](Context& context) {
        return whole(context.state.eval.grid1_segments);
    };
    t[GL_MAP2_GRID_DOMAIN] = [](Context& context) {
        const EvalState& s = context.state.eval;
        return numbers_of(dvec4(s.grid2_u1, s.grid2_u2, s.grid2_v1, s.grid2_v2));
    };
    t[GL_MAP2_GRID_SEGMENTS] = [](Context& context) {
        return wholes(context.state.eval.grid2_segments[0], context.state.eval.grid2_segments[1]);
    };
}

void add_hints(Table& t) {
    t[GL_PERSPECTIVE_CORRECTION_HINT] = [](Context& context) {
        return whole(context.state.hint.perspective_correction);
    };
    t[GL_POINT_SMOOTH_HINT] = [](Context& context) {
        return whole(context.state.hint.point_smooth);
    };
    t[GL_LINE_SMOOTH_HINT] = [](Context& context) { return whole(context.state.hint.line_smooth); };
    t[GL_POLYGON_SMOOTH_HINT] = [](Context& context) {
        return whole(context.state.hint.polygon_smooth);
    };
    t[GL_GENERATE_MIPMAP_HINT] = [](Context& context) {
        return whole(context.state.hint.generate_mipmap);
    };
    t[GL_TEXTURE_COMPRESSION_HINT] = [](Context& context) {
        return whole(context.state.hint.texture_compression);
    };
    t[GL_FOG_HINT] = [](Context& context) { return whole(context.state.hint.fog); };
}

void add_stacks(Table& t) {
    t[GL_LIST_BASE] = [](Context& context) { return whole(context.state.list.base); };
    t[GL_LIST_INDEX] = [](Context& context) {
        return whole(context.lists.open ? context.lists.name : 0u);
    };
    t[GL_LIST_MODE] = [](Context& context) {
        return whole(context.lists.open ? context.lists.mode : 0u);
    };
    t[GL_ATTRIB_STACK_DEPTH] = [](Context& context) {
        return whole(context.attribute_stack.size());
    };
    t[GL_CLIENT_ATTRIB_STACK_DEPTH] = [](Context& context) {
        return whole(context.client_stack.size());
    };
    t[GL_NAME_STACK_DEPTH] = [](Context& context) { return whole(context.selection.names.size()); };
    t[GL_RENDER_MODE] = [](Context& context) { return whole(context.selection.mode); };
    t[GL_FEEDBACK_BUFFER_SIZE] = [](Context& context) {
        return whole(context.selection.feedback_size);
    };
    t[GL_FEEDBACK_BUFFER_TYPE] = [](Context& context) {
        return whole(context.selection.feedback_type);
    };
    t[GL_SELECTION_BUFFER_SIZE] = [](Context& context) {
        return whole(context.selection.hits_size);
    };
}

Table make_variables() {
    Table t;
    add_current(t);
    add_arrays(t);
    add_transform(t);
    add_lighting(t);
    add_rasterization(t);
    add_texture_units(t);
    add_fragments(t);
    add_pixels(t);
    add_evaluators(t);
    add_hints(t);
    add_limits(t);
    add_stacks(t);
    return t;
}

}  // namespace

std::optional<QueryValues> state_variable(Context& context, GLenum pname) {
    static const Table& table = leaked_static(make_variables());
    if (const auto found = table.find(pname); found != table.end()) return found->second(context);
    if (const Capability* capability = find_capability(context.profile, pname))
        return whole(is_enabled(context.state, *capability));
    if (const ClientArray* array = find_array(context.client, pname)) return whole(array->enable);
    return std::nullopt;
}

}  // namespace gw::gl
