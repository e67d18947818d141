#include "apps/view/window.h"

#include "gw/error.h"

#include <dlfcn.h>

namespace gw::apps {

std::unique_ptr<Window> open_window(const std::string& title, int width, int height) {
    void* module = dlopen("libgw_window.so", RTLD_LAZY | RTLD_LOCAL);
    const void* open = module ? dlsym(module, "gw_open_window") : nullptr;
    if (!open) throw Error(std::string("gw view needs the module ") + dlerror());
    return (*static_cast<const OpenWindow*>(open))(title, width, height);
}

}  // namespace gw::apps
