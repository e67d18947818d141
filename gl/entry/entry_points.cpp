#include "gl/entry/entry_points.h"

#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/drawable/settings.h"
#include "gw/base/leaked_static.h"

#include <string_view>
#include <unordered_map>

namespace gw::gl {

Address find_entry_point(const char* name) {
    static const auto& table = leaked_static([] {
        std::unordered_map<std::string_view, Address> addresses;
        for (const EntryPoint& point : entry_points())
            if (is_offered(point.offer, settings().profile, settings().version))
                addresses[point.name] = point.address;
        return addresses;
    }());
    const auto found = name != nullptr ? table.find(name) : table.end();
    return found != table.end() ? found->second : nullptr;
}

std::intptr_t not_offered() {
    if (Context* const context = bound_context()) set_error(*context, GL_INVALID_OPERATION);
    return 0;
}

}  // namespace gw::gl
