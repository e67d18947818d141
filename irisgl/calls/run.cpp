#include "irisgl/calls/run.h"

#include "gl/context/current.h"
#include "irisgl/window/window.h"

#include <memory>
#include <string>

namespace gw::irisgl {

void report_no_window(const char* function) {
    warn(std::string(function) + ": no window is open; expected winopen before it; it is ignored");
}

// A call inside of another, as charstr inside of fmprstr, is a part of it.
void CallScope::begin(const char* function, const void* source) {
    if (gl::outer_call != nullptr) return;
    Window* const window = program().current;
    place_ = {window != nullptr ? window->count_call() : 0, function, source, nullptr};
    gl::outer_call = &place_;
    began_ = true;
}

void CallScope::end() { gl::outer_call = nullptr; }

ObjectScope::ObjectScope(Object name) : outer_(gl::outer_call) {
    if (outer_ == nullptr) return;
    place_.list = std::make_shared<const gl::PlayedList>(gl::PlayedList{GLuint(name), *outer_});
    gl::outer_call = &place_;
}

ObjectScope::~ObjectScope() { gl::outer_call = outer_; }

void ObjectScope::at(std::size_t number, const char* function) {
    place_.number = std::uint32_t(number);
    place_.function = function;
}

long left_out(const char* function, const char* reason) {
    warn(std::string(function) + " is not offered: " + reason + "; it does nothing");
    return 0;
}

}  // namespace gw::irisgl
