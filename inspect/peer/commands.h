// The commands of a list through OpenGL, and planes back to the host. Does not choose their order
// (player.h does) and does not make textures (textures.h does).
#pragma once

#include "gw/command_list.h"
#include "gw/planes.h"
#include "gw/profile.h"
#include "gw/state.h"
#include "inspect/peer/textures.h"

#include <GL/gl.h>

#include <vector>

namespace gw::peer {

/// Sets viewport, clip planes, culling, sizes, tests, blending and masks. Throws Error for state
/// that OpenGL cannot express here. `color_buffer`: where colours are drawn; GL_NONE: nowhere.
void apply(const State& state, int width, int height, GLenum color_buffer);

/// Factors found at the vertices go by way of a linear fog of distance 1 - f.
void apply(const FogState& fog, bool per_fragment, bool on);

/// Sets matrices and fog, and draws through glBegin and glEnd. `targets`: of the textures that are
/// bound.
void draw(const Draw& draw, const State& state, const Profile& profile, int width, int height,
          const TextureTargets& targets);

void clear(const Clear& command, float accum_scale);
void write(const WriteSpans& command);
void write(const WritePixels& command, const DepthState& depth);
/// Throws Error for colours with depths, and for bits with other values or a zoom: OpenGL has no
/// such rectangle.
void draw(const DrawPixels& command, const State& state, const TextureTargets& targets);
void copy(const Copy& command, const DepthState& depth);

/// OpenGL holds accumulated values in [-1, 1]; the machine counts units of the frame buffer. Weights
/// of Accum, Load and Add, and the values of clears, are divided by `accum_scale`; Return's weight is
/// multiplied by it. So as many pictures fit.
void accumulate(const Accumulate& command, float accum_scale);

/// R, G, B, A of all pixels, bottom row first.
std::vector<std::uint8_t> read_colors(int width, int height);
void replace_colors(int width, int height, const std::vector<std::uint8_t>& rgba);

/// Colour, depth and stencil.
Planes read_planes(int width, int height);

}  // namespace gw::peer
