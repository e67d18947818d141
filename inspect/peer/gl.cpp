#include "inspect/peer/gl.h"

#include "gw/error.h"

#include <fmt/format.h>

namespace gw::peer {
namespace {

thread_local const Functions* in_use = nullptr;

}  // namespace

const Functions& gl() { return *in_use; }
void use(const Functions& functions) { in_use = &functions; }

void refuse(const char* needed, const char* feature) {
    throw Error(fmt::format("{}: needs {}; this OpenGL has version {}.{} and no such extension",
                            feature, needed, gl().version / 10, gl().version % 10));
}

bool Functions::offers(int since, std::string_view extension) const {
    return version >= since || extensions.find(fmt::format(" {} ", extension)) != std::string::npos;
}

void require(int since, const char* extension, const char* feature) {
    if (!gl().offers(since, extension)) refuse(extension, feature);
}

void enable(GLenum capability, bool on) { on ? gl().Enable(capability) : gl().Disable(capability); }

}  // namespace gw::peer
