#include "gl/context/context.h"

#include "gl/context/current.h"

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>

namespace gw::gl {

constinit thread_local Context* current = nullptr;
constinit thread_local const CallPlace* outer_call = nullptr;

void keep_call(Function function, const void* source) {
    Context* const context = bound_context();
    if (context == nullptr) return;
    if (outer_call != nullptr)
        context->calls.now = *outer_call;
    else
        context->calls.now = {context->calls.next++, name_of(function), source, nullptr};
}

Context::Context(const Profile& of, std::shared_ptr<Shared> with)
    : profile(of), shared(with ? std::move(with) : std::make_shared<Shared>()) {
    validate(profile);
}

void set_error(Context& context, GLenum error) {
    if (context.error == GL_NO_ERROR) context.error = error;
}

void report_exception(Context& context) {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        set_error(context, GL_OUT_OF_MEMORY);
    } catch (const std::length_error&) {
        set_error(context, GL_OUT_OF_MEMORY);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gw: %s\n", error.what());
    }
}

}  // namespace gw::gl
