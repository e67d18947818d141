// The dynamic linker's part.
#include "inspect/peer/functions.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace gw::peer {
namespace {

void* library() {
    void* handle = dlopen(GW_OSMESA_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw Error(fmt::format("Mesa's OSMesa is needed here: {}", dlerror()));
    return handle;
}

/// The address of a function, as the type that it has.
template <typename Function>
void find(void* handle, const char* name, Function& out) {
    void* address = dlsym(handle, name);
    if (!address) throw Error(fmt::format("{} has no function {}", GW_OSMESA_LIBRARY, name));
    out = reinterpret_cast<Function>(address);
}

// NOLINTNEXTLINE(readability-function-size): a table
Functions load() {
    void* handle = library();
    Functions f{};
#define GW_FIND(name) find(handle, "gl" #name, f.name);
    GW_OPENGL_FUNCTIONS(GW_FIND)
#undef GW_FIND
#define GW_FIND(name) find(handle, #name, f.name);
    GW_OSMESA_FUNCTIONS(GW_FIND)
#undef GW_FIND
    return f;
}

}  // namespace

const Functions& gl() {
    static const Functions functions = load();
    return functions;
}

}  // namespace gw::peer
