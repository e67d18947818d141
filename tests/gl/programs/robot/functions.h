// GL's functions as a loader finds them, each by name from one function of the door. Nothing is linked.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <string>
#include <string_view>

namespace robot {

// clang-format off
#define ROBOT_FUNCTIONS(GW) \
    GW(AlphaFunc) GW(Begin) GW(BindTexture) GW(BlendFunc) GW(CallList) GW(Clear) GW(ClearColor) \
    GW(ClearDepth) GW(ClearStencil) GW(ClipPlane) GW(Color3f) GW(Color4f) GW(Color4ub) \
    GW(ColorMask) GW(ColorMaterial) GW(CullFace) GW(DeleteLists) GW(DeleteTextures) \
    GW(DepthFunc) GW(DepthMask) GW(Disable) GW(DisableClientState) GW(DrawBuffer) \
    GW(DrawElements) GW(Enable) GW(EnableClientState) GW(End) GW(EndList) GW(Finish) GW(Flush) \
    GW(Fogf) GW(Fogfv) GW(Fogi) GW(FrontFace) GW(Frustum) GW(GenLists) GW(GenTextures) \
    GW(GetError) GW(GetFloatv) GW(GetIntegerv) GW(GetString) GW(IsEnabled) GW(LightModelfv) \
    GW(LightModeli) GW(Lightf) GW(Lightfv) GW(LoadIdentity) GW(LoadMatrixf) GW(Materialf) \
    GW(Materialfv) GW(MatrixMode) GW(MultMatrixf) GW(NewList) GW(Normal3f) GW(NormalPointer) \
    GW(Ortho) GW(PixelStorei) GW(PolygonOffset) GW(PopMatrix) GW(PushMatrix) GW(ReadBuffer) \
    GW(ReadPixels) GW(Rotatef) GW(Scalef) GW(Scissor) GW(ShadeModel) GW(StencilFunc) \
    GW(StencilOp) GW(TexCoord2f) GW(TexCoordPointer) GW(TexEnvi) GW(TexGenfv) GW(TexGeni) \
    GW(TexImage2D) GW(TexParameteri) GW(Translatef) GW(Vertex3d) GW(Vertex3f) GW(VertexPointer) \
    GW(Viewport) GW(ActiveTexture) GW(GenBuffers) GW(DeleteBuffers) GW(BindBuffer) \
    GW(BufferData) GW(GenFramebuffers) GW(DeleteFramebuffers) GW(BindFramebuffer) \
    GW(GenRenderbuffers) GW(DeleteRenderbuffers) GW(BindRenderbuffer) GW(CheckFramebufferStatus) \
    GW(FramebufferRenderbuffer) GW(FramebufferTexture2D) GW(RenderbufferStorage) \
    GW(RenderbufferStorageMultisample) GW(GetRenderbufferParameteriv) GW(GenerateMipmap) \
    GW(BlitFramebuffer)
// clang-format on

/// gl.Begin(..) in place of glBegin(..).
struct Functions {
#define GW_MEMBER(name) decltype(&::gl##name) name = nullptr;
    ROBOT_FUNCTIONS(GW_MEMBER)
#undef GW_MEMBER
    decltype(&::glClipControl) ClipControl = nullptr;  ///< if it is offered
};
inline Functions gl;

/// Makes a context of the door "osmesa", "egl" or "glx" current: libraries are loaded globally, as
/// Python does. Ends the program with a message if there is none.
void open_door(const std::string& door);
/// Loads `gl` as such a program does: by eglGetProcAddress, OSMesaGetProcAddress or
/// glXGetProcAddressARB, the first that is a global symbol.
void load_functions();
[[noreturn]] void fail(std::string_view what);

/// Whether GL_EXTENSIONS has a word.
bool has_extension(std::string_view name);

}  // namespace robot
