#include "gl/glx/current.h"

#include "gl/context/thread_binding.h"
#include "gl/x11/extension.h"

#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>
#include <utility>

__GLXcontextRec::__GLXcontextRec(Display* of, const gw::gl::glx::Config& with,
                                 std::shared_ptr<gw::gl::Shared> shared)
    : display(of),
      config(with),
      name(gw::gl::x11::new_name(of)),
      context(gw::gl::settings().profile, std::move(shared)) {
    if (!config.double_buffered) return;
    // [GL11] tables 6.15 and 6.17: the back buffer, if there is one.
    context.state.color_buffer.draw_buffer = context.state.pixel.read_buffer = GL_BACK;
}

namespace gw::gl::glx {

namespace {

struct Contexts {
    std::mutex mutex;
    std::map<GLXContext, std::unique_ptr<__GLXcontextRec>> kept;
};

/// Never destroyed: programs call GLX from their own exit handlers.
Contexts& contexts() {
    static auto* const all = new Contexts;
    return *all;
}

std::atomic<bool> exit_has_begun = false;

void leave_context(GLXContext context) {
    const std::lock_guard lock(contexts().mutex);
    context->is_current = false;
    if (context->is_destroyed) contexts().kept.erase(context);
}

}  // namespace

void Current::leave() { leave_context(context); }

Current& current_binding() { return thread_binding<Current>(); }

bool has_exit_begun() { return exit_has_begun; }

GLXContext keep_context(std::unique_ptr<__GLXcontextRec> context) {
    [[maybe_unused]] static const int registered = std::atexit([] { exit_has_begun = true; });
    const std::lock_guard lock(contexts().mutex);
    const GLXContext name = context.get();
    contexts().kept[name] = std::move(context);
    return name;
}

bool is_context(GLXContext context) {
    const std::lock_guard lock(contexts().mutex);
    const auto found = contexts().kept.find(context);
    if (found == contexts().kept.end()) return false;
    return !found->second->is_destroyed || current_binding().context == context;
}

void destroy_context(GLXContext context) {
    const std::lock_guard lock(contexts().mutex);
    if (context->is_current)
        context->is_destroyed = true;
    else
        contexts().kept.erase(context);
}

bool take_context(GLXContext context) {
    const std::lock_guard lock(contexts().mutex);
    if (current_binding().context == context) return true;
    if (context->is_current) return false;
    context->is_current = true;
    return true;
}

void release_current() {
    Current& binding = current_binding();
    if (binding.context == nullptr) return;
    make_current(nullptr, nullptr);
    const GLXContext left = binding.context;
    binding.display = nullptr;
    binding.context = nullptr;
    binding.draw_name = binding.read_name = 0;
    binding.draw = binding.read = nullptr;
    leave_context(left);
}

}  // namespace gw::gl::glx
