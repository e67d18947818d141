#include "inspect/peer/surface.h"

#include "gw/error.h"
#include "inspect/peer/loaded.h"

namespace gw::peer {
namespace {

std::string path_of(const std::string& implementation) {
    if (implementation == "osmesa") return GW_OSMESA_LIBRARY;
    if (implementation == "gl") return "libGL.so.1";
    return implementation;
}

}  // namespace

std::unique_ptr<Surface> make_surface(const std::string& implementation, int width, int height) {
    const Loaded loaded(path_of(implementation));
    if (loaded.exports("OSMesaMakeCurrent")) return make_osmesa(loaded, width, height);
    if (loaded.exports("glXMakeContextCurrent")) return make_glx(loaded, width, height);
    throw Error(loaded.path() +
                " is no OpenGL: it has neither OSMesaMakeCurrent nor glXMakeContextCurrent");
}

}  // namespace gw::peer
