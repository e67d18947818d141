// The calls behind the entry points, by chapter of the specification: entry/functions.txt names for
// each function the call that carries it out. Each checks its arguments as [GL11] prescribes, sets
// the error or changes the context. Calls that a display list keeps take values: convert.h read the
// pointers before.
#pragma once

#include "gl/api/values.h"

#include <GL/gl.h>

#include <string_view>
#include <vector>

namespace gw::gl {

struct Context;
class DisplayList;
using Elements = std::shared_ptr<const DisplayList>;

namespace execute {

// 2.6 Begin and End
void begin(Context& context, GLenum mode);
void end(Context& context);
void edge_flag(Context& context, GLboolean flag);

// 2.7 Vertices
void vertex(Context& context, float x, float y, float z, float w);
void tex_coord(Context& context, float s, float t, float r, float q);
void multi_tex_coord(Context& context, GLenum texture, float s, float t, float r, float q);
void normal(Context& context, float x, float y, float z);
void color(Context& context, float red, float green, float blue, float alpha);
void secondary_color(Context& context, float red, float green, float blue);
void fog_coord(Context& context, float coordinate);
void index(Context& context, float value);

// 2.8 Vertex arrays
void vertex_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                    const GLvoid* pointer);
void normal_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer);
void color_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                   const GLvoid* pointer);
void secondary_color_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                             const GLvoid* pointer);
void fog_coord_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer);
void index_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer);
void tex_coord_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                       const GLvoid* pointer);
void edge_flag_pointer(Context& context, GLsizei stride, const GLvoid* pointer);
void client_active_texture(Context& context, GLenum texture);
void enable_client_state(Context& context, GLenum array);
void disable_client_state(Context& context, GLenum array);
void interleaved_arrays(Context& context, GLenum format, GLsizei stride, const GLvoid* pointer);
void lock_arrays(Context& context, GLint first, GLsizei count);
void unlock_arrays(Context& context);
void array_element(Context& context, GLint i);
/// Replays captured array elements: what a display list keeps of DrawArrays and DrawElements.
void play_elements(Context& context, const Elements& elements);
void draw_arrays(Context& context, GLenum mode, GLint first, GLsizei count);
void draw_elements(Context& context, GLenum mode, GLsizei count, GLenum type,
                   const GLvoid* indices);
void draw_range_elements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count,
                         GLenum type, const GLvoid* indices);

void multi_draw_arrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count,
                       GLsizei primcount);
void multi_draw_elements(Context& context, GLenum mode, const GLsizei* count, GLenum type,
                         const GLvoid* const* indices, GLsizei primcount);

// [GL15] 2.9 Buffer objects
void gen_buffers(Context& context, GLsizei n, GLuint* buffers);
void delete_buffers(Context& context, GLsizei n, const GLuint* buffers);
GLboolean is_buffer(Context& context, GLuint buffer);
void bind_buffer(Context& context, GLenum target, GLuint buffer);
void buffer_data(Context& context, GLenum target, GLsizeiptr size, const GLvoid* data,
                 GLenum usage);
void buffer_sub_data(Context& context, GLenum target, GLintptr offset, GLsizeiptr size,
                     const GLvoid* data);
void get_buffer_sub_data(Context& context, GLenum target, GLintptr offset, GLsizeiptr size,
                         GLvoid* data);
void copy_buffer_sub_data(Context& context, GLenum read_target, GLenum write_target,
                          GLintptr read_offset, GLintptr write_offset, GLsizeiptr size);
GLvoid* map_buffer(Context& context, GLenum target, GLenum access);
GLvoid* map_buffer_range(Context& context, GLenum target, GLintptr offset, GLsizeiptr length,
                         GLbitfield access);
void flush_mapped_buffer_range(Context& context, GLenum target, GLintptr offset, GLsizeiptr length);
GLboolean unmap_buffer(Context& context, GLenum target);
void get_buffer_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params);
void get_buffer_pointerv(Context& context, GLenum target, GLenum pname, GLvoid** params);

// 2.9 Rectangles
void rect(Context& context, double x1, double y1, double x2, double y2);

// 2.10 Coordinate transformations
void depth_range(Context& context, GLclampd near_value, GLclampd far_value);
void viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);
void matrix_mode(Context& context, GLenum mode);
void load_matrix(Context& context, const dmat4& m);
void mult_matrix(Context& context, const dmat4& m);
void load_identity(Context& context);
void rotate(Context& context, double angle, double x, double y, double z);
void translate(Context& context, double x, double y, double z);
void scale(Context& context, double x, double y, double z);
void frustum(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
             GLdouble near_value, GLdouble far_value);
void ortho(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
           GLdouble near_value, GLdouble far_value);
void push_matrix(Context& context);
void pop_matrix(Context& context);
void tex_gen(Context& context, GLenum coord, GLenum pname, const Params& params);
void clip_plane(Context& context, GLenum plane, const Params& equation);
void clip_control(Context& context, GLenum origin, GLenum depth);

// 2.12 Current raster position
void raster_pos(Context& context, double x, double y, double z, double w);
void window_pos(Context& context, double x, double y, double z, double w);

// 2.13 Colours and lighting
void front_face(Context& context, GLenum mode);
void shade_model(Context& context, GLenum mode);
void light(Context& context, GLenum light, GLenum pname, const Params& params);
void light_model(Context& context, GLenum pname, const Params& params);
void color_material(Context& context, GLenum face, GLenum mode);
void material(Context& context, GLenum face, GLenum pname, const Params& params);

// 3.3 to 3.5 Points, lines and polygons
void point_size(Context& context, GLfloat size);
void point_parameter(Context& context, GLenum pname, const Params& params);
void line_width(Context& context, GLfloat width);
void line_stipple(Context& context, GLint factor, GLushort pattern);
void cull_face(Context& context, GLenum mode);
void polygon_stipple(Context& context, const Stipple& pattern);
void polygon_mode(Context& context, GLenum face, GLenum mode);
void polygon_offset(Context& context, GLfloat factor, GLfloat units);
/// GL_EXT_polygon_offset: the bias is a depth 0 .. 1.
void polygon_offset_ext(Context& context, GLfloat factor, GLfloat bias);

// 3.6 and 4.3 Pixel rectangles
void pixel_store(Context& context, GLenum pname, double param);
void pixel_transfer(Context& context, GLenum pname, double param);
void pixel_map(Context& context, GLenum map, GLsizei size, const Numbers& values);
void pixel_zoom(Context& context, GLfloat xfactor, GLfloat yfactor);
void draw_pixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const HostImage& image);
void bitmap(Context& context, GLsizei width, GLsizei height, float xorig, float yorig, float xmove,
            float ymove, const HostImage& image);
void copy_pixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);
void read_pixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, GLvoid* pixels);
void read_buffer(Context& context, GLenum mode);

// 3.8 Texturing
void tex_image_1d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLint border, GLenum format, GLenum type, const HostImage& image);
void tex_image_2d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
                  const HostImage& image);
void tex_image_3d(Context& context, GLenum target, GLint level, GLint internal_format,
                  GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format,
                  GLenum type, const HostImage& image);
void tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width,
                      GLenum format, GLenum type, const HostImage& image);
void tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLsizei width, GLsizei height, GLenum format, GLenum type,
                      const HostImage& image);
void tex_sub_image_3d(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format,
                      GLenum type, const HostImage& image);
void copy_tex_image_1d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLint border);
void copy_tex_image_2d(Context& context, GLenum target, GLint level, GLenum internal_format,
                       GLint x, GLint y, GLsizei width, GLsizei height, GLint border);
void copy_tex_sub_image_1d(Context& context, GLenum target, GLint level, GLint xoffset, GLint x,
                           GLint y, GLsizei width);
void copy_tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height);
void copy_tex_sub_image_3d(Context& context, GLenum target, GLint level, GLint xoffset,
                           GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width,
                           GLsizei height);
void compressed_tex_image_2d(Context& context, GLenum target, GLint level, GLenum internal_format,
                             GLsizei width, GLsizei height, GLint border, GLsizei image_size,
                             const HostImage& blocks);
void compressed_tex_sub_image_2d(Context& context, GLenum target, GLint level, GLint xoffset,
                                 GLint yoffset, GLsizei width, GLsizei height, GLenum format,
                                 GLsizei image_size, const HostImage& blocks);
/// No compressed format has one or three dimensions.
void compressed_tex_image_1d(Context& context, GLenum target);
void compressed_tex_image_3d(Context& context, GLenum target);
void active_texture(Context& context, GLenum texture);
void tex_parameter(Context& context, GLenum target, GLenum pname, const Params& params);
void tex_env(Context& context, GLenum target, GLenum pname, const Params& params);
void bind_texture(Context& context, GLenum target, GLuint texture);
void gen_textures(Context& context, GLsizei n, GLuint* textures);
void delete_textures(Context& context, GLsizei n, const GLuint* textures);
GLboolean is_texture(Context& context, GLuint texture);
GLboolean are_textures_resident(Context& context, GLsizei n, const GLuint* textures,
                                GLboolean* residences);
void prioritize_textures(Context& context, GLsizei n, const Numbers& textures,
                         const Numbers& priorities);

// 3.9 Fog
void fog(Context& context, GLenum pname, const Params& params);

// 4.1 Per-fragment operations
void scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);
void alpha_func(Context& context, GLenum func, GLclampf ref);
void stencil_func(Context& context, GLenum func, GLint ref, GLuint mask);
void stencil_op(Context& context, GLenum fail, GLenum zfail, GLenum zpass);
void depth_func(Context& context, GLenum func);
void sample_coverage(Context& context, GLclampf value, GLboolean invert);
void blend_func(Context& context, GLenum sfactor, GLenum dfactor);
void blend_func_separate(Context& context, GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha,
                         GLenum dst_alpha);
void logic_op(Context& context, GLenum opcode);
void blend_color(Context& context, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
void blend_equation(Context& context, GLenum mode);
void blend_equation_separate(Context& context, GLenum mode_rgb, GLenum mode_alpha);

// [GL15] 4.1.7 Occlusion queries
void gen_queries(Context& context, GLsizei n, GLuint* ids);
void delete_queries(Context& context, GLsizei n, const GLuint* ids);
GLboolean is_query(Context& context, GLuint id);
void begin_query(Context& context, GLenum target, GLuint id);
void end_query(Context& context, GLenum target);
void get_queryiv(Context& context, GLenum target, GLenum pname, GLint* params);
void get_query_objectiv(Context& context, GLuint id, GLenum pname, GLint* params);
void get_query_objectuiv(Context& context, GLuint id, GLenum pname, GLuint* params);

// Framebuffer objects: GL_ARB_framebuffer_object
void gen_framebuffers(Context& context, GLsizei n, GLuint* framebuffers);
void gen_renderbuffers(Context& context, GLsizei n, GLuint* renderbuffers);
void delete_framebuffers(Context& context, GLsizei n, const GLuint* framebuffers);
void delete_renderbuffers(Context& context, GLsizei n, const GLuint* renderbuffers);
GLboolean is_framebuffer(Context& context, GLuint framebuffer);
GLboolean is_renderbuffer(Context& context, GLuint renderbuffer);
void bind_framebuffer(Context& context, GLenum target, GLuint framebuffer);
void bind_renderbuffer(Context& context, GLenum target, GLuint renderbuffer);
/// The names may be any: GL_EXT_framebuffer_object
void bind_new_framebuffer(Context& context, GLenum target, GLuint framebuffer);
void bind_new_renderbuffer(Context& context, GLenum target, GLuint renderbuffer);
void renderbuffer_storage(Context& context, GLenum target, GLsizei samples, GLenum internal_format,
                          GLsizei width, GLsizei height);
void get_renderbuffer_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params);
GLenum check_framebuffer_status(Context& context, GLenum target);
void framebuffer_texture_1d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level);
void framebuffer_texture_2d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level);
void framebuffer_texture_3d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level, GLint layer);
void framebuffer_renderbuffer(Context& context, GLenum target, GLenum attachment,
                              GLenum renderbuffertarget, GLuint renderbuffer);
void get_framebuffer_attachment_parameteriv(Context& context, GLenum target, GLenum attachment,
                                            GLenum pname, GLint* params);
void blit_framebuffer(Context& context, GLint src_x0, GLint src_y0, GLint src_x1, GLint src_y1,
                      GLint dst_x0, GLint dst_y0, GLint dst_x1, GLint dst_y1, GLbitfield mask,
                      GLenum filter);
void generate_mipmap(Context& context, GLenum target);

// 4.2 Whole framebuffer operations
void draw_buffer(Context& context, GLenum mode);
void index_mask(Context& context, GLuint mask);
void color_mask(Context& context, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
void depth_mask(Context& context, GLboolean flag);
void stencil_mask(Context& context, GLuint mask);
void clear(Context& context, GLbitfield mask);
void clear_color(Context& context, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
void clear_index(Context& context, GLfloat value);
void clear_depth(Context& context, GLclampd depth);
void clear_stencil(Context& context, GLint s);
void clear_accum(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
void accum(Context& context, GLenum op, GLfloat value);

// 5.1 Evaluators
void map1(Context& context, GLenum target, double u1, double u2, GLint stride, GLint order,
          const Numbers& points);
void map2(Context& context, GLenum target, double u1, double u2, GLint ustride, GLint uorder,
          double v1, double v2, GLint vstride, GLint vorder, const Numbers& points);
void eval_coord1(Context& context, double u);
void eval_coord2(Context& context, double u, double v);
void map_grid1(Context& context, GLint un, double u1, double u2);
void map_grid2(Context& context, GLint un, double u1, double u2, GLint vn, double v1, double v2);
void eval_point1(Context& context, GLint i);
void eval_point2(Context& context, GLint i, GLint j);
void eval_mesh1(Context& context, GLenum mode, GLint i1, GLint i2);
void eval_mesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);

// 5.2 and 5.3 Selection and feedback
void init_names(Context& context);
void load_name(Context& context, GLuint name);
void push_name(Context& context, GLuint name);
void pop_name(Context& context);
GLint render_mode(Context& context, GLenum mode);
void select_buffer(Context& context, GLsizei size, GLuint* buffer);
void feedback_buffer(Context& context, GLsizei size, GLenum type, GLfloat* buffer);
void pass_through(Context& context, GLfloat token);

// 5.4 Display lists
void new_list(Context& context, GLuint list, GLenum mode);
void end_list(Context& context);
void call_list(Context& context, GLuint list);
void call_lists(Context& context, GLsizei n, GLenum type, const Numbers& names);
GLuint gen_lists(Context& context, GLsizei range);
GLboolean is_list(Context& context, GLuint list);
void delete_lists(Context& context, GLuint list, GLsizei range);
void list_base(Context& context, GLuint base);

// 5.5 Flush and Finish; 5.6 Hints
void flush(Context& context);
void finish(Context& context);
void hint(Context& context, GLenum target, GLenum mode);

// 6.1 Queries
void enable(Context& context, GLenum cap);
void disable(Context& context, GLenum cap);
GLboolean is_enabled(Context& context, GLenum cap);
void get_booleanv(Context& context, GLenum pname, GLboolean* params);
void get_integerv(Context& context, GLenum pname, GLint* params);
void get_floatv(Context& context, GLenum pname, GLfloat* params);
void get_doublev(Context& context, GLenum pname, GLdouble* params);
GLenum get_error(Context& context);
const GLubyte* get_string(Context& context, GLenum name);
void get_clip_plane(Context& context, GLenum plane, GLdouble* equation);
void get_lightfv(Context& context, GLenum light, GLenum pname, GLfloat* params);
void get_lightiv(Context& context, GLenum light, GLenum pname, GLint* params);
void get_materialfv(Context& context, GLenum face, GLenum pname, GLfloat* params);
void get_materialiv(Context& context, GLenum face, GLenum pname, GLint* params);
void get_tex_envfv(Context& context, GLenum target, GLenum pname, GLfloat* params);
void get_tex_enviv(Context& context, GLenum target, GLenum pname, GLint* params);
void get_tex_gendv(Context& context, GLenum coord, GLenum pname, GLdouble* params);
void get_tex_genfv(Context& context, GLenum coord, GLenum pname, GLfloat* params);
void get_tex_geniv(Context& context, GLenum coord, GLenum pname, GLint* params);
void get_tex_parameterfv(Context& context, GLenum target, GLenum pname, GLfloat* params);
void get_tex_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params);
void get_tex_level_parameterfv(Context& context, GLenum target, GLint level, GLenum pname,
                               GLfloat* params);
void get_tex_level_parameteriv(Context& context, GLenum target, GLint level, GLenum pname,
                               GLint* params);
void get_tex_image(Context& context, GLenum target, GLint level, GLenum format, GLenum type,
                   GLvoid* pixels);
void get_compressed_tex_image(Context& context, GLenum target, GLint level, GLvoid* memory);
void get_pixel_mapfv(Context& context, GLenum map, GLfloat* values);
void get_pixel_mapuiv(Context& context, GLenum map, GLuint* values);
void get_pixel_mapusv(Context& context, GLenum map, GLushort* values);
void get_mapdv(Context& context, GLenum target, GLenum query, GLdouble* v);
void get_mapfv(Context& context, GLenum target, GLenum query, GLfloat* v);
void get_mapiv(Context& context, GLenum target, GLenum query, GLint* v);
void get_polygon_stipple(Context& context, GLubyte* mask);
void get_pointerv(Context& context, GLenum pname, GLvoid** params);
void push_attrib(Context& context, GLbitfield mask);
void pop_attrib(Context& context);
void push_client_attrib(Context& context, GLbitfield mask);
void pop_client_attrib(Context& context);

}  // namespace execute
}  // namespace gw::gl
