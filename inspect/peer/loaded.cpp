#include "inspect/peer/loaded.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <dlfcn.h>
#include <cstdlib>

namespace gw::peer {
namespace {

const char* string_of(const Functions& f, GLenum name) {
    const GLubyte* const found = f.GetString(name);
    return found ? reinterpret_cast<const char*>(found) : "";
}

/// "3.1 Mesa": 31
int version_of(const Functions& f) {
    char* end = nullptr;
    const char* const words = string_of(f, GL_VERSION);
    const long major = std::strtol(words, &end, 10);
    return int(10 * major + (*end == '.' ? std::strtol(end + 1, nullptr, 10) : 0));
}

void check_planes(const Functions& f, const std::string& path) {
    GLint red = 0, depth = 0, stencil = 0;
    f.GetIntegerv(GL_RED_BITS, &red);
    f.GetIntegerv(GL_DEPTH_BITS, &depth);
    f.GetIntegerv(GL_STENCIL_BITS, &stencil);
    if (red == 8 && depth == 24 && stencil == 8) return;
    throw Error(
        fmt::format("{}: its planes have {} colour, {} depth and {} stencil bits; expected "
                    "8, 24 and 8",
                    path, red, depth, stencil));
}

}  // namespace

Loaded::Loaded(std::string path)
    : path_(std::move(path)), handle_(dlopen(path_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw Error(fmt::format("cannot load an OpenGL: {}", dlerror()));
}

bool Loaded::exports(const char* name) const { return dlsym(handle_, name) != nullptr; }

void* Loaded::find(const char* name) const {
    if (void* const found = dlsym(handle_, name)) return found;
    using GetProcAddress = void* (*)(const char*);
    for (const char* const look_up : {"OSMesaGetProcAddress", "glXGetProcAddressARB"})
        if (void* const function = dlsym(handle_, look_up))
            return reinterpret_cast<GetProcAddress>(function)(name);
    return nullptr;
}

void* Loaded::address(const char* name) const {
    void* const found = find(name);
    if (!found) throw Error(fmt::format("{} has no function {}", path_, name));
    return found;
}

// NOLINTNEXTLINE(readability-function-size): a table
Functions Loaded::functions() const {
    Functions f;
#define GW_FIND(name) get("gl" #name, f.name);
    GW_OPENGL_FUNCTIONS(GW_FIND)
#undef GW_FIND
    return f;
}

void Loaded::complete(Functions& f) const {
    f.version = version_of(f);
    f.extensions = fmt::format(" {} ", string_of(f, GL_EXTENSIONS));
    GLboolean has_back = GL_FALSE;
    f.GetBooleanv(GL_DOUBLEBUFFER, &has_back);
    f.color_buffer = has_back ? GL_BACK : GL_FRONT;
    check_planes(f, path_);
#define GW_FIND(name, since, extension, end) \
    if (f.version >= (since))                \
        get("gl" #name, f.name);             \
    else if (f.offers(since, extension))     \
        get("gl" #name end, f.name);
    GW_LATER_FUNCTIONS(GW_FIND)
#undef GW_FIND
}

}  // namespace gw::peer
