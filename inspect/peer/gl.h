// The functions of OpenGL that we call, of whichever implementation is in use. library.h loads
// implementations.
#pragma once

#include "gw/describe/opengl.h"

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES  // declares the functions of later versions
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <string>
#include <string_view>

// clang-format off
/// OpenGL 1.1
#define GW_OPENGL_FUNCTIONS(X) \
    X(Accum) X(AlphaFunc) X(Begin) X(BindTexture) X(Bitmap) X(BlendFunc) X(Clear) X(ClearAccum) X(ClearColor) \
    X(ClearDepth) X(ClearStencil) X(ClipPlane) X(Color4ub) X(Color4ubv) X(ColorMask) X(CopyPixels) \
    X(CopyTexImage2D) X(CullFace) X(DepthFunc) X(DepthMask) X(DepthRange) X(Disable) X(DrawBuffer) X(DrawPixels) \
    X(EdgeFlag) X(Enable) X(End) X(Fogf) X(Fogfv) X(Fogi) X(FrontFace) X(GenTextures) X(DeleteTextures) X(GetBooleanv) \
    X(GetError) X(GetIntegerv) X(GetString) X(LineStipple) X(LineWidth) X(LogicOp) X(LoadIdentity) X(LoadMatrixd) X(MatrixMode) \
    X(PixelStorei) X(PixelZoom) X(PointSize) X(PolygonMode) X(PolygonOffset) X(PolygonStipple) X(PopAttrib) X(PushAttrib) X(ReadBuffer) \
    X(ReadPixels) X(Scissor) X(ShadeModel) X(StencilFunc) X(StencilMask) X(StencilOp) \
    X(TexCoord4d) X(TexEnvf) X(TexEnvfv) X(TexEnvi) X(TexImage1D) X(TexImage2D) X(TexParameterf) X(TexParameterfv) X(TexParameteri) X(Vertex4f) X(Viewport)
/// Of later versions: name, version, the extension that has it too, and the name's end there.
#define GW_LATER_FUNCTIONS(X) \
    X(BlendColor, 14, "GL_EXT_blend_color", "EXT") X(BlendEquation, 14, "GL_EXT_blend_minmax", "EXT") \
    X(FogCoordd, 14, "GL_EXT_fog_coord", "EXT") X(WindowPos2i, 14, "GL_ARB_window_pos", "ARB") X(WindowPos3d, 14, "GL_ARB_window_pos", "ARB") \
    X(ClipControl, 45, "GL_ARB_clip_control", "") X(SecondaryColor3ubv, 14, "GL_EXT_secondary_color", "EXT") \
    X(PointParameterfv, 14, "GL_ARB_point_parameters", "ARB") \
    X(StencilFuncSeparate, 20, "", "") X(StencilMaskSeparate, 20, "", "") X(StencilOpSeparate, 20, "", "") \
    X(ActiveTexture, 13, "GL_ARB_multitexture", "ARB") X(MultiTexCoord4d, 13, "GL_ARB_multitexture", "ARB") \
    X(TexImage3D, 12, "GL_EXT_texture3D", "EXT") X(SampleCoverage, 13, "GL_ARB_multisample", "ARB") \
    X(BlendFuncSeparate, 14, "GL_EXT_blend_func_separate", "EXT") \
    X(BlendEquationSeparate, 20, "GL_EXT_blend_equation_separate", "EXT") \
    X(GenQueries, 15, "GL_ARB_occlusion_query", "ARB") X(BeginQuery, 15, "GL_ARB_occlusion_query", "ARB") \
    X(EndQuery, 15, "GL_ARB_occlusion_query", "ARB") X(GetQueryObjectuiv, 15, "GL_ARB_occlusion_query", "ARB") \
    X(GenFramebuffers, 30, "GL_ARB_framebuffer_object", "") X(DeleteFramebuffers, 30, "GL_ARB_framebuffer_object", "") \
    X(BindFramebuffer, 30, "GL_ARB_framebuffer_object", "") X(BlitFramebuffer, 30, "GL_ARB_framebuffer_object", "") \
    X(CheckFramebufferStatus, 30, "GL_ARB_framebuffer_object", "") \
    X(FramebufferTexture2D, 30, "GL_ARB_framebuffer_object", "") X(FramebufferRenderbuffer, 30, "GL_ARB_framebuffer_object", "") \
    X(GenRenderbuffers, 30, "GL_ARB_framebuffer_object", "") X(DeleteRenderbuffers, 30, "GL_ARB_framebuffer_object", "") \
    X(BindRenderbuffer, 30, "GL_ARB_framebuffer_object", "") \
    X(RenderbufferStorageMultisample, 30, "GL_ARB_framebuffer_object", "")
// clang-format on

namespace gw::peer {

/// glName is `Name`.
struct Functions {
// NOLINTBEGIN(bugprone-macro-parentheses): a declaration's name takes no parentheses
#define GW_DECLARE(name) decltype(&::gl##name) name = nullptr;
    GW_OPENGL_FUNCTIONS(GW_DECLARE)
#undef GW_DECLARE
/// Null if the implementation has neither the version nor the extension.
#define GW_DECLARE(name, version, extension, end) decltype(&::gl##name) name = nullptr;
    GW_LATER_FUNCTIONS(GW_DECLARE)
#undef GW_DECLARE
    // NOLINTEND(bugprone-macro-parentheses)

    int version = 11;                ///< of OpenGL, times 10
    std::string extensions;          ///< with a space before and after each
    GLenum color_buffer = GL_FRONT;  ///< the window's one that is drawn to

    /// Whether it has a feature by its version or by an extension.
    bool offers(int since, std::string_view extension) const;
};

/// Of the implementation whose context was made current last (library.h).
const Functions& gl();
void use(const Functions& functions);

/// Throws Error: the implementation lacks what a feature of the list needs.
[[noreturn]] void refuse(const char* needed, const char* feature);

/// The function, for a feature of the list. Refuses the feature if there is none.
template <typename Function>
Function required(Function function, const char* name, const char* feature) {
    if (!function) refuse(name, feature);
    return function;
}

/// Refuses a feature that it does not offer.
void require(int since, const char* extension, const char* feature);

/// OpenGL's word for ours.
template <typename Enum>
GLenum token(Enum value) {
    return opengl_word(value).number;
}

/// glEnable or glDisable.
void enable(GLenum capability, bool on);

}  // namespace gw::peer
