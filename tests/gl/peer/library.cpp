#include "tests/gl/peer/library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace gw::gl_peer {

namespace {

/// Mesa's library does not export all of its functions.
template <class Function>
void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    const auto address =
        reinterpret_cast<decltype(&OSMesaGetProcAddress)>(dlsym(library, "OSMesaGetProcAddress"));
    if (function == nullptr && address != nullptr)
        function = reinterpret_cast<Function>(address(name));
    if (function == nullptr) throw std::runtime_error(std::string(name) + " is missing");
}

}  // namespace

Gl load(const std::string& path) {
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(dlerror());
    Gl gl;
#define GW_GL_FUNCTION(name) find(library, "gl" #name, gl.name);
#include "generated/gl/names.inc"
#undef GW_GL_FUNCTION
    find(library, "OSMesaCreateContextExt", gl.create_context);
    find(library, "OSMesaDestroyContext", gl.destroy_context);
    find(library, "OSMesaMakeCurrent", gl.make_current);
    return gl;
}

}  // namespace gw::gl_peer
