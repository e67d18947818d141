// libGL.so.1 and libOSMesa.so.8 in one process: the one without a current context asks the other.
#include "gl/context/context.h"
#include "gl/context/current.h"

#include "generated/gl/function_names.h"

#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <iterator>

namespace gw::gl {

/// What libraries must have in common to share a context. Those of one build have.
struct LibraryBuild {
    std::size_t context = sizeof(Context), drawable = sizeof(Drawable),
                functions = std::size(function_names);
    char compiler[64] = {};

    LibraryBuild() {
        const char* const version = __VERSION__;
        std::copy_n(version, std::min(sizeof compiler - 1, std::char_traits<char>::length(version)),
                    compiler);
    }
    bool operator==(const LibraryBuild&) const = default;
};

/// A library's answer.
struct LibraryAnswer {
    Context* context;
    bool calls_are_kept;
};

}  // namespace gw::gl

#pragma GCC visibility push(default)
extern "C" gw::gl::LibraryAnswer gw_current_context(const gw::gl::LibraryBuild& build) {
    if (!(build == gw::gl::LibraryBuild())) return {nullptr, false};
    return {gw::gl::current, gw::gl::calls_are_kept};
}
#pragma GCC visibility pop

namespace gw::gl {
namespace {

using Ask = LibraryAnswer (*)(const LibraryBuild&);

/// The function above in the other library; null: it is not loaded, or not ours.
Ask other_library() {
    for (const char* name : {"libGL.so.1", "libOSMesa.so.8"}) {
        void* const library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD);
        if (library == nullptr) continue;
        const auto found = reinterpret_cast<Ask>(dlsym(library, "gw_current_context"));
        if (found != nullptr && found != &gw_current_context) return found;
        dlclose(library);
    }
    return nullptr;
}

}  // namespace

Context* context_of_other_library() {
    static constinit std::atomic<Ask> known = nullptr;
    Ask ask = known.load(std::memory_order_acquire);
    if (ask == nullptr) {
        ask = other_library();
        if (ask == nullptr) return nullptr;
        known.store(ask, std::memory_order_release);
    }
    static const LibraryBuild build;
    const LibraryAnswer answer = ask(build);
    if (answer.calls_are_kept) calls_are_kept = true;
    return answer.context;
}

}  // namespace gw::gl
