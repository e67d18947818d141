#include "gl/context/call_trace.h"

#include "gl/context/context.h"
#include "gl/context/current.h"

#include <utility>

namespace gw::gl {

constinit std::atomic<bool> calls_are_kept = false;

void keep_call(Function function, const void* source) {
    if (current != nullptr) current->calls.now = {current->calls.next++, function, source, nullptr};
}

PlayedListScope::PlayedListScope(CallTrace& calls, GLuint name) : calls_(calls) {
    if (!calls_are_kept) return;
    outer_ = std::exchange(calls_.list,
                           std::make_shared<const PlayedList>(PlayedList{name, calls_.now}));
}

PlayedListScope::~PlayedListScope() {
    if (!calls_are_kept || !calls_.list) return;
    calls_.now = calls_.list->caller;
    calls_.list = std::move(outer_);
}

}  // namespace gw::gl
