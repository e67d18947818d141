// Random groups of the pipeline's state that a profile allows. Suites choose the groups. Does not
// set the projection: frame.h does.
#pragma once

#include "conformance/generate/frame.h"
#include "gw/profile.h"
#include "gw/state.h"

namespace gw::conformance {

AlphaState any_alpha(Random& random);
BlendState any_blend(Random& random);
/// Every factor and equation that extensions bring too.
BlendState any_extended_blend(Random& random);
/// Every factor on both sides; alpha often has its own. Where alpha's are off, they are any.
BlendState any_separate_blend(Random& random);
LogicOpState any_logic_op(Random& random);
ColorMask any_color_mask(Random& random);
CullState any_cull(Random& random);
DepthState any_depth(Random& random);
DepthRangeState any_depth_range(Random& random);
JitterState any_jitter(Random& random, const Profile& profile);
LineStippleState any_dashes(Random& random);
PolygonOffsetState any_polygon_offset(Random& random, const Profile& profile);
ScissorState any_scissor(Random& random, int width, int height);
StencilState any_stencil(Random& random, const Profile& profile);
ViewportState any_viewport(Random& random, int width, int height);
/// Clip planes in the eye space of `frame`, near the middle of the picture.
void any_clip_planes(Random& random, const Frame& frame, State& state);

/// Fog for eye distances from 0 to about `depth`.
FogState any_fog(Random& random, double depth);
LightingState any_lighting(Random& random);
/// Filters, wraps, environment; no generated coordinates.
TextureState any_texture_state(Random& random);
/// Every function of TexEnv::Combine.
void any_combine(Random& random, TextureState& state);
/// Every wrap, and levels.
TextureState any_later_texture_state(Random& random);

/// 0 .. 1, often 0 or 1, seldom outside.
float any_fraction(Random& random);
vec4 any_color(Random& random);

}  // namespace gw::conformance
