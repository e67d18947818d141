// OpenGL's header, and its words for ours: one table per concept.
#pragma once

#include "gw/command_list.h"
#include "inspect/peer/functions.h"

namespace gw::peer {

GLenum token(CompareFunc func);
GLenum token(StencilOp op);
GLenum token(BlendFactor factor);
GLenum token(Face face);
GLenum token(PolygonMode mode);
GLenum token(FogMode mode);
GLenum token(MinFilter filter);
GLenum token(MagFilter filter);
GLenum token(Wrap wrap);
GLenum token(TexEnv env);
GLenum token(AccumOp op);

/// glEnable or glDisable.
void enable(GLenum capability, bool on);

}  // namespace gw::peer
