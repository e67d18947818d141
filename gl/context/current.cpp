#include "gl/context/current.h"

#include "gl/context/context.h"

namespace gw::gl {

constinit thread_local Context* current = nullptr;

void keep_call(Function function, const void* source) {
    if (current != nullptr) current->calls.now = {current->calls.next++, function, source, nullptr};
}

}  // namespace gw::gl
