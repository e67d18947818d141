// The functions of OpenGL and OSMesa that we call, and OpenGL's words for ours: one table per
// concept. Mesa, and the compiler that it brings, are loaded by the first call.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

// clang-format off
#define GW_OPENGL_FUNCTIONS(X) \
    X(Accum) X(AlphaFunc) X(Begin) X(BindTexture) X(Bitmap) X(BlendColor) X(BlendEquation) X(BlendFunc) X(Clear) X(ClearAccum) X(ClearColor) \
    X(ClearDepth) X(ClearStencil) X(ClipPlane) X(Color4ub) X(Color4ubv) X(ColorMask) X(CopyPixels) \
    X(CopyTexImage2D) X(CullFace) X(DepthFunc) X(DepthMask) X(DepthRange) X(Disable) X(DrawBuffer) X(DrawPixels) \
    X(EdgeFlag) X(Enable) X(End) X(FogCoordd) X(Fogf) X(Fogfv) X(Fogi) X(FrontFace) X(GenTextures) \
    X(GetError) X(GetIntegerv) X(GetString) X(LineStipple) X(LineWidth) X(LogicOp) X(LoadIdentity) X(LoadMatrixd) X(MatrixMode) \
    X(PixelStorei) X(PixelZoom) X(PointSize) X(PolygonMode) X(PolygonOffset) X(PolygonStipple) X(PopAttrib) X(PushAttrib) X(ReadPixels) \
    X(Scissor) X(ShadeModel) X(StencilFuncSeparate) X(StencilMaskSeparate) X(StencilOpSeparate) \
    X(TexCoord4d) X(TexEnvfv) X(TexEnvi) X(TexImage2D) X(TexParameterfv) X(TexParameteri) X(Vertex4f) X(Viewport) \
    X(WindowPos2i) X(WindowPos3d)
// clang-format on
#define GW_OSMESA_FUNCTIONS(X) \
    X(OSMesaCreateContextAttribs) X(OSMesaDestroyContext) X(OSMesaMakeCurrent)

namespace gw::peer {

/// glName is `Name`; OSMesa's keep their names.
struct Functions {
// NOLINTBEGIN(bugprone-macro-parentheses): a declaration's name takes no parentheses
#define GW_DECLARE(name) decltype(&::gl##name) name;
    GW_OPENGL_FUNCTIONS(GW_DECLARE)
#undef GW_DECLARE
#define GW_DECLARE(name) decltype(&::name) name;
    GW_OSMESA_FUNCTIONS(GW_DECLARE)
#undef GW_DECLARE
    // NOLINTEND(bugprone-macro-parentheses)
};

/// Loads OSMesa the first time. Throws Error if it is not installed, or lacks a function.
const Functions& gl();

GLenum token(CompareFunc func);
GLenum token(StencilOp op);
GLenum token(BlendFactor factor);
GLenum token(BlendEquation equation);
GLenum token(LogicOp op);
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
