#include "irisgl/state/objects.h"

#include <utility>

namespace gw::irisgl {

void OpenObject::add(Call call) {
    auto& calls = list->calls;
    if (replaced > 0 && at < calls.size()) {
        calls[at] = std::move(call);
        --replaced;
    } else {
        for (auto& [tag, place] : list->tags)
            if (place > at) ++place;
        calls.insert(calls.begin() + std::ptrdiff_t(at), std::move(call));
    }
    ++at;
}

}  // namespace gw::irisgl
