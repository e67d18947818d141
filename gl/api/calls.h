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
void begin(Context& c, GLenum mode);
void end(Context& c);
void edge_flag(Context& c, GLboolean flag);

// 2.7 Vertices
void vertex(Context& c, float x, float y, float z, float w);
void tex_coord(Context& c, float s, float t, float r, float q);
void normal(Context& c, float x, float y, float z);
void color(Context& c, float red, float green, float blue, float alpha);
void index(Context& c, float value);

// 2.8 Vertex arrays
void vertex_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const GLvoid* pointer);
void normal_pointer(Context& c, GLenum type, GLsizei stride, const GLvoid* pointer);
void color_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const GLvoid* pointer);
void index_pointer(Context& c, GLenum type, GLsizei stride, const GLvoid* pointer);
void tex_coord_pointer(Context& c, GLint size, GLenum type, GLsizei stride, const GLvoid* pointer);
void edge_flag_pointer(Context& c, GLsizei stride, const GLvoid* pointer);
void enable_client_state(Context& c, GLenum array);
void disable_client_state(Context& c, GLenum array);
void interleaved_arrays(Context& c, GLenum format, GLsizei stride, const GLvoid* pointer);
void array_element(Context& c, GLint i);
/// Replays captured array elements: what a display list keeps of DrawArrays and DrawElements.
void play_elements(Context& c, const Elements& elements);
void draw_arrays(Context& c, GLenum mode, GLint first, GLsizei count);
void draw_elements(Context& c, GLenum mode, GLsizei count, GLenum type, const GLvoid* indices);
void draw_range_elements(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count,
                         GLenum type, const GLvoid* indices);

// 2.9 Rectangles
void rect(Context& c, double x1, double y1, double x2, double y2);

// 2.10 Coordinate transformations
void depth_range(Context& c, GLclampd near_value, GLclampd far_value);
void viewport(Context& c, GLint x, GLint y, GLsizei width, GLsizei height);
void matrix_mode(Context& c, GLenum mode);
void load_matrix(Context& c, const dmat4& m);
void mult_matrix(Context& c, const dmat4& m);
void load_identity(Context& c);
void rotate(Context& c, double angle, double x, double y, double z);
void translate(Context& c, double x, double y, double z);
void scale(Context& c, double x, double y, double z);
void frustum(Context& c, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
             GLdouble near_value, GLdouble far_value);
void ortho(Context& c, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
           GLdouble near_value, GLdouble far_value);
void push_matrix(Context& c);
void pop_matrix(Context& c);
void tex_gen(Context& c, GLenum coord, GLenum pname, const Params& params);
void clip_plane(Context& c, GLenum plane, const Params& equation);

// 2.12 Current raster position
void raster_pos(Context& c, double x, double y, double z, double w);
void window_pos(Context& c, double x, double y, double z);

// 2.13 Colours and lighting
void front_face(Context& c, GLenum mode);
void shade_model(Context& c, GLenum mode);
void light(Context& c, GLenum light, GLenum pname, const Params& params);
void light_model(Context& c, GLenum pname, const Params& params);
void color_material(Context& c, GLenum face, GLenum mode);
void material(Context& c, GLenum face, GLenum pname, const Params& params);

// 3.3 to 3.5 Points, lines and polygons
void point_size(Context& c, GLfloat size);
void line_width(Context& c, GLfloat width);
void line_stipple(Context& c, GLint factor, GLushort pattern);
void cull_face(Context& c, GLenum mode);
void polygon_stipple(Context& c, const Stipple& pattern);
void polygon_mode(Context& c, GLenum face, GLenum mode);
void polygon_offset(Context& c, GLfloat factor, GLfloat units);
/// GL_EXT_polygon_offset: the bias is a depth 0 .. 1.
void polygon_offset_ext(Context& c, GLfloat factor, GLfloat bias);

// 3.6 and 4.3 Pixel rectangles
void pixel_store(Context& c, GLenum pname, double param);
void pixel_transfer(Context& c, GLenum pname, double param);
void pixel_map(Context& c, GLenum map, GLsizei size, const Numbers& values);
void pixel_zoom(Context& c, GLfloat xfactor, GLfloat yfactor);
void draw_pixels(Context& c, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const HostImage& image);
void bitmap(Context& c, GLsizei width, GLsizei height, float xorig, float yorig, float xmove,
            float ymove, const HostImage& image);
void copy_pixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);
void read_pixels(Context& c, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, GLvoid* pixels);
void read_buffer(Context& c, GLenum mode);

// 3.8 Texturing
void tex_image_1d(Context& c, GLenum target, GLint level, GLint internal_format, GLsizei width,
                  GLint border, GLenum format, GLenum type, const HostImage& image);
void tex_image_2d(Context& c, GLenum target, GLint level, GLint internal_format, GLsizei width,
                  GLsizei height, GLint border, GLenum format, GLenum type, const HostImage& image);
void tex_sub_image_1d(Context& c, GLenum target, GLint level, GLint xoffset, GLsizei width,
                      GLenum format, GLenum type, const HostImage& image);
void tex_sub_image_2d(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                      GLsizei width, GLsizei height, GLenum format, GLenum type,
                      const HostImage& image);
void copy_tex_image_1d(Context& c, GLenum target, GLint level, GLenum internal_format, GLint x,
                       GLint y, GLsizei width, GLint border);
void copy_tex_image_2d(Context& c, GLenum target, GLint level, GLenum internal_format, GLint x,
                       GLint y, GLsizei width, GLsizei height, GLint border);
void copy_tex_sub_image_1d(Context& c, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                           GLsizei width);
void copy_tex_sub_image_2d(Context& c, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                           GLint x, GLint y, GLsizei width, GLsizei height);
void tex_parameter(Context& c, GLenum target, GLenum pname, const Params& params);
void tex_env(Context& c, GLenum target, GLenum pname, const Params& params);
void bind_texture(Context& c, GLenum target, GLuint texture);
void gen_textures(Context& c, GLsizei n, GLuint* textures);
void delete_textures(Context& c, GLsizei n, const GLuint* textures);
GLboolean is_texture(Context& c, GLuint texture);
GLboolean are_textures_resident(Context& c, GLsizei n, const GLuint* textures,
                                GLboolean* residences);
void prioritize_textures(Context& c, GLsizei n, const Numbers& textures, const Numbers& priorities);

// 3.9 Fog
void fog(Context& c, GLenum pname, const Params& params);

// 4.1 Per-fragment operations
void scissor(Context& c, GLint x, GLint y, GLsizei width, GLsizei height);
void alpha_func(Context& c, GLenum func, GLclampf ref);
void stencil_func(Context& c, GLenum func, GLint ref, GLuint mask);
void stencil_op(Context& c, GLenum fail, GLenum zfail, GLenum zpass);
void depth_func(Context& c, GLenum func);
void blend_func(Context& c, GLenum sfactor, GLenum dfactor);
void logic_op(Context& c, GLenum opcode);
void blend_color(Context& c, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
void blend_equation(Context& c, GLenum mode);

// 4.2 Whole framebuffer operations
void draw_buffer(Context& c, GLenum mode);
void index_mask(Context& c, GLuint mask);
void color_mask(Context& c, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
void depth_mask(Context& c, GLboolean flag);
void stencil_mask(Context& c, GLuint mask);
void clear(Context& c, GLbitfield mask);
void clear_color(Context& c, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
void clear_index(Context& c, GLfloat value);
void clear_depth(Context& c, GLclampd depth);
void clear_stencil(Context& c, GLint s);
void clear_accum(Context& c, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
void accum(Context& c, GLenum op, GLfloat value);

// 5.1 Evaluators
void map1(Context& c, GLenum target, double u1, double u2, GLint stride, GLint order,
          const Numbers& points);
void map2(Context& c, GLenum target, double u1, double u2, GLint ustride, GLint uorder, double v1,
          double v2, GLint vstride, GLint vorder, const Numbers& points);
void eval_coord1(Context& c, double u);
void eval_coord2(Context& c, double u, double v);
void map_grid1(Context& c, GLint un, double u1, double u2);
void map_grid2(Context& c, GLint un, double u1, double u2, GLint vn, double v1, double v2);
void eval_point1(Context& c, GLint i);
void eval_point2(Context& c, GLint i, GLint j);
void eval_mesh1(Context& c, GLenum mode, GLint i1, GLint i2);
void eval_mesh2(Context& c, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);

// 5.2 and 5.3 Selection and feedback
void init_names(Context& c);
void load_name(Context& c, GLuint name);
void push_name(Context& c, GLuint name);
void pop_name(Context& c);
GLint render_mode(Context& c, GLenum mode);
void select_buffer(Context& c, GLsizei size, GLuint* buffer);
void feedback_buffer(Context& c, GLsizei size, GLenum type, GLfloat* buffer);
void pass_through(Context& c, GLfloat token);

// 5.4 Display lists
void new_list(Context& c, GLuint list, GLenum mode);
void end_list(Context& c);
void call_list(Context& c, GLuint list);
void call_lists(Context& c, GLsizei n, GLenum type, const Numbers& names);
GLuint gen_lists(Context& c, GLsizei range);
GLboolean is_list(Context& c, GLuint list);
void delete_lists(Context& c, GLuint list, GLsizei range);
void list_base(Context& c, GLuint base);

// 5.5 Flush and Finish; 5.6 Hints
void flush(Context& c);
void finish(Context& c);
void hint(Context& c, GLenum target, GLenum mode);

// 6.1 Queries
void enable(Context& c, GLenum cap);
void disable(Context& c, GLenum cap);
GLboolean is_enabled(Context& c, GLenum cap);
void get_booleanv(Context& c, GLenum pname, GLboolean* params);
void get_integerv(Context& c, GLenum pname, GLint* params);
void get_floatv(Context& c, GLenum pname, GLfloat* params);
void get_doublev(Context& c, GLenum pname, GLdouble* params);
GLenum get_error(Context& c);
const GLubyte* get_string(Context& c, GLenum name);
void get_clip_plane(Context& c, GLenum plane, GLdouble* equation);
void get_lightfv(Context& c, GLenum light, GLenum pname, GLfloat* params);
void get_lightiv(Context& c, GLenum light, GLenum pname, GLint* params);
void get_materialfv(Context& c, GLenum face, GLenum pname, GLfloat* params);
void get_materialiv(Context& c, GLenum face, GLenum pname, GLint* params);
void get_tex_envfv(Context& c, GLenum target, GLenum pname, GLfloat* params);
void get_tex_enviv(Context& c, GLenum target, GLenum pname, GLint* params);
void get_tex_gendv(Context& c, GLenum coord, GLenum pname, GLdouble* params);
void get_tex_genfv(Context& c, GLenum coord, GLenum pname, GLfloat* params);
void get_tex_geniv(Context& c, GLenum coord, GLenum pname, GLint* params);
void get_tex_parameterfv(Context& c, GLenum target, GLenum pname, GLfloat* params);
void get_tex_parameteriv(Context& c, GLenum target, GLenum pname, GLint* params);
void get_tex_level_parameterfv(Context& c, GLenum target, GLint level, GLenum pname,
                               GLfloat* params);
void get_tex_level_parameteriv(Context& c, GLenum target, GLint level, GLenum pname, GLint* params);
void get_tex_image(Context& c, GLenum target, GLint level, GLenum format, GLenum type,
                   GLvoid* pixels);
void get_pixel_mapfv(Context& c, GLenum map, GLfloat* values);
void get_pixel_mapuiv(Context& c, GLenum map, GLuint* values);
void get_pixel_mapusv(Context& c, GLenum map, GLushort* values);
void get_mapdv(Context& c, GLenum target, GLenum query, GLdouble* v);
void get_mapfv(Context& c, GLenum target, GLenum query, GLfloat* v);
void get_mapiv(Context& c, GLenum target, GLenum query, GLint* v);
void get_polygon_stipple(Context& c, GLubyte* mask);
void get_pointerv(Context& c, GLenum pname, GLvoid** params);
void push_attrib(Context& c, GLbitfield mask);
void pop_attrib(Context& c);
void push_client_attrib(Context& c, GLbitfield mask);
void pop_client_attrib(Context& c);

}  // namespace execute
}  // namespace gw::gl
