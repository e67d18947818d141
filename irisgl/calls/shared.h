// Calls that several functions share: entry/functions.txt names them after =.
#pragma once

#include "irisgl/calls/values.h"

#include <cstdint>
#include <vector>

namespace gw::irisgl::calls {

void end_primitive();
void vertex(double x, double y, double z, double w);
void point(double x, double y, double z);
void move(double x, double y, double z);
void relative_move(double x, double y, double z);
void draw(double x, double y, double z);
void relative_draw(double x, double y, double z);
void polygon_move(double x, double y, double z);
void relative_polygon_move(double x, double y, double z);
void polygon_draw(double x, double y, double z);
void relative_polygon_draw(double x, double y, double z);
void polygon_close();
void polygon(long n, Values points, int dimensions, bool filled);
void shaded_polygon(long n, Values points, int dimensions, Values indices);
void rectangle(double x1, double y1, double x2, double y2, bool filled);
void circle(double x, double y, double radius, bool filled);
/// Angles in tenths of a degree, counter-clockwise.
void arc(double x, double y, double radius, double start, double end, bool filled);
void line_width(double width);
void point_size(double size);
void curve(long n, Values points, int dimensions);
void turn(double degrees, char axis);
void color_index(double index);
void rgb(float r, float g, float b, float a);
void rgb_bytes(double r, double g, double b);
void rgba_bytes(double r, double g, double b, double a);
void rgb_mode();
void set_dither(long mode);
void fog(long mode, Values params);
void setdepth(long near_, long far_);
void define_light(short kind, short index, Values props);
void normal(float x, float y, float z);
void texture_coordinate(float s, float t, float r, float q);
/// Pixels of the planes that readsource names, from the lower left: indices, or R lowest to A highest.
/// Empty: more pixels than there can be.
std::vector<std::uint32_t> read_rectangle(int left, int bottom, int width, int height);
/// Words of a cursor of the type that curstype has chosen.
long cursor_words();
long read_rgb(short n, RGBvalue* r, RGBvalue* g, RGBvalue* b);
void write_rgb(short n, RGBvalue* r, RGBvalue* g, RGBvalue* b);
void character_move(double x, double y, double z);
void bounding_box(long dx, long dy, double x1, double y1, double x2, double y2);

}  // namespace gw::irisgl::calls
