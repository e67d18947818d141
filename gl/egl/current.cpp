#include "gl/egl/current.h"

#include "gl/context/thread_binding.h"
#include "gl/egl/failure.h"

#include <mutex>
#include <utility>

namespace gw::gl::egl {

namespace {

/// Guards the holders of contexts and surfaces. Never destroyed: programs call EGL from their own
/// exit handlers.
std::mutex& holder_mutex() {
    static auto* const mutex = new std::mutex;
    return *mutex;
}

template <class Held>
void check_is_free(const std::shared_ptr<Held>& held) {
    if (held && held->holder != nullptr && held->holder != &binding())
        throw Failure{EGL_BAD_ACCESS};
}

}  // namespace

void Binding::leave() {
    const std::lock_guard lock(holder_mutex());
    if (context) context->holder = nullptr;
    if (draw) draw->holder = nullptr;
    if (read) read->holder = nullptr;
    display = nullptr;
    context = nullptr;
    draw = read = nullptr;
}

Binding& binding() { return thread_binding<Binding>(); }

void release_current() {
    if (!binding().context) return;
    make_current(nullptr, nullptr);
    binding().leave();
}

void take_current(EglDisplay& display, std::shared_ptr<ClientContext> context,
                  std::shared_ptr<Surface> draw, std::shared_ptr<Surface> read) {
    Binding& own = binding();
    {
        const std::lock_guard lock(holder_mutex());
        check_is_free(context);
        check_is_free(draw);
        check_is_free(read);
        context->holder = &own;
        if (draw) draw->holder = &own;
        if (read) read->holder = &own;
    }
    const auto keep = [&](const auto& old, const auto&... now) {
        if (old && ((old != now) && ...)) old->holder = nullptr;
    };
    if (draw) draw->follow_window();
    if (read && read != draw) read->follow_window();
    make_current(&context->context, draw.get(), read.get());
    {
        const std::lock_guard lock(holder_mutex());
        keep(own.context, context);
        keep(own.draw, draw, read);
        keep(own.read, draw, read);
    }
    own.display = &display;
    own.context = std::move(context);
    own.draw = std::move(draw);
    own.read = std::move(read);
}

}  // namespace gw::gl::egl
