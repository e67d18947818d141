// GetProcAddress: functions of GL and of GLX by name. [GLX 1.4] 3.3.12
#include "gl/glx/glx.h"

#include "gl/entry/entry_points.h"

#include <cstring>

namespace {

using gw::gl::Address;

struct Named {
    const char* name;
    Address address;
};

template <class Function>
Named named(const char* name, Function* function) {
    return {name, reinterpret_cast<Address>(function)};
}

const Named glx_functions[] = {
    named("glXChooseFBConfig", &glXChooseFBConfig),
    named("glXChooseFBConfigSGIX", &glXChooseFBConfigSGIX),
    named("glXChooseVisual", &glXChooseVisual),
    named("glXCopyContext", &glXCopyContext),
    named("glXCreateContext", &glXCreateContext),
    named("glXCreateContextAttribsARB", &glXCreateContextAttribsARB),
    named("glXCreateContextWithConfigSGIX", &glXCreateContextWithConfigSGIX),
    named("glXCreateGLXPixmap", &glXCreateGLXPixmap),
    named("glXCreateGLXPixmapWithConfigSGIX", &glXCreateGLXPixmapWithConfigSGIX),
    named("glXCreateNewContext", &glXCreateNewContext),
    named("glXCreatePbuffer", &glXCreatePbuffer),
    named("glXCreatePixmap", &glXCreatePixmap),
    named("glXCreateWindow", &glXCreateWindow),
    named("glXDestroyContext", &glXDestroyContext),
    named("glXDestroyGLXPixmap", &glXDestroyGLXPixmap),
    named("glXDestroyPbuffer", &glXDestroyPbuffer),
    named("glXDestroyPixmap", &glXDestroyPixmap),
    named("glXDestroyWindow", &glXDestroyWindow),
    named("glXGetClientString", &glXGetClientString),
    named("glXGetConfig", &glXGetConfig),
    named("glXGetCurrentContext", &glXGetCurrentContext),
    named("glXGetCurrentDisplay", &glXGetCurrentDisplay),
    named("glXGetCurrentDrawable", &glXGetCurrentDrawable),
    named("glXGetCurrentReadDrawable", &glXGetCurrentReadDrawable),
    named("glXGetCurrentReadDrawableSGI", &glXGetCurrentReadDrawableSGI),
    named("glXGetFBConfigAttrib", &glXGetFBConfigAttrib),
    named("glXGetFBConfigAttribSGIX", &glXGetFBConfigAttribSGIX),
    named("glXGetFBConfigFromVisualSGIX", &glXGetFBConfigFromVisualSGIX),
    named("glXGetFBConfigs", &glXGetFBConfigs),
    named("glXGetProcAddress", &glXGetProcAddress),
    named("glXGetProcAddressARB", &glXGetProcAddressARB),
    named("glXGetSelectedEvent", &glXGetSelectedEvent),
    named("glXGetVisualFromFBConfig", &glXGetVisualFromFBConfig),
    named("glXGetVisualFromFBConfigSGIX", &glXGetVisualFromFBConfigSGIX),
    named("glXIsDirect", &glXIsDirect),
    named("glXMakeContextCurrent", &glXMakeContextCurrent),
    named("glXMakeCurrent", &glXMakeCurrent),
    named("glXMakeCurrentReadSGI", &glXMakeCurrentReadSGI),
    named("glXQueryContext", &glXQueryContext),
    named("glXQueryCurrentRendererIntegerMESA", &glXQueryCurrentRendererIntegerMESA),
    named("glXQueryCurrentRendererStringMESA", &glXQueryCurrentRendererStringMESA),
    named("glXQueryDrawable", &glXQueryDrawable),
    named("glXQueryExtension", &glXQueryExtension),
    named("glXQueryExtensionsString", &glXQueryExtensionsString),
    named("glXQueryRendererIntegerMESA", &glXQueryRendererIntegerMESA),
    named("glXQueryRendererStringMESA", &glXQueryRendererStringMESA),
    named("glXQueryServerString", &glXQueryServerString),
    named("glXQueryVersion", &glXQueryVersion),
    named("glXSelectEvent", &glXSelectEvent),
    named("glXSwapBuffers", &glXSwapBuffers),
    named("glXUseXFont", &glXUseXFont),
    named("glXWaitGL", &glXWaitGL),
    named("glXWaitX", &glXWaitX),
};

Address find(const GLubyte* text) {
    const char* const name = reinterpret_cast<const char*>(text);
    if (name == nullptr) return nullptr;
    for (const Named& function : glx_functions)
        if (std::strcmp(function.name, name) == 0) return function.address;
    return gw::gl::find_entry_point(name);
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

__GLXextFuncPtr glXGetProcAddress(const GLubyte* name) { return find(name); }
__GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) { return find(name); }

}  // extern "C"
#pragma GCC visibility pop
